// SPDX-License-Identifier: GPL-3.0-or-later
// What takes more than half a minute of the chip.
// clang-format off
LEFT_OUT(JournalTest, a_power_cut_at_any_byte_leaves_the_old_or_the_new_value, "2,500 power cuts")
LEFT_OUT(IndexStoreTest, any_changed_bit_leaves_the_index_or_is_reported_once, "every bit, 90 times")
LEFT_OUT(IndexStoreTest, a_worn_cell_leaves_the_index_or_is_reported, "every bit held, 90 times")
LEFT_OUT(IndexStoreTest, a_power_cut_at_any_byte_leaves_the_old_or_the_new_index, "2,500 power cuts")
LEFT_OUT(MissionStoreTest, the_last_of_65600_heads_counts, "32,800 uploads")
