// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace avr {

// Begins anew through address 0, for a board whose bootloader does not survive a watchdog's reset.
[[noreturn]] void restart();

}  // namespace avr
