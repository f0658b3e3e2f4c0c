// SPDX-License-Identifier: GPL-3.0-or-later
// Linked before the firmware: its variables lie behind these.
char firmware_data_begin[8] = {1};
char firmware_bss_begin[8];
