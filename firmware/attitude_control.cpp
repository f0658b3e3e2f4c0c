// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/attitude_control.hpp"

#include "control/attitude.hpp"
#include "firmware/modes.hpp"
#include "firmware/parameters.hpp"
#include "firmware/vehicle.hpp"

namespace firmware {

Surfaces surfaces;

namespace {

constexpr float kPerFullStick = 1.0f / 4500.0f;
constexpr uint8_t kPrepareEvery = 5;  // frames between looks at airspeed, turn and parameters

control::AxisState roll_state, pitch_state;
control::YawState yaw_state;
control::AxisGains roll_gains, pitch_gains;
control::AirFlow air;
control::TurnRates turn;
float roll_limit_rad, pitch_min_rad, pitch_max_rad, trim_pitch_rad;
uint8_t prepared;  // frames ago

// Without a sensor the estimated airspeed serves: it is the cruise speed until the wind is known.
void prepare() {
    const auto& attitude = vehicle.attitude;
    air = control::airFlow(parameters.scaling_speed_mps, vehicle.estimate.equivalent_airspeed_mps,
                           parameters.speed_min_mps);
    turn = control::turnRates(air, attitude.sin_roll, attitude.cos_roll, attitude.cos_pitch);
    roll_gains = control::axisGains(parameters.roll.axis);
    pitch_gains = control::axisGains(parameters.pitch.axis);
    roll_limit_rad = core::radiansFromCentidegrees(parameters.roll_limit_cd);
    pitch_min_rad = core::radiansFromCentidegrees(parameters.pitch_min_cd);
    pitch_max_rad = core::radiansFromCentidegrees(parameters.pitch_max_cd);
    trim_pitch_rad = core::radiansFromCentidegrees(parameters.trim_pitch_cd);
}

float limitedRoll_rad() {
    return core::limit(vehicle.roll_demand_rad + vehicle.pilot_roll_rad, -roll_limit_rad,
                       roll_limit_rad);
}

float limitedPitch_rad() {
    return core::limit(vehicle.pitch_demand_rad + vehicle.pilot_pitch_rad, pitch_min_rad,
                       pitch_max_rad) +
           trim_pitch_rad;
}

void stabilise() {
    const auto& attitude = vehicle.attitude;
    const float dt_s = vehicle.imu.dt_s;
    surfaces.aileron = control::rollDeflection(parameters.roll, roll_gains, roll_state, air,
                                               core::wrapPi(limitedRoll_rad() - attitude.roll_rad),
                                               attitude.rate_rads.x, dt_s);
    surfaces.elevator = control::pitchDeflection(parameters.pitch, pitch_gains, pitch_state, air,
                                                 turn, limitedPitch_rad() - attitude.pitch_rad,
                                                 attitude.rate_rads.y, dt_s);
    surfaces.rudder = control::yawDeflection(parameters.yaw, yaw_state, air, turn,
                                             attitude.rate_rads.z, vehicle.imu.accel_mss.y, dt_s) +
                      surfaces.aileron * parameters.rudder_mix + vehicle.rudder_demand;
}

void addSticks() {
    surfaces.aileron += vehicle.radio.roll_cd * kPerFullStick;
    surfaces.elevator += vehicle.radio.pitch_cd * kPerFullStick;
}

}  // namespace

void runAttitudeControl() {
    if (vehicle.mode_changed) {
        roll_state = pitch_state = control::AxisState();
        yaw_state = control::YawState();
    }
    if (vehicle.mode_changed || ++prepared >= kPrepareEvery) {
        prepared = 0;
        prepare();
    }
    if (vehicle.sticks == Sticks::direct)
        surfaces = {0, 0, 0, 0};
    else
        stabilise();
    if (vehicle.sticks != Sticks::nothing) addSticks();
    surfaces.rudder += vehicle.radio.yaw_cd * kPerFullStick;
    surfaces.throttle = vehicle.throttle_demand;
}

}  // namespace firmware
