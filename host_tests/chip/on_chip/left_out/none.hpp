// SPDX-License-Identifier: GPL-3.0-or-later
// Rows of LEFT_OUT(suite, name, why): tests of this library that do not run on the chip.
// clang-format off
