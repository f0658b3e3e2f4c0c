// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace board {

// A set of all its channels every millisecond from now on.
void converterStart();

}  // namespace board
