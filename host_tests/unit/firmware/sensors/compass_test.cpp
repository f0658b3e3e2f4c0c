// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <vector>

#include "firmware/sensors/compass_learning.hpp"
#include "firmware/sensors/devices.hpp"
#include "firmware/sensors/health.hpp"
#include "firmware/sensors/sensors.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware/state/vehicle.hpp"
#include "host_tests/support/fakes/fakes.hpp"
#include "host_tests/support/fakes/vehicle.hpp"
#include "simulator/devices/hmc5883l.hpp"

namespace {

using firmware::state::mutable_vehicle;
using firmware::state::parameters;

struct Declination : testing::Test {
    void SetUp() override {
        parameters.compass_auto_declination = 1;
        parameters.compass_declination_rad = 0.25f;
        mutable_vehicle.gps.fix = firmware::state::GpsFix::three_d;
        mutable_vehicle.gps.position = {400150000,
                                        -1052700000};  // Boulder, 7.6 degrees east in 2027
    }
};

TEST_F(Declination, comes_from_the_table_where_the_airplane_is) {
    firmware::sensors::runDeclination();
    EXPECT_NEAR(core::degrees(parameters.compass_declination_rad), 7.6f, 0.5f);
}

TEST_F(Declination, comes_with_which_way_the_field_points) {
    parameters.compass_auto_declination = 0;
    firmware::sensors::runDeclination();
    EXPECT_EQ(firmware::state::vehicle.compass.points_down, 1);
    mutable_vehicle.gps.position.latitude_e7 = -330000000;
    firmware::sensors::runDeclination();
    EXPECT_EQ(firmware::state::vehicle.compass.points_down, -1);
}

TEST_F(Declination, stays_as_it_was_set_without_a_fix) {
    mutable_vehicle.gps.fix = firmware::state::GpsFix::two_d;
    firmware::sensors::runDeclination();
    EXPECT_EQ(parameters.compass_declination_rad, 0.25f);
}

TEST_F(Declination, stays_as_it_was_set_when_the_table_is_not_wanted) {
    parameters.compass_auto_declination = 0;
    firmware::sensors::runDeclination();
    EXPECT_EQ(parameters.compass_declination_rad, 0.25f);
}

void beginFlight(float stored_mg, bool healthy) {
    parameters.compass_learn = 1;
    for (float& offset_mg : parameters.compass.offset_mg) offset_mg = stored_mg;
    firmware::sensors::noteStoredOffsets();
    mutable_vehicle.armed = mutable_vehicle.estimate.flying = true;
    mutable_vehicle.compass.healthy = healthy;
}

// What two circles teach when the compass is off by 60 mG to the right.
float learntInFlight_mg(bool healthy) {
    beginFlight(0, healthy);
    for (int degree = 0; degree < 720; ++degree) {
        const float heading_rad = core::radians(static_cast<float>(degree));
        const int16_t reading_mg[3] = {
            static_cast<int16_t>(std::lround(250 * std::cos(heading_rad))),
            static_cast<int16_t>(std::lround(60 - 250 * std::sin(heading_rad))), 350};
        firmware::sensors::learnCompass(reading_mg);
    }
    return parameters.compass.offset_mg[1];
}

TEST(CompassLearning, takes_nothing_from_a_compass_that_is_known_to_fail) {
    EXPECT_LT(learntInFlight_mg(true), -10);
    EXPECT_EQ(learntInFlight_mg(false), 0);
}

// By how much an offset that is right is moved in four circles, in which the motor adds 20 mG every
// now and then that nobody has learnt.
float mostMoved_mg(float stored_mg) {
    beginFlight(stored_mg, true);
    float most_mg = 0;
    for (int degree = 0; degree < 1440; ++degree) {
        const float heading_rad = core::radians(static_cast<float>(degree));
        const float motor_mg = degree / 60 % 2 == 0 ? 20.0f : 0.0f;
        const int16_t reading_mg[3] = {
            static_cast<int16_t>(std::lround(250 * std::cos(heading_rad) + motor_mg - stored_mg)),
            static_cast<int16_t>(std::lround(-250 * std::sin(heading_rad) - stored_mg)), 350};
        firmware::sensors::learnCompass(reading_mg);
        most_mg = std::max(most_mg, std::fabs(parameters.compass.offset_mg[1] - stored_mg));
    }
    return most_mg;
}

TEST(CompassLearning, keeps_offsets_that_were_stored_when_a_reading_is_off) {
    EXPECT_LT(mostMoved_mg(5), 8);
    EXPECT_GT(mostMoved_mg(0), 8) << "in the first flight they have to be found";
}

// The estimator's share of what it finds a reading to show of the airplane, five times a second.
struct MotorsField : testing::Test {
    static constexpr float kOffset_mg[3] = {15, -8, 20}, kMotor_mg[3] = {25, -40, 10};
    MotorsField() {
        parameters.compass = {};
        mutable_vehicle.armed = true;
    }
    ~MotorsField() override {
        mutable_vehicle.throttle_demand = core::Ratio(0);
        parameters.compass = {};
    }
    // Ten seconds with each throttle, again and again.
    void fly(std::initializer_list<float> throttles, int times, float offset_share = 1) {
        for (int i = 0; i < times; ++i)
            for (const float throttle : throttles) hold(throttle, offset_share);
    }
    void hold(float throttle, float offset_share) {
        constexpr float kShare = 0.2f / 15;
        mutable_vehicle.throttle_demand = core::Ratio(throttle);
        for (int reading = 0; reading < 50; ++reading) {
            float own[3];
            for (int i = 0; i < 3; ++i)
                own[i] = kShare *
                         (kOffset_mg[i] * offset_share + parameters.compass.offset_mg[i] +
                          (kMotor_mg[i] + parameters.compass.motor_mg[i]) * throttle * throttle);
            core::Vector3 own_mg = {own[0], own[1], own[2]};
            firmware::sensors::takeCompassOffset(own_mg);
        }
    }
};
constexpr float MotorsField::kOffset_mg[3], MotorsField::kMotor_mg[3];

TEST_F(MotorsField, is_separated_from_the_offsets_by_the_throttle) {
    fly({0.9f, 0.4f, 0.6f, 0.2f}, 30);
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(parameters.compass.motor_mg[i], -kMotor_mg[i], 2);
        EXPECT_NEAR(parameters.compass.offset_mg[i], -kOffset_mg[i], 1);
    }
}

TEST_F(MotorsField, counts_as_an_offset_while_the_throttle_stays) {
    fly({0.5f}, 60);
    const auto before = parameters.compass;
    fly({0.5f}, 60);
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(parameters.compass.motor_mg[i], before.motor_mg[i], 0.1);
        EXPECT_NEAR(parameters.compass.offset_mg[i] + parameters.compass.motor_mg[i] * 0.25f,
                    -kOffset_mg[i] - kMotor_mg[i] * 0.25f, 1);
    }
}

// 20 times the offset: as a reading is off before the first turns, or beside a magnet.
TEST_F(MotorsField, is_not_learnt_at_once_from_a_reading_that_is_far_off) {
    fly({0.9f}, 1, 20);
    for (int i = 0; i < 3; ++i) EXPECT_LT(std::fabs(parameters.compass.motor_mg[i]), 20);
}

TEST_F(MotorsField, goes_with_the_square_of_the_throttle_of_a_motor_that_may_turn) {
    mutable_vehicle.throttle_demand = core::Ratio(0.5f);
    EXPECT_NEAR(firmware::sensors::motorPower(), 0.25f, 1e-3);
    mutable_vehicle.armed = false;
    EXPECT_EQ(firmware::sensors::motorPower(), 0);
}

// A chip that repeats itself, in an airplane that turns, while the throttle moves.
TEST(StuckCompass, is_found_while_what_is_added_for_the_motor_changes) {
    fakes::reset();
    simulator::Hmc5883l chip(1, simulator::SensorErrors::none());
    chip.sense({200, -50, 430});
    uint64_t now_us = 0;
    fakes::i2c().device = [&](const fakes::I2cTransfer& transfer) {
        std::vector<uint8_t> in;
        chip.start(false, now_us);
        for (const uint8_t byte : transfer.out) chip.write(byte, now_us);
        if (transfer.in_size > 0) chip.start(true, now_us);
        for (int i = 0; i < transfer.in_size; ++i)
            in.push_back(chip.read(i + 1 < transfer.in_size, now_us));
        chip.stop(now_us);
        return in;
    };
    parameters.compass = {{0, 0, 0}, {60, -50, 40}};
    mutable_vehicle.imu.rate_rads.z = core::BodyRate(0.3f);
    mutable_vehicle.armed = mutable_vehicle.estimate.flying = true;
    firmware::sensors::startHealth();
    firmware::sensors::startCompass();
    bool worked = false;
    for (int step = 0; step < 500; ++step) {
        now_us += 20000;
        fakes::advance_ms(20);
        mutable_vehicle.throttle_demand =
            core::Ratio(0.3f + 0.002f * static_cast<float>(step % 200));
        firmware::sensors::runCompass();
        if (step % 5 == 0) firmware::sensors::watchHealth();
        worked = worked || firmware::state::vehicle.compass.healthy;
    }
    EXPECT_TRUE(worked);
    EXPECT_TRUE(firmware::sensors::isFaulty(firmware::sensors::Sensor::compass));
    firmware::sensors::startHealth();
    mutable_vehicle.imu.rate_rads = {};
    mutable_vehicle.throttle_demand = core::Ratio(0);
    mutable_vehicle.armed = mutable_vehicle.estimate.flying = false;
    parameters.compass = {};
}

}  // namespace
