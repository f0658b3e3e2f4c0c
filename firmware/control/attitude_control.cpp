// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/control/attitude_control.hpp"

#include "control/attitude.hpp"
#include "core/convert.hpp"
#include "core/file_state.hpp"
#include "core/seldom.hpp"
#include "firmware/control/autotune.hpp"
#include "firmware/control/oscillation.hpp"
#include "firmware/control/stall.hpp"
#include "firmware/estimator/estimator.hpp"
#include "firmware/state/mode_traits.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace control {

using namespace state;

core::FileState<Surfaces> surfaces{};

namespace {

using Deflection = core::Ratio;

// From centidegrees of stick to steps of a Deflection: 45 degrees are full.
constexpr core::Gain kPerCentidegree(Deflection::kSteps / 4500);

struct Loops {
    ::control::AxisState roll_state, pitch_state;
    ::control::YawState yaw_state;
    ::control::AxisGains roll_gains, pitch_gains;
    ::control::YawGains yaw_gains;
    Deflection yaw_rudder;
    uint8_t yaw_periods;  // since it was worked out
    ::control::AirFlow air;
    ::control::TurnRates turn;
    core::Angle pitch_error_rad;             // before a stall takes part of it
    ParameterWatch roll_watch, pitch_watch;  // gains cost much and change little
};
core::FileState<Loops> loops{};

// Apart from the loops, which go by reference: after that the compiler would load these anew.
struct Bounds {
    bool inverted;                                         // with loops that began so
    bool rolls;                                            // so, or on the way there or back
    uint8_t mode_entry;                                    // that the loops began with
    int16_t roll_limit, pitch_min, pitch_max, trim_pitch;  // of an Angle
    int16_t pull_out;                                      // the error that a slow wing bears
    core::Ratio full_throttle;
    Deflection rudder_mix;
    ParameterWatch limits_watch;
};
core::FileState<Bounds> bounds{};

int16_t angle(int16_t cd) {
    constexpr core::Ratio kSteps(core::Angle::kSteps * core::radians(0.01f));
    return core::times14(cd, kSteps.raw);
}

// Where it turns to: farther ahead than the loop that holds TRAINING's bounds needs to stop.
int16_t soon(core::Angle angle_rad, core::BodyRate rate_rads) {
    constexpr float kLead_s = 0.6f;
    constexpr int16_t kLead =
        static_cast<int16_t>(kLead_s * core::Angle::kSteps / core::BodyRate::kSteps);
    return core::narrowed(angle_rad.raw + core::product(kLead, rate_rads.raw));
}

// How far to turn: to what is demanded, or in TRAINING to the bound that is nearer.
core::Angle error(core::Angle now_rad, core::BodyRate rate_rads, core::Angle demand_rad,
                  core::Angle pilot_rad, int16_t low, int16_t high, int16_t trim) {
    if (vehicle.sticks == Sticks::rates) return demand_rad;
    int16_t wanted = core::narrowed(int32_t{demand_rad.raw} + pilot_rad.raw);
    if (vehicle.sticks == Sticks::bounded)
        wanted = soon(now_rad, rate_rads) > 0 ? INT16_MAX : INT16_MIN;
    const uint16_t limited = static_cast<uint16_t>(core::limit(wanted, low, high));
    return core::between(now_rad, core::Angle::fromRaw(static_cast<int16_t>(limited + trim)));
}

// How far the wings are from level, whichever way up they are wanted: 1 there.
int16_t uprightness() {
    const int16_t cosine = vehicle.attitude.cos_roll.raw;
    return bounds.inverted ? static_cast<int16_t>(-cosine) : cosine;
}

// Half a roll asks nobody where to turn; where both ways are long it goes to the right.
core::Angle rollError() {
    constexpr core::Ratio kOver(0.5f);
    const int16_t upside = bounds.inverted ? INT16_MIN : 0;
    const auto& attitude = vehicle.attitude;
    if (!bounds.rolls || uprightness() > kOver.raw)
        return error(attitude.roll_rad, attitude.rate_rads.x, vehicle.roll_demand_rad,
                     vehicle.pilot_roll_rad, -bounds.roll_limit, bounds.roll_limit, upside);
    const core::Angle left = core::between(attitude.roll_rad, core::Angle::fromRaw(upside));
    constexpr core::Angle kLong_rad(core::radians(150));
    return left.raw < -kLong_rad.raw ? core::Angle::fromRaw(INT16_MAX) : left;
}

// The nose goes up by as much of the elevator as the wing is level, upside down by pushing; and no
// harder than a wing bears that was made for the other side.
core::Angle aboutWing(core::Angle up_rad) {
    constexpr core::Angle kMax_rad(core::radians(14));
    constexpr core::Ratio kThere(0.8f);
    const int16_t limited =
        core::limit<int16_t>(up_rad.raw, static_cast<int16_t>(-kMax_rad.raw), kMax_rad.raw);
    if (!bounds.inverted && uprightness() > kThere.raw && limited == up_rad.raw)
        bounds.rolls = false;
    return core::Angle::fromRaw(core::times14(limited, vehicle.attitude.cos_roll.raw));
}

// In the flare gusts are met twice as fast as elsewhere.
core::Angle pitchError() {
    core::Angle up_rad =
        error(vehicle.attitude.pitch_rad, vehicle.attitude.rate_rads.y, vehicle.pitch_demand_rad,
              vehicle.pilot_pitch_rad, bounds.pitch_min, bounds.pitch_max, bounds.trim_pitch);
    if (vehicle.progress.flaring) up_rad = core::Angle::fromRaw(core::narrowed(2L * up_rad.raw));
    return bounds.rolls ? aboutWing(up_rad) : up_rad;
}

using StallPhase = ::control::Stall::Phase;

// Out of a stall the nose rises no faster than a slow wing bears, and until there is speed no
// higher than where it gains some.
core::Angle pitchErrorInStall(core::Angle up_rad) {
    constexpr core::Angle kGaining_rad(core::radians(-5));
    int16_t most = bounds.pull_out;
    if (stall_recovery.slow) {
        const int16_t low = core::between(vehicle.attitude.pitch_rad, kGaining_rad).raw;
        if (low < most) most = low;
    }
    return core::Angle::fromRaw(up_rad.raw < most ? up_rad.raw : most);
}

// Neutral and a little down; ailerons far out would stall the wing they are to lift.
void letNoseFall() {
    constexpr Deflection kDown(-0.1f), kAileron(0.4f);
    surfaces.elevator = kDown;
    surfaces.aileron.raw = core::limit<int16_t>(surfaces.aileron.raw,
                                                static_cast<int16_t>(-kAileron.raw), kAileron.raw);
    loops.pitch_state = ::control::AxisState();
}

core::Angle toLevel_rad() {
    return core::between(vehicle.attitude.roll_rad, core::Angle::fromRaw(0));
}

// The servos are sent a pulse every 20 ms, and the airplane's swing takes a second.
Deflection yaw() {
    constexpr uint8_t kEvery = 4;  // periods
    const uint16_t periods = loops.yaw_periods + vehicle.imu.periods;
    loops.yaw_periods = static_cast<uint8_t>(periods);
    if (periods < kEvery) return loops.yaw_rudder;
    loops.yaw_periods = 0;
    loops.yaw_rudder = ::control::yawDeflection(
        loops.yaw_gains, loops.yaw_state, loops.air, loops.turn, vehicle.attitude.rate_rads.z,
        vehicle.imu.accel_mss.y, static_cast<uint8_t>(periods < 0xFF ? periods : 0xFF));
    return loops.yaw_rudder;
}

void add(Deflection& to, int32_t steps) { to = Deflection::fromRaw(to.raw + steps); }
void addStick(Deflection& to, int16_t stick_cd) {
    if (stick_cd != 0) add(to, core::times12(stick_cd, kPerCentidegree.raw));
}

// The stick, but where it leads out of the bounds no further than what holds them. Close to them
// that counts whichever way it turns, or stick and loop would take turns.
void bind(Deflection& surface, int16_t stick_cd, core::Angle now_rad, core::BodyRate rate_rads,
          int16_t low, int16_t high, ::control::AxisState& state) {
    constexpr core::Angle kClose_rad(core::radians(3));
    Deflection stick = Deflection::fromRaw(0);
    addStick(stick, stick_cd);
    const int16_t soon_rad = soon(now_rad, rate_rads);
    const bool over = soon_rad > high || now_rad.raw > high - kClose_rad.raw;
    const bool under = soon_rad < low || now_rad.raw < low + kClose_rad.raw;
    if ((over && surface.raw < stick.raw) || (under && surface.raw > stick.raw)) return;
    surface = stick;
    state = ::control::AxisState();
}

void bindSticks() {
    const auto& attitude = vehicle.attitude;
    bind(surfaces.aileron, vehicle.radio.roll_cd, attitude.roll_rad, attitude.rate_rads.x,
         -bounds.roll_limit, bounds.roll_limit, loops.roll_state);
    bind(surfaces.elevator, vehicle.radio.pitch_cd, attitude.pitch_rad, attitude.rate_rads.y,
         bounds.pitch_min, bounds.pitch_max, loops.pitch_state);
}

// A rate of the pilot's own is not that of a turn.
::control::TurnRates turnToFly() {
    const bool turns = vehicle.sticks == Sticks::rates &&
                       (vehicle.radio.pitch_cd != 0 || parameters.acro_locking == 0);
    if (!turns) return loops.turn;
    return {core::BodyRate::fromRaw(0), loops.turn.yaw_rads};
}

// Not on the ground: where a gust lifts a wing, a wheel that turned with the ailerons would steer
// towards that wing, and overturn the airplane. Without ailerons nothing else holds it level.
bool mixesRudder() {
    return !vehicle.progress.steering || !loops.air.integrators_rest || parameters.rudder_only != 0;
}

void watchOscillation() {
    const bool flown_by_gains = vehicle.sticks != Sticks::direct && !loops.air.integrators_rest &&
                                stall_recovery.phase == StallPhase::flying;
    if (!flown_by_gains || vehicle.mode == Mode::autotune) return;
    const auto& rate_rads = vehicle.attitude.rate_rads;
    if (oscillates(kTunedRoll, rate_rads.x, surfaces.aileron, vehicle.radio.roll_cd))
        ::control::weaken(loops.roll_gains);
    if (oscillates(kTunedPitch, rate_rads.y, surfaces.elevator, vehicle.radio.pitch_cd))
        ::control::weaken(loops.pitch_gains);
}

void stabilise() {
    const auto& rate_rads = vehicle.attitude.rate_rads;
    const uint8_t periods = vehicle.imu.periods;
    const StallPhase stall = stall_recovery.phase;
    core::Angle roll_error = rollError(), pitch_error = pitchError();
    loops.pitch_error_rad = pitch_error;
    if (stall != StallPhase::flying) {
        roll_error = toLevel_rad();
        pitch_error = pitchErrorInStall(pitch_error);
    }
    surfaces.aileron = ::control::rollDeflection(loops.roll_gains, loops.roll_state, loops.air,
                                                 roll_error, rate_rads.x, periods);
    surfaces.elevator = ::control::pitchDeflection(loops.pitch_gains, loops.pitch_state, loops.air,
                                                   turnToFly(), pitch_error, rate_rads.y, periods);
    if (stall == StallPhase::breaking) letNoseFall();
    if (vehicle.mode == Mode::autotune) {
        tune(kTunedRoll, loops.roll_gains, loops.roll_state, loops.air, roll_error, rate_rads.x,
             swingOf(kTunedRoll));
        tune(kTunedPitch, loops.pitch_gains, loops.pitch_state, loops.air, pitch_error, rate_rads.y,
             swingOf(kTunedPitch));
    }
    if (vehicle.sticks == Sticks::bounded) bindSticks();
    surfaces.rudder = yaw();
    if (vehicle.progress.steering) surfaces.rudder = Deflection::fromRaw(0);  // that damps, too
    if (mixesRudder())
        add(surfaces.rudder, core::times14(surfaces.aileron.raw, bounds.rudder_mix.raw));
    add(surfaces.rudder, vehicle.rudder_demand.raw);
}

void addSticks() {
    addStick(surfaces.aileron, vehicle.radio.roll_cd);
    addStick(surfaces.elevator, vehicle.radio.pitch_cd);
}

}  // namespace

void runAttitudeControl() {
    if (bounds.mode_entry != vehicle.mode_entries || bounds.inverted != vehicle.inverted) {
        bounds.mode_entry = vehicle.mode_entries;
        bounds.rolls = bounds.rolls || vehicle.inverted;
        bounds.inverted = vehicle.inverted;
        loops.roll_state = loops.pitch_state = ::control::AxisState();
        loops.yaw_state = ::control::YawState();
    }
    if (vehicle.attitude.cos_roll.raw < 0) bounds.rolls = true;  // whatever has thrown it over
    if (vehicle.sticks > Sticks::on_top) bounds.rolls = false;   // the pilot's own
    const bool at_trim = vehicle.mode == Mode::initialising;
    if (at_trim || vehicle.sticks == Sticks::direct)
        surfaces = Surfaces();
    else
        stabilise();
    if (vehicle.sticks == Sticks::direct || vehicle.sticks == Sticks::on_top) addSticks();
    if (!at_trim) addStick(surfaces.rudder, vehicle.radio.yaw_cd);
    surfaces.throttle = stall_recovery.full_power ? bounds.full_throttle : vehicle.throttle_demand;
}

namespace {

constexpr float kPerRadian = core::centidegrees(1.0f), kFull_cd = 4500;

void yawFigures(LoopFigures& to) {
    to.demand_cdps = loops.turn.yaw_rads.toFloat() * kPerRadian;
    to.rate_cdps = vehicle.attitude.rate_rads.z.toFloat() * kPerRadian;
    to.proportional_cd = to.feed_forward_cd = 0;
    to.integral_cd = loops.yaw_state.integrator * kFull_cd;
    to.derivative_cd = loops.yaw_rudder.toFloat() * kFull_cd - to.integral_cd;
}

}  // namespace

SELDOM void loopFigures(Loop loop, LoopFigures& to) {
    if (loop == Loop::yaw) return yawFigures(to);
    const bool roll = loop == Loop::roll;
    const ::control::AxisGains& gains = roll ? loops.roll_gains : loops.pitch_gains;
    const ::control::AxisState& state = roll ? loops.roll_state : loops.pitch_state;
    const auto& rate_rads = vehicle.attitude.rate_rads;
    float demand_rads =
        demandedRate_rads(gains, roll ? rollError() : loops.pitch_error_rad).toFloat();
    if (!roll) demand_rads += gains.turn_compensation.toFloat() * turnToFly().pitch_rads.toFloat();
    to.demand_cdps = demand_rads * kPerRadian;
    to.rate_cdps = (roll ? rate_rads.x : rate_rads.y).toFloat() * kPerRadian;
    to.feed_forward_cd =
        gains.feed_forward.toFloat() * demand_rads * loops.air.speed_scale.toFloat() * kFull_cd;
    to.integral_cd = state.integrator.toFloat() * kFull_cd;
    to.proportional_cd =
        state.last_output.toFloat() * kFull_cd - to.integral_cd - to.feed_forward_cd;
    to.derivative_cd = 0;  // there is no such term
}

core::BodyRate pitchRise_rads() {
    return core::BodyRate::fromRaw(int32_t{vehicle.attitude.rate_rads.y.raw} -
                                   loops.turn.pitch_rads.raw);
}

core::Angle pitchShort_rad() {
    return bounds.rolls ? core::Angle::fromRaw(0) : loops.pitch_error_rad;
}

// Without a sensor the estimated airspeed serves, and in a head wind that is not known it is too
// low. Gains for too low a speed make the surfaces swing, gains for too high a one only follow
// slower: they are never higher than at the cruise speed. While the ground holds the airplane the
// integrators rest, as ArduPlane's do: they would lift it off with its surfaces far out.
void runSpeedScaling() {
    const auto& attitude = vehicle.attitude;
    float airspeed_mps = vehicle.estimate.equivalent_airspeed_mps;
    const bool rests = airspeed_mps < speedMin_mps() || estimator::mayRoll();
    if (!vehicle.airspeed.healthy)
        airspeed_mps = fmaxf(airspeed_mps, core::hundredths(parameters.cruise_speed_cms));
    loops.air = ::control::airFlow(parameters.scaling_speed_mps, airspeed_mps, rests);
    core::Ratio sine = attitude.sin_roll, cosine = attitude.cos_roll;
    if (bounds.inverted) {  // both turn the other way about the airplane's own axes
        sine = core::Ratio::fromRaw(-sine.raw);
        cosine = core::Ratio::fromRaw(-cosine.raw);
    }
    loops.turn = ::control::turnRates(loops.air, sine.toFloat(), cosine.toFloat(),
                                      attitude.cos_pitch.toFloat());
    if (bounds.inverted)
        loops.turn = {core::BodyRate::fromRaw(-loops.turn.pitch_rads.raw),
                      core::BodyRate::fromRaw(-loops.turn.yaw_rads.raw)};
    watchOscillation();
}

static void limitRollRate() {
    loops.roll_gains.most_up_rads = loops.roll_gains.most_down_rads =
        ::control::fastestRate_rads(loops.roll_gains, loops.air, parameters.roll.rate_max_dps);
}

void runRollGains() {
    if (weaknessEnds(kTunedRoll)) loops.roll_watch = ParameterWatch();
    if (!loops.roll_watch.changed()) return limitRollRate();
    loops.roll_gains = ::control::rollGains(parameters.roll);
    weakenAsBefore(kTunedRoll, loops.roll_gains);
    loops.yaw_gains = ::control::yawGains(parameters.yaw);
}

void runPitchGains() {
    if (weaknessEnds(kTunedPitch)) loops.pitch_watch = ParameterWatch();
    if (!loops.pitch_watch.changed()) return;
    loops.pitch_gains = ::control::pitchGains(parameters.pitch);
    weakenAsBefore(kTunedPitch, loops.pitch_gains);
}

void runControlLimits() {
    if (!bounds.limits_watch.changed()) return;
    bounds.roll_limit = angle(parameters.roll_limit_cd);
    bounds.pitch_min = angle(parameters.pitch_min_cd);
    bounds.pitch_max = angle(parameters.pitch_max_cd);
    bounds.trim_pitch = angle(parameters.trim_pitch_cd);
    bounds.rudder_mix = Deflection(parameters.rudder_only != 0 ? 1 : parameters.rudder_mix);
    // 1.6 g at the trainer's cruise speed, 1.4 g at its lowest one, where the wing bears 1.44 g
    constexpr float kPullOut_rads = core::radians(25);
    bounds.pull_out = core::Angle(kPullOut_rads * parameters.pitch.axis.time_constant_s).raw;
    bounds.full_throttle = Deflection(core::hundredths(parameters.throttle_max_pct));
}

}  // namespace control
}  // namespace firmware
