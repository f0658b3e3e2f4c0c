// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivers/mpu6000.hpp"

#include <gtest/gtest.h>

#include "model_bus.hpp"

namespace {

using drivers::ImuSample;

struct Mpu6000 : ::testing::Test {
    model::Bench bench;
    static inline model::Imu* imu = nullptr;
    model::Imu driver;
    model::Barometer barometer;
    uint32_t taken = 0, covered = 0;
    ImuSample last{};

    Mpu6000() { connect(); }
    ~Mpu6000() override { imu = nullptr; }
    void connect() {
        imu = &driver;
        bench.interrupt = [] { imu->onDataReady(); };
        driver.start();
    }
    // Frames of 10 ms, less exact than a crystal.
    void fly(uint32_t for_ms, bool with_barometer = false) {
        const uint64_t end_us = bench.now_us + for_ms * 1000ull;
        for (uint32_t n = 0; bench.now_us < end_us; ++n) {
            bench.advance_us(9900 + n * 37 % 200);
            driver.step(static_cast<uint32_t>(bench.now_us / 1000));
            if (with_barometer) barometer.step(static_cast<uint32_t>(bench.now_us));
            ImuSample sample;
            if (!driver.take(sample)) continue;
            last = sample;
            taken += sample.count;
            covered += sample.periods;
        }
    }
};

TEST_F(Mpu6000, starts_within_a_third_of_a_second_and_measures_gravity) {
    fly(330);

    EXPECT_TRUE(driver.healthy());
    EXPECT_NEAR(last.force_mss.x, 0, 0.01);
    EXPECT_NEAR(last.force_mss.y, 0, 0.01);
    EXPECT_NEAR(last.force_mss.z, -9.80665, 0.01);
    EXPECT_EQ(last.count, 2);
    EXPECT_EQ(driver.restarts(), 0);
}

TEST_F(Mpu6000, turns_the_chips_axes_into_the_airplanes) {
    bench.truth.roll_rate_rads = 0.1;
    bench.truth.pitch_rate_rads = -0.2;
    bench.truth.yaw_rate_rads = 0.3;
    bench.truth.force_x_mss = 1;
    bench.truth.force_y_mss = 2;

    fly(500);

    EXPECT_NEAR(last.rate_rads.x, 0.1, 0.002);
    EXPECT_NEAR(last.rate_rads.y, -0.2, 0.002);
    EXPECT_NEAR(last.rate_rads.z, 0.3, 0.002);
    EXPECT_NEAR(last.force_mss.x, 1, 0.01);
    EXPECT_NEAR(last.force_mss.y, 2, 0.01);
}

TEST_F(Mpu6000, loses_no_sample_and_takes_none_twice_while_the_barometer_shares_the_bus) {
    barometer.start();
    fly(500, true);
    const simulator::SampleCount before = bench.imu.samples();
    taken = 0;

    fly(60000, true);

    const simulator::SampleCount after = bench.imu.samples();
    EXPECT_NEAR(after.made - before.made, 12000, 5);
    EXPECT_LE(after.made - before.made - taken, 2u);  // the newest may not be taken yet
    EXPECT_EQ(after.lost, before.lost);
    EXPECT_EQ(after.repeated, before.repeated);
    EXPECT_EQ(driver.badReads(), 0);
    EXPECT_TRUE(barometer.healthy());
}

TEST_F(Mpu6000, means_the_same_on_silicon_of_half_sensitivity) {
    model::Bench other(simulator::SensorErrors::none(), simulator::Mpu6000::kRevisionC4);
    bench.now_us = 0;
    other.interrupt = [] { imu->onDataReady(); };
    for (int n = 0; n < 50; ++n) {
        other.advance_us(10000);
        driver.step(static_cast<uint32_t>(other.now_us / 1000));
        driver.take(last);
    }

    EXPECT_NEAR(last.force_mss.z, -9.80665, 0.01);
    model::Bench::current = &bench;
}

TEST_F(Mpu6000, unplugged_turns_unhealthy_and_comes_back_when_plugged_in) {
    fly(500);
    bench.imu_unplugged = true;
    fly(100);
    EXPECT_FALSE(driver.healthy());

    fly(3000);
    EXPECT_FALSE(driver.healthy());

    bench.imu_unplugged = false;
    fly(600);
    EXPECT_TRUE(driver.healthy());
    EXPECT_GE(driver.restarts(), 1);
}

TEST_F(Mpu6000, never_there_is_never_healthy_whatever_the_bus_floats_to) {
    bench.imu_unplugged = true;
    for (uint8_t level : {0x00, 0xFF, 0x68}) {
        bench.floating = level;
        fly(1500);
        EXPECT_FALSE(driver.healthy());
        EXPECT_EQ(taken, 0u);
    }
}

TEST_F(Mpu6000, a_bus_gone_dead_under_a_running_interrupt_is_not_a_measurement) {
    fly(500);
    taken = covered = 0;
    bench.floating = 0;
    bench.imu_unplugged = true;
    for (int n = 0; n < 4; ++n) driver.onDataReady();
    bench.floating = 0xFF;
    driver.onDataReady();
    fly(20);

    EXPECT_EQ(taken, 0u);
    EXPECT_EQ(covered, 0u);
    EXPECT_GE(driver.badReads(), 5);
    EXPECT_EQ(driver.restarts(), 1);
}

TEST_F(Mpu6000, goes_on_after_an_edge_that_nobody_saw) {
    fly(500);
    bench.lose_next_edge = true;
    fly(100);

    EXPECT_TRUE(driver.healthy());
    EXPECT_EQ(driver.restarts(), 0);
    EXPECT_NEAR(last.force_mss.z, -9.80665, 0.01);
}

TEST_F(Mpu6000, gives_the_mean_since_the_last_take_however_long_that_was) {
    fly(500);
    bench.truth.roll_rate_rads = 1;
    bench.advance_us(100000);
    driver.take(last);
    bench.advance_us(100000);
    ImuSample sample{};

    EXPECT_EQ(driver.waiting(), 20);
    EXPECT_TRUE(driver.take(sample));
    EXPECT_EQ(sample.count, 20);
    EXPECT_EQ(sample.periods, 20);
    EXPECT_NEAR(sample.rate_rads.x, 1, 0.002);
    EXPECT_FALSE(driver.take(sample));
}

TEST_F(Mpu6000, not_taken_for_seconds_neither_overflows_nor_stops) {
    fly(500);
    bench.advance_us(10'000'000);
    ImuSample sample{};

    EXPECT_TRUE(driver.take(sample));
    EXPECT_EQ(sample.periods, 255);
    EXPECT_NEAR(sample.force_mss.z, -9.80665, 0.01);
    fly(50);
    EXPECT_TRUE(driver.healthy());
}

}  // namespace
