// SPDX-License-Identifier: GPL-3.0-or-later
// Home in the EEPROM while the airplane is armed, for a loss of power that takes the memory too.
// Disarming takes it away again: where a flight ended properly nobody returns to an old place. It
// stands there twice, so that a bit that changes by itself costs nothing.
#pragma once
#include <stdint.h>

#include "core/status.hpp"
#include "geo/position.hpp"

namespace firmware {
namespace safety {

struct __attribute__((packed)) SavedHome {
    geo::Position position;
    int32_t altitude_cm;
    uint16_t checksum;
};

MUST_USE core::Status saveHome(const geo::Position& position, int32_t altitude_cm);
MUST_USE core::Status forgetHome();
// corrupt: there is none.
MUST_USE core::Status readHome(SavedHome& home);

}  // namespace safety
}  // namespace firmware
