// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/modes/sticks.hpp"

#include "core/maths.hpp"
#include "firmware/fence.hpp"
#include "firmware/parameters.hpp"
#include "firmware/vehicle.hpp"

namespace firmware {
namespace {

// 100 Hz: multiplied, as a division costs four times as much, and not at all for a stick at rest.
constexpr float kPerFullStick = 1.0f / 4500.0f;

}  // namespace

core::Angle stickRoll_rad() {
    const int16_t stick_cd = vehicle.radio.roll_cd;
    if (stick_cd == 0) return core::Angle::fromRaw(0);
    return core::radiansFromCentidegrees(stick_cd * kPerFullStick * parameters.roll_limit_cd);
}

core::Angle stickPitch_rad() {
    const int16_t stick_cd = vehicle.radio.pitch_cd;
    if (stick_cd == 0) return core::Angle::fromRaw(0);
    const int16_t limit_cd = stick_cd > 0 ? parameters.pitch_max_cd : -parameters.pitch_min_cd;
    return core::radiansFromCentidegrees(stick_cd * kPerFullStick * limit_cd);
}

float stickThrottle() { return vehicle.radio.throttle_pct * 0.01f; }

void mixSticks() {
    const int8_t mixing = vehicle.radio.lost || fenceHolds() ? 0 : parameters.stick_mixing;
    vehicle.pilot_roll_rad = mixing == 1 ? stickRoll_rad() : core::Angle::fromRaw(0);
    vehicle.pilot_pitch_rad = mixing == 1 ? stickPitch_rad() : core::Angle::fromRaw(0);
    vehicle.sticks = mixing == 2 ? Sticks::on_top : Sticks::nothing;
}

}  // namespace firmware
