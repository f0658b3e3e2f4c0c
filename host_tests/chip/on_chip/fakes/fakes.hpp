// SPDX-License-Identifier: GPL-3.0-or-later
// Those doubles of the hardware that the pure libraries' tests want, on the chip. Found before the
// host's header of this name.
#pragma once
#include <vector>

#include "fakes/clock.hpp"
#include "fakes/eeprom.hpp"
#include "fakes/page_flash.hpp"
#include "fakes/power.hpp"

namespace fakes {

std::vector<uint8_t>& marks();

inline void reset() {
    resetClock();
    resetEeprom();
    resetPageFlash();
    marks().clear();
}

}  // namespace fakes
