// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/control/stall.hpp"

#include <math.h>

#include "core/file_state.hpp"
#include "firmware/control/attitude_control.hpp"
#include "firmware/estimator/estimator.hpp"
#include "firmware/notify/status_text.hpp"
#include "firmware/state/mode_traits.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace control {

using namespace notify;
using namespace state;

core::FileState<StallRecovery> stall_recovery{};

namespace {

using Phase = ::control::Stall::Phase;

constexpr float kLowest_m = 10;       // below, a pilot flares, and what is lost is lost
constexpr float kSinking_mps = 1.5f;  // a stalled wing does; one on the runway does not
// Of the airspeed, from the path up to the nose: 25 degrees. No wing flies so, but a wind that
// sinks by 4 m/s would show half of it at 12 m/s.
constexpr float kFalling = 0.42f, kFalling_mps = 3;

struct Watch {
    ::control::Stall stall;
};
core::FileState<Watch> watch{};

// The elevator is the loop's alone.
bool holdsElevator() {
    if (vehicle.sticks == Sticks::on_top) return vehicle.radio.pitch_cd == 0;
    return vehicle.sticks == Sticks::nothing;
}

bool flares() {
    if (vehicle.progress.flaring) return true;
    return vehicle.baro.healthy && estimator::aboveField_m() < kLowest_m;
}

bool possible() {
    const bool takes_off = guidesItself() && vehicle.demand.path == Path::takeoff;
    return parameters.stall_prevention != 0 && vehicle.armed && vehicle.estimate.flying &&
           vehicle.imu.healthy && !vehicle.inverted && holdsElevator() && !takes_off && !flares();
}

// By an airspeed sensor that reads too little, no sooner than at the lowest speed.
bool falls() {
    const float climb_mps = vehicle.estimate.climb_mps;
    if (climb_mps > -kFalling_mps) return false;
    const float fast_mps = fmaxf(vehicle.estimate.airspeed_mps, speedMin_mps());
    return fast_mps * (vehicle.attitude.sin_pitch.toFloat() - kFalling) > climb_mps;
}

void lookForStall(bool falls) {
    auto& recovery = stall_recovery;
    recovery.slow = falls || vehicle.estimate.equivalent_airspeed_mps < speedMin_mps();
    const bool sinks = !vehicle.baro.healthy || vehicle.estimate.climb_mps < -kSinking_mps;
    watch.stall.run(
        {surfaces.elevator, pitchShort_rad(), pitchRise_rads(), recovery.slow, sinks, falls});
    const Phase phase = watch.stall.phase();
    if (recovery.phase == Phase::flying && phase == Phase::breaking)
        sendStatusText(Severity::warning, STATUS_TEXT("Stall: nose down"));
    recovery.phase = phase;
    const bool needs_power =
        phase == Phase::breaking || (phase == Phase::pulling_out && recovery.slow);
    recovery.full_power = needs_power && autoThrottle();
}

}  // namespace

void runStall() {
    const bool falling = falls();
    const bool calm = !falling && ::control::Stall::calm(surfaces.elevator);
    if (stall_recovery.phase == Phase::flying && calm) return watch.stall.runCalm();
    if (possible()) return lookForStall(falling);
    watch.stall.stop();
    stall_recovery = StallRecovery();
}

}  // namespace control
}  // namespace firmware
