// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivers/airspeed.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace {

using drivers::Airspeed;
using drivers::AirspeedSettings;

// Four readings of the sensor at this pressure.
uint16_t readings(double pressure_pa, double zero_v = 2.5) {
    return static_cast<uint16_t>(std::lround(4 * 1024 * (zero_v + pressure_pa / 1000) / 5));
}
void feed(Airspeed& airspeed, uint16_t sum, double for_s, AirspeedSettings settings = {}) {
    for (double t = 0; t < for_s; t += 0.02)
        airspeed.update(Airspeed::share(sum, 4), 20000, settings);
}
double pressure(double speed_mps) { return 0.5 * 1.225 * speed_mps * speed_mps; }

TEST(Airspeed, reads_equivalent_airspeed_after_a_second_in_still_air) {
    Airspeed airspeed;
    feed(airspeed, readings(0, 2.43), 1.2);
    ASSERT_TRUE(airspeed.calibrated());
    for (double speed_mps : {8.0, 12.0, 25.0, 50.0}) {
        feed(airspeed, readings(pressure(speed_mps), 2.43), 2);
        EXPECT_NEAR(airspeed.speed_mps(), speed_mps, 0.15);
    }
    EXPECT_NEAR(airspeed.offset_v(), 2.43, 0.002);
    EXPECT_TRUE(airspeed.healthy());
}

TEST(Airspeed, is_unhealthy_until_its_zero_is_known) {
    Airspeed airspeed;
    feed(airspeed, readings(0), 0.5);
    EXPECT_FALSE(airspeed.healthy());

    feed(airspeed, readings(0), 0.7);
    EXPECT_TRUE(airspeed.healthy());
}

TEST(Airspeed, takes_no_zero_from_an_input_with_nothing_on_it) {
    Airspeed airspeed;
    feed(airspeed, 0, 5);
    feed(airspeed, 4 * 1023, 5);

    EXPECT_FALSE(airspeed.calibrated());
    EXPECT_FALSE(airspeed.healthy());
}

// The MPXV7002DP's is 2.5 V within 0.25 V, the MPXV5004DP's 1 V within 0.25 V, either in proportion
// to a supply that APM 1 does not measure.
TEST(Airspeed, takes_the_zero_of_either_sensor_at_any_supply) {
    for (const double sensor_v : {2.26, 2.5, 2.74, 0.76, 1.0, 1.24}) {
        for (const double supply_v : {4.7, 5.0, 5.3}) {
            const double zero_v = sensor_v * supply_v / 5;
            Airspeed airspeed;
            feed(airspeed, readings(0, zero_v), 1.2);
            ASSERT_TRUE(airspeed.calibrated()) << zero_v;
            EXPECT_NEAR(airspeed.offset_v(), zero_v, 0.002);
        }
    }
}

TEST(Airspeed, takes_no_zero_that_neither_sensor_has) {
    for (const double zero_v : {0.3, 0.65, 1.4, 1.8, 2.05, 3.0, 4.0}) {
        Airspeed airspeed;
        feed(airspeed, readings(0, zero_v), 5);
        EXPECT_FALSE(airspeed.calibrated()) << zero_v;
    }
}

TEST(Airspeed, reads_a_sensor_of_one_direction_and_sees_its_wire_break) {
    Airspeed airspeed;
    feed(airspeed, readings(0, 1.0), 1.2);
    for (double speed_mps : {8.0, 25.0, 60.0}) {
        feed(airspeed, readings(pressure(speed_mps), 1.0), 2);
        EXPECT_NEAR(airspeed.speed_mps(), speed_mps, 0.15);
    }
    EXPECT_TRUE(airspeed.healthy());
    feed(airspeed, 0, 2);
    EXPECT_FALSE(airspeed.healthy());
    feed(airspeed, readings(100, 1.0), 3);
    EXPECT_TRUE(airspeed.healthy());
    feed(airspeed, 4 * 1023, 2);
    EXPECT_FALSE(airspeed.healthy());
}

TEST(Airspeed, a_zero_that_is_known_is_not_measured_again) {
    AirspeedSettings settings;
    settings.offset_known = true;
    settings.offset_v = 2.45f;
    Airspeed airspeed;
    feed(airspeed, readings(pressure(15), 2.45), 2, settings);

    EXPECT_NEAR(airspeed.speed_mps(), 15, 0.15);
}

TEST(Airspeed, a_hose_gone_or_a_wire_broken_shows_within_two_seconds) {
    for (uint16_t sum : {readings(-60), uint16_t{0}, uint16_t{4 * 1023}}) {
        Airspeed airspeed;
        feed(airspeed, readings(0), 1.2);
        feed(airspeed, readings(100), 3);
        feed(airspeed, sum, 2);
        EXPECT_FALSE(airspeed.healthy()) << sum;
        feed(airspeed, readings(100), 3);
        EXPECT_TRUE(airspeed.healthy()) << sum;
    }
}

TEST(Airspeed, with_hoses_either_way_round_the_sign_does_not_matter) {
    AirspeedSettings settings;
    settings.either_tube = true;
    Airspeed airspeed;
    feed(airspeed, readings(0), 1.2, settings);
    feed(airspeed, readings(-pressure(15)), 2, settings);

    EXPECT_NEAR(airspeed.speed_mps(), 15, 0.15);
    EXPECT_TRUE(airspeed.healthy());
}

TEST(Airspeed, a_share_is_the_mean_reading_whatever_their_number) {
    for (uint8_t count = 1; count <= 60; ++count)
        for (uint16_t sum = 0; sum <= 1023 * count; sum += 1 + count / 3)
            ASSERT_EQ(Airspeed::share(sum, count), std::floor(64.0 * sum / count));
}

TEST(Airspeed, its_filter_is_within_a_fifth_of_a_pascal_of_the_exact_one) {
    std::mt19937 random(1);
    std::uniform_int_distribution<int> share(20000, 64000), dt_us(0, 300000);
    Airspeed airspeed;
    airspeed.resume(2.5f);
    double expected_pa = 0;
    for (int i = 0; i < 5000; ++i) {
        const uint16_t now = static_cast<uint16_t>(share(random));
        const uint32_t passed_us = static_cast<uint32_t>(i % 2 ? dt_us(random) : 20000);
        airspeed.update(now, passed_us, {});
        const double part = std::min(passed_us / 0.17e6, 1.0);
        expected_pa += ((now / 65536.0 - 0.5) * 5000 - expected_pa) * part;
        ASSERT_NEAR(airspeed.pressure_pa(), expected_pa, 0.2) << i;
    }
}

}  // namespace
