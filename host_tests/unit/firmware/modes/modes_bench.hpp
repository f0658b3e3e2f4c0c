// SPDX-License-Identifier: GPL-3.0-or-later
// An airplane in the air, its modes run as the schedule runs them.
#pragma once
#include <cmath>

#include "firmware/control/attitude_control.hpp"
#include "firmware/guidance/guidance.hpp"
#include "firmware/modes/modes.hpp"
#include "firmware_bench.hpp"
#include "host_tests/support/fakes/vehicle.hpp"

namespace modes_bench {

using firmware::control::surfaces;
using firmware::state::Mode;
using firmware::state::mutable_vehicle;
using firmware::state::parameters;
using firmware::state::Path;
using firmware::state::Sticks;
using firmware::state::vehicle;

constexpr geo::Position kHome = {470000000, 80000000};
constexpr float kStick = 370;  // us of a full one beyond its dead zone

class ModesBench : public bench::Bench {
protected:
    void SetUp() override {
        Bench::SetUp();
        mutable_vehicle.imu.periods = 2;
        mutable_vehicle.imu.accel_mss = core::Accelerations::from(0, 0, -core::kGravity_mss);
        mutable_vehicle.home.position = mutable_vehicle.estimate.position = kHome;
        mutable_vehicle.gps.fix = firmware::state::GpsFix::three_d;
        mutable_vehicle.airspeed.healthy = true;
        mutable_vehicle.estimate.airspeed_mps = mutable_vehicle.estimate.equivalent_airspeed_mps =
            15;
        course(0, 15);
        attitude(0, 0);
    }
    static void course(float north_mps, float east_mps) {
        mutable_vehicle.estimate.velocity_mps = {north_mps, east_mps, 0};
        mutable_vehicle.estimate.ground_speed_mps = mutable_vehicle.gps.ground_speed_mps =
            std::hypot(north_mps, east_mps);
    }
    static void attitude(float roll_rad, float pitch_rad) {
        auto& attitude = mutable_vehicle.attitude;
        attitude.roll_rad = core::Angle(roll_rad);
        attitude.pitch_rad = core::Angle(pitch_rad);
        attitude.sin_roll = core::Ratio(std::sin(roll_rad));
        attitude.cos_roll = core::Ratio(std::cos(roll_rad));
        attitude.sin_pitch = core::Ratio(std::sin(pitch_rad));
        attitude.cos_pitch = core::Ratio(std::cos(pitch_rad));
    }
    // A mode's frame, after parameters and airspeed have been looked at.
    static void frame() {
        prepareControl();
        mutable_vehicle.imu.periods = 2;
        firmware::modes::runMode();
        firmware::control::runAttitudeControl();
    }
    static void guide(int tenths = 1) {
        for (int i = 0; i < tenths; ++i) {
            firmware::modes::runMode();
            firmware::guidance::runGuidance();
            firmware::guidance::runSpeedHeight();
            firmware::modes::runMode();
            firmware::guidance::runGuidance();
        }
    }
    static float planned_m() { return vehicle.progress.height_error_m + vehicle.estimate.height_m; }
};

}  // namespace modes_bench
