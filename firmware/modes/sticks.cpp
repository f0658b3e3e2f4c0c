// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/modes/sticks.hpp"

#include "core/maths.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware/state/published.hpp"

namespace firmware {

namespace state {
template <>
struct Publisher<StickState> : Writable<StickState> {
    using Writable::state;
};
}  // namespace state

namespace modes {

using namespace state;

namespace {

constexpr StickState& published = Publisher<StickState>::state();

// 100 Hz: in integers, a float costs ten times as much. In modes that guide themselves the sticks
// rest in the middle, as a rule.
core::Angle angle(int16_t stick_cd, int16_t full_cd) {
    if (stick_cd == 0) return core::Angle::fromRaw(0);
    constexpr float kFullStick_cd = 4500;
    using Product = core::Fixed32<26>;
    constexpr float kSteps = core::Angle::kSteps * core::radians(0.01f) / kFullStick_cd;
    constexpr int16_t kFactor = static_cast<int16_t>(kSteps * Product::kSteps + 1);  // rounded up
    const int32_t steps = core::times16(core::product(stick_cd, full_cd), kFactor);
    return core::Angle::fromRaw(static_cast<int16_t>((steps + 512) >> 10));
}

}  // namespace

core::Angle stickRoll_rad() { return angle(vehicle.radio.roll_cd, parameters.roll_limit_cd); }

core::Angle stickPitch_rad() {
    const int16_t stick_cd = vehicle.radio.pitch_cd;
    return angle(stick_cd, stick_cd > 0 ? parameters.pitch_max_cd : -parameters.pitch_min_cd);
}

core::Ratio stickThrottle() {
    constexpr core::Fixed<6> kSteps(core::Ratio::kSteps / 100);  // a percent's
    return core::Ratio::fromRaw(core::product(vehicle.radio.throttle_pct, kSteps.raw) >> 6);
}

void useSticks(Sticks use) {
    published.sticks = use;
    published.pilot_roll_rad = published.pilot_pitch_rad = core::Angle::fromRaw(0);
}

void mixSticks() {
    const int8_t mixing = vehicle.radio.lost || vehicle.fence_holds ? 0 : parameters.stick_mixing;
    published.sticks = mixing == 2 ? Sticks::on_top : Sticks::nothing;
    published.pilot_roll_rad = mixing == 1 ? stickRoll_rad() : core::Angle::fromRaw(0);
    published.pilot_pitch_rad = mixing == 1 ? stickPitch_rad() : core::Angle::fromRaw(0);
}

}  // namespace modes
}  // namespace firmware
