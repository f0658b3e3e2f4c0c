// SPDX-License-Identifier: GPL-3.0-or-later
// What can go wrong in flight; safety/failsafe_table.cpp has a row a cause.
#pragma once
#include <stdint.h>

#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace state {

enum class Cause : uint8_t {
    inertial,
    fence,
    battery,
    blown_back,
    radio_long,
    ground_long,
    radio_short,
    no_position,
    no_height,
    gps,
    gps_jump,
    barometer,
    airspeed,
    compass,
};
constexpr uint8_t kCauses = 14;
constexpr uint16_t bitOf(Cause cause) {
    return static_cast<uint16_t>(1U << static_cast<uint8_t>(cause));
}

inline bool failing(Cause cause) { return (vehicle.failing & bitOf(cause)) != 0; }

}  // namespace state
}  // namespace firmware
