// SPDX-License-Identifier: GPL-3.0-or-later
// clang-format off
LEFT_OUT(Gone, long_ago, "it was renamed")
