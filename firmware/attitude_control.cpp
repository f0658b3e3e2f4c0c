// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/attitude_control.hpp"

#include "control/attitude.hpp"
#include "firmware/modes.hpp"
#include "firmware/parameters.hpp"
#include "firmware/vehicle.hpp"

namespace firmware {

Surfaces surfaces;

namespace {

constexpr float kFullStick_cd = 4500.0f;
constexpr float kSlowest_mps = 3.0f;  // nothing divides by less

control::AxisState roll_state, pitch_state;
control::YawState yaw_state;

float stick(int16_t deflection_cd) { return deflection_cd * (1.0f / kFullStick_cd); }

// Without a sensor the estimated airspeed serves: it is the cruise speed until the wind is known.
control::AirFlow airFlow() {
    const float airspeed_mps =
        core::limit(vehicle.estimate.equivalent_airspeed_mps, kSlowest_mps, 100.0f);
    const float inverse = 1.0f / airspeed_mps;
    return {control::speedScale(parameters.scaling_speed_mps, inverse), airspeed_mps, inverse,
            airspeed_mps < parameters.speed_min_mps, vehicle.imu.dt_s};
}

float limitedRoll_rad() {
    const float limit_rad = core::radiansFromCentidegrees(parameters.roll_limit_cd);
    return core::limit(vehicle.roll_demand_rad + vehicle.pilot_roll_rad, -limit_rad, limit_rad);
}

float limitedPitch_rad() {
    return core::limit(vehicle.pitch_demand_rad + vehicle.pilot_pitch_rad,
                       core::radiansFromCentidegrees(parameters.pitch_min_cd),
                       core::radiansFromCentidegrees(parameters.pitch_max_cd)) +
           core::radiansFromCentidegrees(parameters.trim_pitch_cd);
}

void stabilise() {
    const auto& attitude = vehicle.attitude;
    const control::AirFlow air = airFlow();
    const control::Bank bank = {attitude.sin_roll, attitude.cos_roll, attitude.cos_pitch};
    const float roll_error_rad = core::wrapPi(limitedRoll_rad() - attitude.roll_rad);
    surfaces.aileron = control::rollDeflection(parameters.roll, roll_state, air, roll_error_rad,
                                               attitude.rate_rads.x);
    surfaces.elevator =
        control::pitchDeflection(parameters.pitch, pitch_state, air, bank,
                                 limitedPitch_rad() - attitude.pitch_rad, attitude.rate_rads.y);
    surfaces.rudder = control::yawDeflection(parameters.yaw, yaw_state, air, bank,
                                             attitude.rate_rads.z, vehicle.imu.accel_mss.y) +
                      surfaces.aileron * parameters.rudder_mix;
}

}  // namespace

void runAttitudeControl() {
    if (vehicle.mode_changed) {
        roll_state = pitch_state = control::AxisState();
        yaw_state = control::YawState();
    }
    const float aileron_stick = stick(vehicle.radio.roll_cd);
    const float elevator_stick = stick(vehicle.radio.pitch_cd);
    if (vehicle.sticks == Sticks::direct) {
        surfaces = {aileron_stick, elevator_stick, 0, 0};
    } else {
        stabilise();
        if (vehicle.sticks == Sticks::on_top) {
            surfaces.aileron += aileron_stick;
            surfaces.elevator += elevator_stick;
        }
    }
    surfaces.rudder += stick(vehicle.radio.yaw_cd);
    surfaces.throttle = vehicle.throttle_demand;
}

}  // namespace firmware
