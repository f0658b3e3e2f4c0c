// SPDX-License-Identifier: GPL-3.0-or-later
// Which board answers on the bus where both have a chip.
#pragma once
#include "fakes/bus.hpp"
#include "firmware/sensors/sensors.hpp"

namespace bench {

// The program finds the board that it is for, or the other one.
inline void findBoard(bool wrong) {
    constexpr uint8_t kAskImu = 0xF5, kImu = 0x68, kAskFlash = 0x9F, kFlash = 0x1F;
    uint8_t asked = 0;
    fakes::Bus::device = [&](int, uint8_t out) -> uint8_t {
        const uint8_t before = asked;
        asked = out;
        if (wrong) return before == kAskFlash ? kFlash : 0;
        return before == kAskImu ? kImu : 0;
    };
    firmware::sensors::findBoard();
    fakes::Bus::device = nullptr;
}

}  // namespace bench
