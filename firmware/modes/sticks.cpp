// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/modes/sticks.hpp"

#include "core/maths.hpp"
#include "firmware/parameters.hpp"
#include "firmware/vehicle.hpp"

namespace firmware {
namespace {

constexpr float kFullStick_cd = 4500.0f;

}  // namespace

float stickRoll_rad() {
    return core::radiansFromCentidegrees(vehicle.radio.roll_cd *
                                         (parameters.roll_limit_cd / kFullStick_cd));
}

float stickPitch_rad() {
    const float stick = vehicle.radio.pitch_cd / kFullStick_cd;
    const float limit_cd = stick > 0 ? parameters.pitch_max_cd : -parameters.pitch_min_cd;
    return core::radiansFromCentidegrees(stick * limit_cd);
}

float stickThrottle() { return vehicle.radio.throttle_pct * 0.01f; }

void mixSticks() {
    const bool mixing = parameters.stick_mixing != 0 && !vehicle.radio.lost;
    vehicle.pilot_roll_rad = mixing ? stickRoll_rad() : 0;
    vehicle.pilot_pitch_rad = mixing ? stickPitch_rad() : 0;
}

}  // namespace firmware
