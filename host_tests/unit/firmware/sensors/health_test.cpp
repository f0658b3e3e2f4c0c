// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/sensors/health.hpp"

#include <random>

#include "firmware_bench.hpp"
#include "host_tests/support/fakes/vehicle.hpp"

namespace {

using firmware::sensors::acceptReading;
using firmware::sensors::isFaulty;
using firmware::sensors::Sensor;
using firmware::state::mutable_vehicle;

struct Rhythm {
    Sensor sensor;
    int per_tenth;   // readings
    int16_t quiet;   // how far they scatter in health
    int16_t beyond;  // a jump that is none of nature's
    int stuck_tenths;
};
const Rhythm kRhythms[] = {{Sensor::inertial, 10, 300, 9000, 2},
                           {Sensor::barometer, 8, 8, 500, 10},
                           {Sensor::airspeed, 5, 20, 700, 250},
                           {Sensor::compass, 5, 8, 400, 20}};

class Health : public testing::TestWithParam<Rhythm> {
protected:
    void SetUp() override {
        mutable_vehicle.estimate.flying = true;
        tenths(50, 0);
        ASSERT_FALSE(isFaulty());
        mutable_vehicle.gps.fix = firmware::state::GpsFix::none;
    }
    bool isFaulty() const { return firmware::sensors::isFaulty(GetParam().sensor); }
    int16_t scattered(int16_t by) {
        return static_cast<int16_t>(std::uniform_int_distribution<int>(-by, by)(random_));
    }
    // One reading in `odd_every` is a wild one; 0: none, 1: all.
    int tenths(int count, int odd_every) {
        int accepted = 0;
        for (int i = 0; i < count * GetParam().per_tenth; ++i) {
            const bool odd = odd_every != 0 && i % odd_every == 0;
            const int16_t wild = i % 2 == 0 ? GetParam().beyond : -GetParam().beyond;
            const int16_t reading = odd ? wild : scattered(GetParam().quiet);
            accepted += acceptReading(GetParam().sensor, reading, true);
            if (i % GetParam().per_tenth == 0) firmware::sensors::watchHealth();
        }
        return accepted;
    }
    void silence(int tenths) {
        for (int i = 0; i < tenths; ++i) firmware::sensors::watchHealth();
    }
    void stuck(int tenths) {
        for (int i = 0; i < tenths * GetParam().per_tenth; ++i) {
            acceptReading(GetParam().sensor, 5, true);
            if (i % GetParam().per_tenth == 0) firmware::sensors::watchHealth();
        }
    }
    std::minstd_rand random_{1};
};

TEST_P(Health, a_healthy_sensor_stays_healthy) {
    EXPECT_EQ(tenths(100, 0), 100 * GetParam().per_tenth);
}

TEST_P(Health, a_sensor_that_still_starts_after_a_restart_in_the_air_is_no_fault) {
    firmware::sensors::startHealth();
    silence(100);
    EXPECT_FALSE(isFaulty());
    tenths(1, 0);
    silence(31);
    EXPECT_TRUE(isFaulty());
}

TEST_P(Health, a_silent_sensor_is_noticed_within_two_seconds) {
    silence(21);
    EXPECT_TRUE(isFaulty());
}

// What the airplane does in the seconds in which each must change.
void climb(bool on) { mutable_vehicle.gps.velocity_mps.z = on ? -0.6f : 0; }
void turn(bool on) { mutable_vehicle.imu.rate_rads.z = core::BodyRate(on ? 0.12f : 0); }

TEST_P(Health, a_stuck_value_is_noticed_while_the_airplane_moves_and_not_used_while_it_lasts) {
    climb(true);
    turn(true);
    stuck(GetParam().stuck_tenths - 2);
    EXPECT_FALSE(isFaulty());
    stuck(3);
    EXPECT_TRUE(isFaulty());
    stuck(100);
    EXPECT_TRUE(isFaulty());
    climb(false);
    turn(false);
    stuck(100);
    EXPECT_TRUE(isFaulty());
}

TEST(HealthInCalmAir, a_quiet_barometer_and_compass_may_repeat_their_values) {
    mutable_vehicle.estimate.flying = true;
    mutable_vehicle.gps.fix = firmware::state::GpsFix::three_d;
    for (Sensor each : {Sensor::barometer, Sensor::compass}) {
        firmware::sensors::startHealth();
        climb(each == Sensor::compass);
        turn(each == Sensor::barometer);
        for (int i = 0; i < 1000; ++i) {
            acceptReading(each, 5, true);
            acceptReading(Sensor::gps, static_cast<int16_t>(i), true);
            if (i % 5 == 0) firmware::sensors::watchHealth();
        }
        EXPECT_FALSE(isFaulty(each));
    }
    mutable_vehicle.gps.fix = firmware::state::GpsFix::none;
    firmware::sensors::startHealth();
    climb(false);
    for (int i = 0; i < 60; ++i) {
        acceptReading(Sensor::barometer, 5, true);
        if (i % 5 == 0) firmware::sensors::watchHealth();
    }
    EXPECT_TRUE(isFaulty(Sensor::barometer)) << "without fixes nobody sees it climb";
}

TEST_P(Health, a_value_stuck_while_another_of_the_sensor_changes_is_no_fault) {
    for (int i = 0; i < 100; ++i) {
        stuck(1);
        firmware::sensors::reportChange(GetParam().sensor);
    }
    EXPECT_FALSE(isFaulty());
}

TEST_P(Health, outliers_are_not_used_and_are_noticed_within_half_a_second) {
    EXPECT_LE(tenths(5, 1), 1);
    EXPECT_TRUE(isFaulty());
}

TEST_P(Health, impossible_values_are_noticed) {
    for (int i = 0; i < 5 * GetParam().per_tenth; ++i)
        EXPECT_FALSE(acceptReading(GetParam().sensor, scattered(5), false));
    firmware::sensors::watchHealth();
    EXPECT_TRUE(isFaulty());
}

TEST_P(Health, a_single_outlier_is_ignored_and_the_sensor_stays_healthy) {
    EXPECT_LE(tenths(100, 100), 99 * GetParam().per_tenth);
    EXPECT_FALSE(isFaulty());
}

TEST_P(Health, a_sensor_is_healthy_again_after_some_seconds_of_good_values) {
    mutable_vehicle.gps.fix = firmware::state::GpsFix::three_d;
    silence(25);
    ASSERT_TRUE(isFaulty());
    tenths(10, 0);
    EXPECT_TRUE(isFaulty()) << "not at once";
    tenths(70, 0);
    EXPECT_FALSE(isFaulty());
}

// A tube whose zero has jumped was used again without fixes, and the airplane dived for its speed.
TEST(HealthWithoutFixes, an_airspeed_that_was_wrong_is_not_used_again) {
    using firmware::state::GpsFix;
    mutable_vehicle.estimate.flying = true;
    firmware::sensors::startHealth();
    const auto readings = [](int count) {
        for (int i = 0; i < count; ++i) {
            acceptReading(Sensor::airspeed, static_cast<int16_t>(i % 7), true);
            if (i % 5 == 0) firmware::sensors::watchHealth();
        }
    };
    readings(10);
    for (int i = 0; i < 6; ++i) firmware::sensors::reportInconsistency(Sensor::airspeed);
    mutable_vehicle.gps.fix = GpsFix::none;
    readings(1000);
    EXPECT_TRUE(isFaulty(Sensor::airspeed));
    mutable_vehicle.gps.fix = GpsFix::three_d;
    readings(400);
    EXPECT_FALSE(isFaulty(Sensor::airspeed));
}

TEST_P(Health, disagreement_with_the_other_sensors_is_enough) {
    for (int i = 0; i < 6; ++i) firmware::sensors::reportInconsistency(GetParam().sensor);
    firmware::sensors::watchHealth();
    EXPECT_TRUE(isFaulty());
}

TEST_P(Health, no_sensor_is_rejected_on_the_ground) {
    mutable_vehicle.estimate.flying = false;
    silence(100);
    EXPECT_FALSE(isFaulty());
    EXPECT_TRUE(acceptReading(GetParam().sensor, 30000, false));
}

INSTANTIATE_TEST_SUITE_P(Each, Health, testing::ValuesIn(kRhythms),
                         [](const auto& each) { return std::to_string(int(each.param.sensor)); });

}  // namespace
