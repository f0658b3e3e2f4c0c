// SPDX-License-Identifier: GPL-3.0-or-later
// How a sensor is mounted, by the numbers of MAVLink's MAV_SENSOR_ORIENTATION, which are those of
// ArduPilot's COMPASS_ORIENT: 0 as the airplane, 8 (ROLL_180) upside down with its arrow forward.
#pragma once
#include <stdint.h>

#include "core/maths.hpp"

namespace drivers {

constexpr uint8_t kOrientations = 38;  // 0..37, those that turn by multiples of 45 degrees

// From the sensor's axes to the airplane's: rolled, then pitched, then yawed. As it was when the
// number is none of these.
core::Vector3 fromMounting(const core::Vector3& measured, uint8_t orientation);

}  // namespace drivers
