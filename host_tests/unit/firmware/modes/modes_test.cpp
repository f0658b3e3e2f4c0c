// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/modes/modes.hpp"

#include "firmware/control/attitude_control.hpp"
#include "firmware/guidance/guidance.hpp"
#include "firmware_bench.hpp"
#include "host_tests/support/fakes/vehicle.hpp"

namespace {

using firmware::control::surfaces;
using firmware::state::Mode;
using firmware::state::mutable_vehicle;
using firmware::state::parameters;
using firmware::state::Path;
using firmware::state::Sticks;
using firmware::state::vehicle;

constexpr geo::Position kHome = {470000000, 80000000};
constexpr float kStick = 370;  // us of a full one beyond its dead zone

class Modes : public bench::Bench {
protected:
    void SetUp() override {
        Bench::SetUp();
        firmware::guidance::runGuidance();  // in MANUAL: whoever guided before has let go
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
        mutable_vehicle.estimate.ground_speed_mps = std::hypot(north_mps, east_mps);
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
        mutable_vehicle.imu.periods = 0;
        for (int i = 0; i < 10; ++i) firmware::control::runAttitudeControl();
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

using Training = Modes;

TEST_F(Training, leaves_the_surfaces_to_the_sticks_within_the_limits) {
    fly(Mode::training);
    attitude(0.5f, -0.2f);
    settle({1700, 1300, 1600, 1500, 1500, 1500, 1500, 1815});
    frame();
    EXPECT_NEAR(surfaces.aileron.toFloat(), 170 / kStick, 0.01);
    EXPECT_NEAR(surfaces.elevator.toFloat(), -170 / kStick, 0.01);
    EXPECT_NEAR(vehicle.throttle_demand.toFloat(), (1600 - 1130) / 770.0f, 0.01);
}

TEST_F(Training, lets_no_stick_bank_beyond_the_limit_and_every_stick_bank_back) {
    fly(Mode::training);
    attitude(core::radians(46), 0);
    settle(with(1, 1900));
    frame();
    EXPECT_LT(surfaces.aileron.toFloat(), 0.02f);
    settle(with(1, 1100));
    frame();
    EXPECT_NEAR(surfaces.aileron.toFloat(), -1, 0.01);
    attitude(core::radians(-46), 0);
    frame();
    EXPECT_GT(surfaces.aileron.toFloat(), -0.02f);
}

TEST_F(Training, begins_to_hold_before_a_fast_roll_is_at_the_limit) {
    fly(Mode::training);
    attitude(core::radians(35), 0);
    mutable_vehicle.attitude.rate_rads = core::BodyRates::from(2.0f, 0, 0);
    settle(with(1, 1900));
    frame();
    EXPECT_LT(surfaces.aileron.toFloat(), 0.3f);
}

TEST_F(Training, goes_on_holding_while_the_bank_comes_back_to_the_limit) {
    fly(Mode::training);
    attitude(core::radians(50), 0);
    mutable_vehicle.attitude.rate_rads = core::BodyRates::from(core::radians(-10), 0, 0);
    settle(with(1, 1900));
    frame();
    EXPECT_LT(surfaces.aileron.toFloat(), 0.2f);
}

TEST_F(Training, holds_the_pitch_within_its_limits_too) {
    fly(Mode::training);
    attitude(0, core::radians(21));
    settle(with(2, 1900));
    frame();
    EXPECT_LT(surfaces.elevator.toFloat(), 0.02f);
    attitude(0, core::radians(-26));
    settle(with(2, 1100));
    frame();
    EXPECT_GT(surfaces.elevator.toFloat(), -0.02f);
}

using Acro = Modes;

TEST_F(Acro, turns_at_the_rate_the_stick_demands_beyond_every_limit) {
    fly(Mode::acro);
    attitude(2.0f, 0);
    settle(with(1, 1600));
    frame();
    const float from_rest = surfaces.aileron.toFloat();
    EXPECT_GT(from_rest, 0.1f);
    mutable_vehicle.attitude.rate_rads = core::BodyRates::from(core::radians(34), 0, 0);
    frame();
    const float at_rate = surfaces.aileron.toFloat();
    EXPECT_LT(at_rate, from_rest);
    mutable_vehicle.attitude.rate_rads = core::BodyRates::from(core::radians(90), 0, 0);
    frame();
    EXPECT_LT(surfaces.aileron.toFloat(), at_rate);
    parameters.acro_roll_rate_dps = 60;
    mutable_vehicle.attitude.rate_rads = core::BodyRates::from(0, 0, 0);
    frame();
    EXPECT_LT(surfaces.aileron.toFloat(), 0.6f * from_rest);
}

TEST_F(Acro, with_centred_sticks_only_stops_turning_unless_it_locks) {
    fly(Mode::acro);
    attitude(1.0f, 0.2f);
    frame();
    attitude(1.4f, 0.5f);
    frame();
    EXPECT_NEAR(surfaces.aileron.toFloat(), 0, 1e-3);
    EXPECT_NEAR(surfaces.elevator.toFloat(), 0, 1e-3);
}

TEST_F(Acro, locked_returns_to_the_attitude_it_was_let_go_in) {
    parameters.acro_locking = 1;
    fly(Mode::acro);
    attitude(1.0f, 0.2f);
    frame();
    attitude(1.4f, 0.2f);
    frame();
    EXPECT_LT(surfaces.aileron.toFloat(), -0.1f);
    attitude(0.6f, 0.5f);
    frame();
    EXPECT_GT(surfaces.aileron.toFloat(), 0.1f);
    EXPECT_LT(surfaces.elevator.toFloat(), 0);
}

TEST_F(Acro, locks_only_once_it_has_stopped_turning) {
    parameters.acro_locking = 1;
    fly(Mode::acro);
    mutable_vehicle.attitude.rate_rads = core::BodyRates::from(2.0f, 0, 0);
    attitude(0.2f, 0);
    frame();
    mutable_vehicle.attitude.rate_rads = core::BodyRates::from(0, 0, 0);
    attitude(0.6f, 0);
    frame();
    EXPECT_NEAR(surfaces.aileron.toFloat(), 0, 0.01);
}

TEST_F(Acro, pushes_to_raise_the_nose_when_it_is_locked_inverted) {
    parameters.acro_locking = 1;
    fly(Mode::acro);
    attitude(core::kPi, 0.1f);
    frame();
    attitude(core::kPi, -0.2f);
    frame();
    EXPECT_LT(surfaces.elevator.toFloat(), -0.02f);
}

using Fbwb = Modes;

TEST_F(Fbwb, holds_the_height_at_which_it_was_entered) {
    fly(Mode::fbwb);
    mutable_vehicle.estimate.height_m = 83;
    guide(3);
    EXPECT_FLOAT_EQ(planned_m(), 80);
    EXPECT_TRUE(firmware::state::autoThrottle());
}

TEST_F(Fbwb, climbs_at_the_rate_of_the_stick_and_stays_where_it_is_let_go) {
    fly(Mode::fbwb);
    settle(with(2, 1900));
    guide(10);
    EXPECT_NEAR(planned_m(), 82, 0.21);
    settle(with(2, 1700));
    guide(10);
    EXPECT_NEAR(planned_m(), 82 + 2 * 170 / kStick, 0.3);
    mutable_vehicle.estimate.height_m = 82.5f;
    mutable_vehicle.estimate.climb_mps = 1;
    settle(bench::kCentred);
    guide(1);
    mutable_vehicle.estimate.climb_mps = 0;
    guide(10);
    EXPECT_NEAR(planned_m(), 83.5, 0.01) << "with a second to end the climb in";
}

TEST_F(Fbwb, climbs_with_the_stick_pushed_if_the_pilot_wants_that) {
    parameters.fbwb_elevator_reverse = 1;
    fly(Mode::fbwb);
    settle(with(2, 1100));
    guide(10);
    EXPECT_NEAR(planned_m(), 82, 0.21);
}

TEST_F(Fbwb, does_not_let_the_demand_run_away_from_an_airplane_that_cannot_climb) {
    fly(Mode::fbwb);
    settle(with(2, 1900));
    guide(300);
    EXPECT_LT(planned_m(), 90.2f);
}

TEST_F(Fbwb, does_not_sink_below_its_lowest_height) {
    parameters.fbwb_lowest_cm = 7500;
    fly(Mode::fbwb);
    settle(with(2, 1100));
    guide(100);
    EXPECT_FLOAT_EQ(planned_m(), 75);
    mutable_vehicle.estimate.height_m = 70;
    settle(bench::kCentred);
    guide(2);
    EXPECT_FLOAT_EQ(planned_m(), 75);
}

TEST_F(Fbwb, flies_the_speed_of_the_throttle_stick) {
    fly(Mode::fbwb);
    settle(with(3, 1100));
    guide();
    EXPECT_FLOAT_EQ(vehicle.demand.airspeed_mps, parameters.speed_min_mps);
    settle(with(3, 1900));
    guide();
    EXPECT_FLOAT_EQ(vehicle.demand.airspeed_mps, parameters.speed_max_mps);
    settle(with(3, 1515));
    guide();
    EXPECT_NEAR(vehicle.demand.airspeed_mps, 15.5, 0.1);
    mutable_vehicle.radio.lost = true;
    mutable_vehicle.radio.throttle_pct = 0;
    guide();
    EXPECT_NEAR(vehicle.demand.airspeed_mps, 15.5, 0.1) << "the last that was asked for";
}

TEST_F(Fbwb, banks_as_fbwa_does) {
    fly(Mode::fbwb);
    settle(with(1, 1900));
    guide();
    EXPECT_NEAR(vehicle.roll_demand_rad.toFloat(), core::radians(45), 1e-3);
}

TEST_F(Fbwb, is_left_for_circle_when_the_radio_is_lost) {
    for (const Mode mode : {Mode::training, Mode::acro, Mode::fbwb, Mode::cruise}) {
        settle(bench::kCentred);
        for (int i = 0; i < 3; ++i) firmware::safety::runFailsafe();
        fly(mode);
        loseRadio(1500);
        EXPECT_EQ(vehicle.mode, Mode::circle);
    }
    settle(bench::kCentred);
    for (int i = 0; i < 3; ++i) firmware::safety::runFailsafe();
    EXPECT_EQ(vehicle.mode, Mode::cruise) << "and entered again when it is back in time";
}

class Cruise : public Modes {
protected:
    void lockedTo(float north_mps, float east_mps) {
        course(north_mps, east_mps);
        fly(Mode::cruise);
        guide(6);
        ASSERT_EQ(vehicle.demand.path, Path::leg);
    }
};

TEST_F(Cruise, locks_the_course_after_half_a_second_of_centred_sticks) {
    fly(Mode::cruise);
    guide(5);
    EXPECT_EQ(vehicle.demand.path, Path::none);
    guide(1);
    EXPECT_EQ(vehicle.demand.path, Path::leg);
    const geo::Offset ahead = geo::offset(vehicle.demand.from, vehicle.demand.to);
    EXPECT_NEAR(ahead.north_m, 0, 0.5);
    EXPECT_NEAR(ahead.east_m, 1000, 0.5);
    EXPECT_EQ(vehicle.demand.from, kHome);
}

TEST_F(Cruise, turns_back_to_the_line_it_has_locked) {
    lockedTo(0, 15);
    mutable_vehicle.estimate.position = geo::moved(kHome, {20, 100});
    guide();
    EXPECT_GT(vehicle.roll_demand_rad.toFloat(), 0.1f);
    EXPECT_NEAR(vehicle.progress.crosstrack_m, -20, 0.1);
}

TEST_F(Cruise, lets_go_for_the_roll_and_for_the_yaw_stick) {
    for (const int channel : {1, 4}) {
        lockedTo(0, 15);
        settle(with(channel, 1900));
        guide();
        EXPECT_EQ(vehicle.demand.path, Path::none) << channel;
        EXPECT_NEAR(vehicle.roll_demand_rad.toFloat(), channel == 1 ? core::radians(45) : 0, 1e-3);
        settle(bench::kCentred);
        guide(5);
        EXPECT_EQ(vehicle.demand.path, Path::none);
        guide(2);
        EXPECT_EQ(vehicle.demand.path, Path::leg) << "and locks again";
    }
}

TEST_F(Cruise, does_not_lock_what_is_no_course) {
    course(2, 2);
    fly(Mode::cruise);
    guide(20);
    EXPECT_EQ(vehicle.demand.path, Path::none);
    course(0, 15);
    mutable_vehicle.estimate.known = false;
    guide(20);
    EXPECT_EQ(vehicle.demand.path, Path::none);
}

TEST_F(Cruise, flies_on_with_level_wings_when_the_position_is_lost) {
    lockedTo(0, 15);
    mutable_vehicle.estimate.known = false;
    guide();
    EXPECT_EQ(vehicle.demand.path, Path::none);
    EXPECT_NEAR(vehicle.roll_demand_rad.toFloat(), 0, 1e-3);
}

TEST_F(Cruise, moves_on_along_the_line_as_it_goes) {
    lockedTo(10, 10);
    for (int flown_m = 0; flown_m <= 5000; flown_m += 10) {
        const float each_m = static_cast<float>(flown_m) * 0.70710678f;
        mutable_vehicle.estimate.position = geo::moved(kHome, {each_m, each_m});
        guide();
        EXPECT_NEAR(vehicle.progress.crosstrack_m, 0, 5);
        EXPECT_GT(vehicle.progress.distance_m, 480);
        EXPECT_LT(vehicle.progress.distance_m, 1010);
    }
}

TEST_F(Cruise, crosses_the_antimeridian) {
    mutable_vehicle.estimate.position = {470000000, 1799990000};
    lockedTo(0, 15);
    const geo::Position start = vehicle.demand.from;
    for (int flown_m = 0; flown_m <= 2000; flown_m += 50) {
        mutable_vehicle.estimate.position = geo::moved(start, {0, static_cast<float>(flown_m)});
        guide();
        EXPECT_NEAR(vehicle.progress.crosstrack_m, 0, 2) << flown_m;
    }
    EXPECT_LT(vehicle.demand.to.longitude_e7, 0);
}

TEST_F(Cruise, holds_and_changes_height_and_speed_as_fbwb_does) {
    lockedTo(0, 15);
    settle({1500, 1900, 1515, 1500, 1500, 1500, 1500, 1815});
    guide(10);
    EXPECT_EQ(vehicle.demand.path, Path::leg) << "the pitch stick does not unlock";
    EXPECT_NEAR(planned_m(), 82, 0.21);
    EXPECT_NEAR(vehicle.demand.airspeed_mps, 15.5, 0.1);
}

TEST_F(Modes, circle_flies_at_cruise_speed_whatever_flew_before) {
    mutable_vehicle.demand.climb_rate_mps = 1;
    mutable_vehicle.demand.airspeed_mps = 0;
    fly(Mode::circle);
    guide(10);
    EXPECT_FLOAT_EQ(vehicle.demand.airspeed_mps, parameters.cruise_speed_cms * 0.01f);
    EXPECT_EQ(vehicle.demand.throttle_pct, parameters.cruise_throttle_pct);
    EXPECT_FLOAT_EQ(planned_m(), 80);
    EXPECT_NEAR(vehicle.roll_demand_rad.toFloat(), core::radians(15), 1e-3);
}

TEST_F(Modes, mix_the_sticks_into_the_demands_or_the_surfaces_as_the_pilot_wants) {
    fly(Mode::loiter);
    settle(with(1, 1900));
    const struct {
        int8_t mixing;
        Sticks sticks;
        float bent_deg;
    } all[] = {{0, Sticks::nothing, 0}, {2, Sticks::on_top, 0}, {1, Sticks::nothing, 45}};
    for (const auto& each : all) {
        parameters.stick_mixing = each.mixing;
        firmware::modes::runMode();
        EXPECT_EQ(vehicle.sticks, each.sticks) << int{each.mixing};
        EXPECT_NEAR(vehicle.pilot_roll_rad.toFloat(), core::radians(each.bent_deg), 1e-3);
    }
    parameters.stick_mixing = 2;
    loseRadio(1200);
    firmware::modes::runMode();
    EXPECT_EQ(vehicle.sticks, Sticks::nothing) << "not those of a lost radio";
}

TEST_F(Modes, a_raised_throttle_stick_adds_throttle_where_no_airspeed_is_measured) {
    mutable_vehicle.airspeed.healthy = false;
    const auto throttle = [&](Mode mode, uint16_t stick_us) {
        firmware::modes::setMode(Mode::fbwa, firmware::modes::ModeReason::ground);
        firmware::guidance::runGuidance();
        settle(with(3, stick_us));
        fly(mode);
        guide(20);
        return vehicle.throttle_demand.toFloat();
    };
    const float cruise = throttle(Mode::loiter, 1515);
    EXPECT_NEAR(throttle(Mode::loiter, 1100), cruise, 0.02) << "a closed one does not slow";
    EXPECT_GT(throttle(Mode::loiter, 1900), cruise + 0.1f);
    EXPECT_LT(throttle(Mode::fbwb, 1100), cruise - 0.05f) << "but where it is the speed's";
    parameters.throttle_nudge = 0;
    EXPECT_NEAR(throttle(Mode::loiter, 1900), cruise, 0.02);
}

TEST_F(Modes, the_stick_works_before_the_launch_only_if_the_pilot_wants_that) {
    mutable_vehicle.estimate.airspeed_mps = mutable_vehicle.estimate.equivalent_airspeed_mps = 0;
    course(0, 0);
    settle(with(3, 1515));
    fly(Mode::loiter);
    mutable_vehicle.estimate.height_m = 0;
    guide(3);
    ASSERT_TRUE(vehicle.progress.throttle_suppressed);
    EXPECT_EQ(vehicle.throttle_demand.toFloat(), 0);
    parameters.suppressed_manual = 1;
    guide(1);
    EXPECT_NEAR(vehicle.throttle_demand.toFloat(), 0.5, 0.01);
}

}  // namespace
