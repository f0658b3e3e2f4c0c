// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/attitude_control.hpp"

#include "control/attitude.hpp"
#include "core/rom.hpp"
#include "firmware/modes.hpp"
#include "firmware/parameters.hpp"
#include "firmware/vehicle.hpp"

namespace firmware {

Surfaces surfaces;

namespace {

using Deflection = core::Fixed<14>;

constexpr int16_t kPerCentidegree = 14913;  // 16384 / 4500 in 2^-12

control::AxisState roll_state, pitch_state;
control::YawState yaw_state;
control::AxisGains roll_gains, pitch_gains;
control::AirFlow air;
control::TurnRates turn;
int16_t roll_limit, pitch_min, pitch_max, trim_pitch;  // of an Angle
Deflection rudder_mix;

// Without a sensor the estimated airspeed serves: it is the cruise speed until the wind is known.
void feelAir() {
    const auto& attitude = vehicle.attitude;
    air = control::airFlow(parameters.scaling_speed_mps, vehicle.estimate.equivalent_airspeed_mps,
                           parameters.speed_min_mps);
    turn = control::turnRates(air, attitude.sin_roll, attitude.cos_roll, attitude.cos_pitch);
}

int16_t angle(int16_t cd) {
    constexpr int16_t kPerCentidegree_turn = 29826;  // 65536 / 36000 in 2^-14
    return core::times14(cd, kPerCentidegree_turn);
}

void takeRoll() { roll_gains = control::rollGains(parameters.roll); }
void takePitch() { pitch_gains = control::pitchGains(parameters.pitch); }
void takeRest() {
    roll_limit = angle(parameters.roll_limit_cd);
    pitch_min = angle(parameters.pitch_min_cd);
    pitch_max = angle(parameters.pitch_max_cd);
    trim_pitch = angle(parameters.trim_pitch_cd);
    rudder_mix = parameters.rudder_mix;
}

void lookAway() {}

// Airspeed and turn are looked at every 50 ms, parameters every 100 ms.
using Look = void (*)();
constexpr Look kLooks[] ROM = {feelAir, takeRoll,  lookAway, lookAway, lookAway,
                               feelAir, takePitch, lookAway, takeRest, lookAway};
uint8_t look;

core::Angle rollError() {
    const int16_t wanted = static_cast<int16_t>(
        core::limit<int32_t>(int32_t{vehicle.roll_demand_rad.raw} + vehicle.pilot_roll_rad.raw,
                             -roll_limit, roll_limit));
    return core::between(vehicle.attitude.roll_rad, core::Angle::fromRaw(wanted));
}

core::Angle pitchError() {
    const int16_t wanted = static_cast<int16_t>(core::limit<int32_t>(
        int32_t{vehicle.pitch_demand_rad.raw} + vehicle.pilot_pitch_rad.raw, pitch_min, pitch_max));
    return core::between(
        vehicle.attitude.pitch_rad,
        core::Angle::fromRaw(static_cast<int16_t>(static_cast<uint16_t>(wanted) + trim_pitch)));
}

Deflection yaw() {
    return control::yawDeflection(parameters.yaw, yaw_state, air, turn,
                                  vehicle.attitude.rate_rads.z, vehicle.imu.accel_mss.y,
                                  vehicle.imu.periods * estimation::kSamplePeriod_s);
}

void add(Deflection& to, int32_t steps) { to = Deflection::fromRaw(to.raw + steps); }
void addStick(Deflection& to, int16_t stick_cd) {
    if (stick_cd != 0) add(to, core::upper(16 * core::product(stick_cd, kPerCentidegree)));
}

void stabilise() {
    const auto& rate_rads = vehicle.attitude.rate_rads;
    const uint8_t periods = vehicle.imu.periods;
    surfaces.aileron =
        control::rollDeflection(roll_gains, roll_state, air, rollError(), rate_rads.x, periods);
    surfaces.elevator = control::pitchDeflection(pitch_gains, pitch_state, air, turn, pitchError(),
                                                 rate_rads.y, periods);
    surfaces.rudder = control::yawUsed(parameters.yaw) ? yaw() : Deflection::fromRaw(0);
    add(surfaces.rudder, core::times14(surfaces.aileron.raw, rudder_mix.raw));
    add(surfaces.rudder, vehicle.rudder_demand.raw);
}

void addSticks() {
    addStick(surfaces.aileron, vehicle.radio.roll_cd);
    addStick(surfaces.elevator, vehicle.radio.pitch_cd);
}

}  // namespace

void runAttitudeControl() {
    if (vehicle.mode_changed) {
        roll_state = pitch_state = control::AxisState();
        yaw_state = control::YawState();
    }
    look = (look + 1) % core::count(kLooks);
    core::romRead(kLooks[look])();
    if (vehicle.sticks == Sticks::direct)
        surfaces = {0, 0, 0, 0};
    else
        stabilise();
    if (vehicle.sticks != Sticks::nothing) addSticks();
    addStick(surfaces.rudder, vehicle.radio.yaw_cd);
    surfaces.throttle = vehicle.throttle_demand;
}

}  // namespace firmware
