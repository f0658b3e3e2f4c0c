// SPDX-License-Identifier: GPL-3.0-or-later
// All doubles of the hardware at once, and one call that puts every one back as it was at start,
// and with them whatever the firmware remembers.
#pragma once
#include "core/file_state.hpp"
#include "fakes/board.hpp"
#include "fakes/bus.hpp"
#include "fakes/clock.hpp"
#include "fakes/eeprom.hpp"
#include "fakes/flash_bus.hpp"
#include "fakes/i2c.hpp"
#include "fakes/io.hpp"
#include "fakes/serial.hpp"

namespace fakes {

inline void reset() {
    core::resetFileStates();
    resetClock();
    resetEeprom();
    resetI2c();
    resetSerial();
    resetIo();
    Bus::reset();
    FlashBus::reset();
    board::ImuSelect::level = board::BarometerSelect::level = true;
}

}  // namespace fakes
