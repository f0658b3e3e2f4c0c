// SPDX-License-Identifier: GPL-3.0-or-later
// ACRO: the sticks demand rates of roll and pitch, and there are no limits. With centred sticks the
// airplane stops turning; with ACRO_LOCKING it keeps the attitude it has then, whatever pushes it.
#include "control/settings.hpp"
#include "core/file_state.hpp"
#include "core/maths.hpp"
#include "firmware/control/attitude_demand.hpp"
#include "firmware/modes/modes_table.hpp"
#include "firmware/modes/sticks.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace modes {

using namespace state;
using namespace control;

namespace {

constexpr float kFullStick_cd = 4500;
constexpr float kMax_rad = 3.1f;                                 // an angle has no more
constexpr core::BodyRate kStill_rads(0.2f);                      // slow enough to stop here
constexpr core::Angle kLoose = core::Angle::fromRaw(INT16_MIN);  // held is nothing

struct HeldAttitude {
    core::Angle held_roll_rad, held_pitch_rad;
};
core::FileState<HeldAttitude> held{};

// The angle whose loop makes this rate: error over time constant is what it demands.
core::Angle forRate(int16_t stick_cd, int16_t full_dps, float time_constant_s) {
    if (stick_cd == 0) return core::Angle::fromRaw(0);
    const float rate_rads =
        core::real(stick_cd) * (core::radians(1) / kFullStick_cd) * core::real(full_dps);
    return core::Angle(core::limit(rate_rads * time_constant_s, -kMax_rad, kMax_rad));
}

core::Angle toHold(core::Angle& held_rad, core::Angle now_rad, core::BodyRate rate_rads) {
    if (held_rad.raw == kLoose.raw) {
        const bool still = rate_rads.raw < kStill_rads.raw && rate_rads.raw > -kStill_rads.raw;
        if (!still) return core::Angle::fromRaw(0);
        held_rad = now_rad;
    }
    return core::between(now_rad, held_rad);
}

core::Angle rollToTurn() {
    const auto& attitude = vehicle.attitude;
    const int16_t stick_cd = vehicle.radio.roll_cd;
    if (stick_cd == 0 && parameters.acro_locking != 0)
        return toHold(held.held_roll_rad, attitude.roll_rad, attitude.rate_rads.x);
    held.held_roll_rad = kLoose;
    return forRate(stick_cd, parameters.acro_roll_rate_dps, parameters.roll.axis.time_constant_s);
}

// Inverted the elevator raises the nose the other way, on the side not at all.
core::Angle pitchToTurn() {
    const auto& attitude = vehicle.attitude;
    const int16_t stick_cd = vehicle.radio.pitch_cd;
    if (stick_cd == 0 && parameters.acro_locking != 0)
        return core::Angle::fromRaw(
            core::times14(toHold(held.held_pitch_rad, attitude.pitch_rad, attitude.rate_rads.y).raw,
                          attitude.cos_roll.raw));
    held.held_pitch_rad = kLoose;
    return forRate(stick_cd, parameters.acro_pitch_rate_dps, parameters.pitch.axis.time_constant_s);
}

}  // namespace

EntryResult startAcro() {
    held.held_roll_rad = held.held_pitch_rad = kLoose;
    return EntryResult::entered;
}

void runAcro() {
    useSticks(Sticks::rates);
    demandRoll(rollToTurn());
    demandPitch(pitchToTurn());
    demandThrottle(stickThrottle());
}

}  // namespace modes
}  // namespace firmware
