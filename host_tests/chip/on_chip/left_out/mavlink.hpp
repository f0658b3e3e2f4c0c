// SPDX-License-Identifier: GPL-3.0-or-later
// What takes minutes of the chip.
// clang-format off
LEFT_OUT(Parser, takes_nothing_in_a_signature_for_a_frame, "20,000 rounds")
LEFT_OUT(Parser, loses_no_good_frame_in_noise, "20,000 rounds")
