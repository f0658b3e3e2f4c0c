// SPDX-License-Identifier: GPL-3.0-or-later
// Linked behind the firmware: its variables lie before these.
char firmware_data_end[8] = {1};
char firmware_bss_end[8];
