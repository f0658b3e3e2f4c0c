// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/devices/random.hpp"

#include <gtest/gtest.h>

#include "simulator/devices/errors.hpp"
#include "statistics.hpp"

using simulator::Random;
using simulator::Wander;

TEST(Random, gives_the_same_bits_for_the_same_seed_and_stream) {
    Random a(7, 3), b(7, 3);
    for (int i = 0; i < 100; ++i) EXPECT_EQ(a.bits(), b.bits());
}

TEST(Random, gives_other_bits_for_another_seed_or_stream) {
    Random a(7, 3), seed(8, 3), stream(7, 4), shifted(6, 4);
    const uint64_t first = a.bits();
    EXPECT_NE(first, seed.bits());
    EXPECT_NE(first, stream.bits());
    EXPECT_NE(first, shifted.bits());
}

TEST(Random, draws_a_standard_normal_distribution) {
    Random random(1);
    Statistics drawn;
    int beyond_two_sigma = 0;
    for (int i = 0; i < 100'000; ++i) {
        drawn.add(random.normal());
        if (std::fabs(drawn.values.back()) > 2) ++beyond_two_sigma;
    }
    EXPECT_NEAR(drawn.mean(), 0, 0.01);
    EXPECT_NEAR(drawn.deviation(), 1, 0.01);
    EXPECT_NEAR(beyond_two_sigma / 100'000.0, 0.0455, 0.002);
}

TEST(Random, streams_of_one_seed_do_not_resemble_each_other) {
    Random a(1, 1), b(1, 2);
    Statistics first, second;
    for (int i = 0; i < 20'000; ++i) {
        first.add(a.normal());
        second.add(b.normal());
    }
    EXPECT_NEAR(correlation(first, second), 0, 0.02);
}

TEST(Wander, has_its_deviation_and_correlation_time_whatever_the_step) {
    for (double step_s : {0.5, 10.0}) {
        Statistics before, after;
        for (uint64_t seed = 1; seed <= 5000; ++seed) {
            Random random(seed);
            Wander wander(4, 300, random);
            before.add(wander.value());
            for (double t = 0; t < 300; t += step_s) wander.advance(step_s, random);
            after.add(wander.value());
        }
        EXPECT_NEAR(before.deviation(), 4, 0.2);
        EXPECT_NEAR(after.deviation(), 4, 0.2);
        EXPECT_NEAR(correlation(before, after), std::exp(-1), 0.05);
    }
}

TEST(SensorErrors, are_all_in_the_table_for_reports) {
    EXPECT_EQ(sizeof(simulator::SensorErrors) / sizeof(double),
              static_cast<size_t>(simulator::kErrorCount));
    for (int i = 0; i < simulator::kErrorCount; ++i)
        for (int j = 0; j < i; ++j)
            EXPECT_NE(simulator::kErrorRows[i].value, simulator::kErrorRows[j].value);
}

// docs/airplanes.md gives the figures for these; the devices' own tests hold them to the table.
TEST(SensorErrors, are_those_documented_with_the_figures) {
    const simulator::SensorErrors e;
    EXPECT_EQ(e.gyro_bias_dps, 0.6);
    EXPECT_EQ(e.gyro_noise_dps, 0.12);
    EXPECT_EQ(e.gyro_vibration_dps, 0.8);
    EXPECT_EQ(e.accel_bias_g, 0.004);
    EXPECT_EQ(e.accel_scale, 0);
    EXPECT_EQ(e.accel_noise_g, 0.006);
    EXPECT_EQ(e.accel_vibration_g, 0.08);
    EXPECT_EQ(e.compass_noise_mg, 2);
    EXPECT_EQ(e.baro_noise_pa, 2);
    EXPECT_EQ(e.baro_drift_pa, 4);
    EXPECT_EQ(e.baro_drift_s, 300);
    EXPECT_EQ(e.airspeed_noise_v, 0.003);
    EXPECT_EQ(e.gps_horizontal_m, 0.6);
    EXPECT_EQ(e.gps_vertical_m, 1.5);
    EXPECT_EQ(e.gps_wander_s, 60);
    EXPECT_EQ(e.gps_velocity_mps, 0.05);
    EXPECT_EQ(e.gps_age_s, 0.2);
    EXPECT_EQ(e.gps_rate_hz, 5);
    EXPECT_EQ(e.gust_mps, 1);
}
