// SPDX-License-Identifier: GPL-3.0-or-later
// What takes minutes of the chip.
// clang-format off
LEFT_OUT(Sequencer, random_missions_of_both_sets_never_hang_and_every_poll_is_bounded, "thousands of missions")
