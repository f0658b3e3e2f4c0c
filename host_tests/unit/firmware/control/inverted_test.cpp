// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/control/inverted.hpp"

#include <cmath>

#include "core/maths.hpp"
#include "firmware/control/attitude_control.hpp"
#include "firmware/guidance/bank.hpp"
#include "firmware_bench.hpp"
#include "host_tests/support/fakes/vehicle.hpp"

namespace {

using core::radians;
using firmware::control::surfaces;
using firmware::state::Mode;
using firmware::state::mutable_vehicle;
using firmware::state::parameters;
using firmware::state::Path;
using firmware::state::vehicle;

class Inverted : public bench::Bench {
protected:
    void SetUp() override {
        Bench::SetUp();
        mutable_vehicle.imu.periods = 2;
        mutable_vehicle.estimate.equivalent_airspeed_mps = parameters.scaling_speed_mps;
        attitude(0, 0);
        fly(Mode::fbwa);
    }
    static void attitude(float roll_deg, float pitch_deg) {
        auto& attitude = mutable_vehicle.attitude;
        const float roll_rad = radians(roll_deg), pitch_rad = radians(pitch_deg);
        attitude.roll_rad = core::Angle(roll_rad);
        attitude.pitch_rad = core::Angle(pitch_rad);
        attitude.sin_roll = core::Ratio(std::sin(roll_rad));
        attitude.cos_roll = core::Ratio(std::cos(roll_rad));
        attitude.sin_pitch = core::Ratio(std::sin(pitch_rad));
        attitude.cos_pitch = core::Ratio(std::cos(pitch_rad));
    }
    static void run() {
        firmware::modes::runMode();
        firmware::control::runInverted();
        for (int i = 0; i < 11; ++i) {
            firmware::modes::runMode();
            firmware::control::runAttitudeControl();
            prepareControl();
        }
    }
    static firmware::control::Surfaces at(float roll_deg, float pitch_deg) {
        attitude(roll_deg, pitch_deg);
        run();
        return surfaces;
    }
};

TEST_F(Inverted, is_level_on_its_back) {
    firmware::control::requestInverted(true);
    EXPECT_NEAR(at(179.9f, 0).aileron.toFloat(), 0, 0.02);
    EXPECT_GT(at(160, 0).aileron.toFloat(), 0.05f);
    EXPECT_LT(at(-160, 0).aileron.toFloat(), -0.05f);
}

TEST_F(Inverted, is_pushed_up) {
    firmware::control::requestInverted(true);
    EXPECT_LT(at(180, -10).elevator.toFloat(), -0.1f);
    firmware::control::requestInverted(false);
    (void)at(0, 0);
    firmware::control::requestInverted(true);
    EXPECT_GT(at(180, 10).elevator.toFloat(), 0.1f);
}

TEST_F(Inverted, turns_the_way_the_stick_does) {
    firmware::control::requestInverted(true);
    settle(with(1, 1800));
    const float right = at(180, 0).aileron.toFloat();
    settle(with(1, 1200));
    EXPECT_GT(right, 0.1f);
    EXPECT_LT(at(180, 0).aileron.toFloat(), -0.1f);
}

TEST_F(Inverted, is_reached_by_half_a_roll_to_the_right_and_left_the_same_way) {
    firmware::control::requestInverted(true);
    settle(with(1, 1200));
    for (const float roll_deg : {-5.0f, 0.0f, 5.0f, 90.0f, 115.0f})
        EXPECT_GT(at(roll_deg, 0).aileron.toFloat(), 0.5f)
            << roll_deg << ": whatever the stick asks for";
    firmware::control::requestInverted(false);
    for (const float roll_deg : {175.0f, -175.0f, -90.0f, -65.0f})
        EXPECT_GT(at(roll_deg, 0).aileron.toFloat(), 0.4f) << roll_deg;
}

TEST_F(Inverted, never_pulls_through) {
    firmware::control::requestInverted(true);
    (void)at(180, 0);
    firmware::control::requestInverted(false);
    EXPECT_LT(at(-175, -15).elevator.toFloat(), 0);
    EXPECT_NEAR(at(-90, -15).elevator.toFloat(), 0, 0.1);
    EXPECT_GT(at(-30, -15).elevator.toFloat(), 0.1f);
}

TEST_F(Inverted, an_airplane_thrown_over_rolls_upright_the_short_way_and_is_not_pulled_through) {
    EXPECT_LT(at(120, -15).aileron.toFloat(), -0.4f);
    EXPECT_LE(surfaces.elevator.toFloat(), 0);
    (void)at(0, 0);
    EXPECT_GT(at(-120, -15).aileron.toFloat(), 0.4f);
    EXPECT_LE(surfaces.elevator.toFloat(), 0);
    (void)at(0, 0);
    EXPECT_GT(at(0, -15).elevator.toFloat(), 0.1f);
}

TEST_F(Inverted, an_order_for_inverted_flight_ends_in_acro) {
    firmware::control::requestInverted(true);
    (void)at(180, 0);
    firmware::modes::requestMode(Mode::acro, firmware::modes::ModeReason::pilot);
    EXPECT_NEAR(at(180, 0).aileron.toFloat(), 0, 0.02);
    EXPECT_FALSE(vehicle.inverted);
}

TEST_F(Inverted, bank_is_counted_from_upside_down) {
    attitude(-160, 0);  // 20 degrees to the right of it
    mutable_vehicle.inverted = true;
    firmware::guidance::beginBanking();
    EXPECT_NEAR(firmware::guidance::expectedBank_mss(), core::kGravity_mss * std::tan(radians(20)),
                0.1);
    firmware::guidance::demandBank(100, firmware::guidance::BankLimit::flying);
    EXPECT_NEAR(vehicle.roll_demand_rad.toFloat(), radians(22.5f), 0.01);
    mutable_vehicle.inverted = false;
    firmware::guidance::demandBank(100, firmware::guidance::BankLimit::flying);
    EXPECT_NEAR(vehicle.roll_demand_rad.toFloat(), radians(45), 0.01);
}

TEST_F(Inverted, the_switch_turns_it_over_while_it_is_up) {
    parameters.inverted_channel = 6;
    settle(with(6, 1800));
    run();
    EXPECT_TRUE(vehicle.inverted);
    settle(with(6, 1700));
    run();
    EXPECT_FALSE(vehicle.inverted);
    settle(with(6, 1800));
    run();
    loseRadio(2000);
    run();
    EXPECT_FALSE(vehicle.inverted);
}

TEST_F(Inverted, is_flown_only_with_enough_height) {
    firmware::control::requestInverted(true);
    mutable_vehicle.estimate.height_m = 29;
    run();
    EXPECT_FALSE(vehicle.inverted);
    mutable_vehicle.estimate.height_m = 31;
    run();
    EXPECT_TRUE(vehicle.inverted);
    mutable_vehicle.estimate.height_m = 16;
    run();
    EXPECT_TRUE(vehicle.inverted);
    mutable_vehicle.estimate.height_m = 14;
    run();
    EXPECT_FALSE(vehicle.inverted);
}

TEST_F(Inverted, is_not_flown_on_the_ground_nor_in_manual_modes) {
    const auto flies = [] {
        firmware::control::requestInverted(true);
        run();
        return vehicle.inverted;
    };
    EXPECT_TRUE(flies());
    mutable_vehicle.estimate.flying = false;
    EXPECT_FALSE(flies());
    mutable_vehicle.estimate.flying = true;
    mutable_vehicle.armed = false;
    EXPECT_FALSE(flies());
    mutable_vehicle.armed = true;
    for (const Mode mode : {Mode::manual, Mode::training, Mode::acro}) {
        firmware::modes::requestMode(mode, firmware::modes::ModeReason::pilot);
        EXPECT_FALSE(flies()) << static_cast<int>(mode);
    }
    for (const Mode mode : {Mode::stabilize, Mode::fbwa, Mode::fbwb, Mode::circle, Mode::loiter}) {
        firmware::modes::requestMode(mode, firmware::modes::ModeReason::pilot);
        EXPECT_TRUE(flies()) << static_cast<int>(mode);
    }
}

TEST_F(Inverted, neither_takes_off_nor_lands) {
    firmware::modes::requestMode(Mode::loiter, firmware::modes::ModeReason::pilot);
    firmware::control::requestInverted(true);
    for (const Path path : {Path::takeoff, Path::land}) {
        mutable_vehicle.demand.path = path;
        run();
        EXPECT_FALSE(vehicle.inverted);
        mutable_vehicle.demand.path = Path::circle;
        run();
        EXPECT_TRUE(vehicle.inverted);
    }
}

}  // namespace
