// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/devices/mpu6000.hpp"

#include <gtest/gtest.h>

#include <array>

#include "simulator/world.hpp"
#include "statistics.hpp"

using namespace simulator;

namespace {

constexpr double kGravity = 9.80665, kRadians = M_PI / 180;

Truth level() {
    Truth truth{};
    truth.force_z_mss = -kGravity;
    return truth;
}

struct Sample {
    std::array<int16_t, 3> accel, gyro;
    int16_t temperature;
    uint8_t status;
};

// A driver's view of the chip, with the time going on by itself.
struct Bench {
    explicit Bench(SensorErrors errors = SensorErrors::none(), uint64_t seed = 1,
                   uint8_t product = Mpu6000::kRevisionD8)
        : imu(seed, errors, product) {}

    void write(uint8_t reg, uint8_t value) {
        imu.select(true, now_us);
        imu.transfer(reg, now_us);
        imu.transfer(value, now_us);
        imu.select(false, now_us);
    }
    uint8_t read(uint8_t reg) {
        imu.select(true, now_us);
        imu.transfer(reg | 0x80, now_us);
        const uint8_t value = imu.transfer(0, now_us);
        imu.select(false, now_us);
        return value;
    }
    void wake(uint8_t filter, uint8_t divider) {
        now_us = 95'000;
        write(0x6B, 0x03);  // the first order wakes it up, but a moment later
        now_us = 100'000;
        for (auto [reg, value] : {std::pair<uint8_t, uint8_t>{0x6B, 0x03},
                                  {0x1A, filter},
                                  {0x19, divider},
                                  {0x1B, 0x18},
                                  {0x1C, 0x10},
                                  {0x38, 0x01},
                                  {0x37, 0x30}})
            write(reg, value);
    }
    void sample(const Truth& truth) {
        now_us = imu.nextSample_us();
        imu.sample(truth, now_us);
    }
    Sample burst() {
        Sample out;
        imu.select(true, now_us);
        imu.transfer(0x3A | 0x80, now_us);
        out.status = imu.transfer(0, now_us);
        for (int16_t& value : out.accel) value = word();
        out.temperature = word();
        for (int16_t& value : out.gyro) value = word();
        imu.select(false, now_us);
        return out;
    }
    int16_t word() {
        const uint8_t high = imu.transfer(0, now_us);
        return static_cast<int16_t>(high << 8 | imu.transfer(0, now_us));
    }
    Sample next(const Truth& truth) {
        sample(truth);
        return burst();
    }

    Mpu6000 imu;
    uint64_t now_us = 0;
};

}  // namespace

TEST(Mpu6000, is_asleep_after_power_on_with_the_reset_values_of_the_data_sheet) {
    Bench bench;
    bench.now_us = 50'000;
    for (uint8_t reg = 0; reg < 0x80; ++reg) {
        const uint8_t expected = reg == 0x6B ? 0x40 : reg == 0x75 ? 0x68 : reg == 0x0C ? 0x58 : 0;
        EXPECT_EQ(bench.read(reg), expected) << int{reg};
    }
    EXPECT_EQ(bench.imu.nextSample_us(), UINT64_MAX);
}

TEST(Mpu6000, does_not_answer_before_it_has_started_and_again_after_a_reset) {
    Bench bench;
    bench.now_us = 10'000;
    EXPECT_EQ(bench.read(0x75), 0);
    bench.now_us = 12'000;
    EXPECT_EQ(bench.read(0x75), 0x68);
    bench.write(0x19, 4);
    bench.write(0x6B, 0x80);
    EXPECT_EQ(bench.read(0x75), 0);
    bench.now_us += 11'000;
    EXPECT_EQ(bench.read(0x19), 0);
    EXPECT_EQ(bench.read(0x6B), 0x40);
}

TEST(Mpu6000, keeps_what_is_read_only) {
    Bench bench;
    bench.now_us = 50'000;
    for (uint8_t reg : {0x0C, 0x3A, 0x3B, 0x48, 0x60, 0x75}) bench.write(reg, 0xA5);
    EXPECT_EQ(bench.read(0x0C), 0x58);
    EXPECT_EQ(bench.read(0x3B), 0);
    EXPECT_EQ(bench.read(0x75), 0x68);
}

TEST(Mpu6000, samples_at_the_rate_of_its_divider) {
    struct Case {
        uint8_t filter, divider;
        uint64_t period_us;
    };
    for (Case c : {Case{3, 4, 5000}, {3, 0, 1000}, {6, 9, 10'000}, {0, 7, 1000}, {0, 0, 125}}) {
        Bench bench;
        bench.wake(c.filter, c.divider);
        bench.sample(level());
        const uint64_t first_us = bench.now_us;
        bench.sample(level());
        EXPECT_EQ(bench.now_us - first_us, c.period_us);
    }
}

TEST(Mpu6000, sits_on_the_board_with_body_x_along_chip_y_and_z_up) {
    Bench bench;
    bench.wake(3, 4);
    Truth truth{};
    truth.force_x_mss = 0.25 * kGravity;
    truth.force_y_mss = 0.5 * kGravity;
    truth.force_z_mss = -1.0 * kGravity;
    truth.roll_rate_rads = 10 * kRadians;
    truth.pitch_rate_rads = 20 * kRadians;
    truth.yaw_rate_rads = 30 * kRadians;
    const Sample s = bench.next(truth);
    EXPECT_EQ(s.accel, (std::array<int16_t, 3>{2048, 1024, 4096}));
    EXPECT_EQ(s.gyro, (std::array<int16_t, 3>{328, 164, -492}));
    EXPECT_NEAR(s.temperature / 340.0 + 36.53, 35, 0.01);
}

TEST(Mpu6000, obeys_the_order_to_wake_up_a_moment_after_the_first) {
    Bench bench;
    bench.now_us = 100'000;
    bench.write(0x6B, 0x03);
    EXPECT_EQ(bench.read(0x6B), 0x40);
    bench.now_us = 105'000;
    EXPECT_EQ(bench.read(0x6B), 0x40) << "it has to be given again";
    bench.write(0x6B, 0x03);
    EXPECT_EQ(bench.read(0x6B), 0x03);
}

TEST(Mpu6000, of_revision_c_has_half_the_sensitivity) {
    Bench bench(SensorErrors::none(), 1, Mpu6000::kRevisionC4);
    bench.wake(3, 4);
    EXPECT_EQ(bench.next(level()).accel[2], 2048);
    bench.write(0x1C, 0x08);
    EXPECT_EQ(bench.next(level()).accel[2], 4096);
}

TEST(Mpu6000, saturates_at_the_end_of_its_range) {
    Bench bench;
    bench.wake(3, 4);
    Truth truth = level();
    truth.force_x_mss = 20 * kGravity;
    truth.roll_rate_rads = -3000 * kRadians;
    const Sample s = bench.next(truth);
    EXPECT_EQ(s.accel[1], 32767);
    EXPECT_EQ(s.gyro[1], -32768);
}

TEST(Mpu6000, holds_its_interrupt_until_any_read) {
    Bench bench;
    bench.wake(3, 4);
    EXPECT_FALSE(bench.imu.interruptPin());
    bench.sample(level());
    EXPECT_TRUE(bench.imu.interruptPin());
    bench.read(0x75);
    EXPECT_FALSE(bench.imu.interruptPin());
}

TEST(Mpu6000, clears_a_latched_interrupt_only_by_reading_its_status_when_configured_so) {
    Bench bench;
    bench.wake(3, 4);
    bench.write(0x37, 0x20);
    bench.sample(level());
    bench.read(0x75);
    EXPECT_TRUE(bench.imu.interruptPin());
    EXPECT_EQ(bench.read(0x3A), 1);
    EXPECT_FALSE(bench.imu.interruptPin());
    EXPECT_EQ(bench.read(0x3A), 0);
}

TEST(Mpu6000, pulses_an_interrupt_that_is_not_latched) {
    Bench bench;
    bench.wake(3, 4);
    bench.write(0x37, 0x00);
    bench.sample(level());
    const uint64_t sampled_us = bench.now_us;
    EXPECT_TRUE(bench.imu.interruptPin());
    bench.sample(level());
    EXPECT_EQ(bench.now_us, sampled_us + 50);
    EXPECT_FALSE(bench.imu.interruptPin());
    EXPECT_EQ(bench.imu.samples().made, 1u);
}

TEST(Mpu6000, raises_no_interrupt_that_is_not_enabled) {
    Bench bench;
    bench.wake(3, 4);
    bench.write(0x38, 0);
    bench.sample(level());
    EXPECT_FALSE(bench.imu.interruptPin());
    EXPECT_EQ(bench.read(0x3A), 1);
}

TEST(Mpu6000, never_mixes_two_samples_in_one_burst) {
    Bench bench;
    bench.wake(3, 4);
    Truth truth = level();
    for (int i = 0; i < 10; ++i) bench.next(truth);
    bench.sample(truth);
    bench.imu.select(true, bench.now_us);
    bench.imu.transfer(0x3A | 0x80, bench.now_us);
    bench.imu.transfer(0, bench.now_us);
    Truth other = level();
    other.force_x_mss = other.force_y_mss = 5;
    other.force_z_mss = 0;
    bench.sample(other);
    EXPECT_EQ(bench.word(), 0);
    EXPECT_EQ(bench.word(), 0);
    EXPECT_EQ(bench.word(), 4096);
    EXPECT_FALSE(bench.imu.interruptPin());
    bench.imu.select(false, bench.now_us);
    EXPECT_TRUE(bench.imu.interruptPin()) << "the sample that waited is announced";
    EXPECT_NE(bench.burst().accel[0], 0);
}

TEST(Mpu6000, counts_samples_lost_and_taken_twice) {
    Bench bench;
    bench.wake(3, 4);
    for (int i = 0; i < 5; ++i) bench.next(level());
    bench.burst();
    bench.sample(level());
    bench.sample(level());
    bench.burst();
    const SampleCount count = bench.imu.samples();
    EXPECT_EQ(count.made, 7u);
    EXPECT_EQ(count.read, 6u);
    EXPECT_EQ(count.lost, 1u);
    EXPECT_EQ(count.repeated, 1u);
}

TEST(Mpu6000, filters_with_the_bandwidths_of_the_register_map) {
    constexpr double kAccel_hz[] = {260, 184, 94, 44, 21, 10, 5};
    constexpr double kGyro_hz[] = {256, 188, 98, 42, 20, 10, 5};
    constexpr double kGain = M_SQRT1_2;  // -3 dB
    for (uint8_t filter = 0; filter < 7; ++filter) {
        Bench bench;
        bench.wake(filter, 0);
        Statistics accel, gyro;
        for (int i = 0; i < 40'000; ++i) {
            const double t = static_cast<double>(bench.imu.nextSample_us()) * 1e-6;
            Truth truth{};
            truth.force_x_mss = 3 * kGravity * std::sin(2 * M_PI * kAccel_hz[filter] * t);
            truth.roll_rate_rads = 1000 * kRadians * std::sin(2 * M_PI * kGyro_hz[filter] * t);
            const Sample s = bench.next(truth);
            if (i < 4000) continue;
            accel.add(s.accel[1] / 4096.0);
            gyro.add(s.gyro[1] / 16.4);
        }
        EXPECT_NEAR(accel.rms() * M_SQRT2 / 3, kGain, 0.02) << int{filter};
        EXPECT_NEAR(gyro.rms() * M_SQRT2 / 1000, kGain, 0.02) << int{filter};
    }
}

TEST(Mpu6000, passes_what_is_slow_and_stops_what_is_fast) {
    for (auto [hz, least, most] : {std::array<double, 3>{2, 0.99, 1.01}, {200, 0, 0.06}}) {
        Bench bench;
        bench.wake(3, 0);
        Statistics accel;
        for (int i = 0; i < 5000; ++i) {
            Truth truth{};
            truth.force_x_mss = kGravity * std::sin(2e-6 * M_PI * hz *
                                                    static_cast<double>(bench.imu.nextSample_us()));
            const Sample s = bench.next(truth);
            if (i >= 1000) accel.add(s.accel[1] / 4096.0);
        }
        EXPECT_GE(accel.rms() * M_SQRT2, least);
        EXPECT_LE(accel.rms() * M_SQRT2, most);
    }
}

TEST(Mpu6000, errs_by_the_biases_of_the_table) {
    const SensorErrors errors;
    Statistics gyro, accel;
    for (uint64_t seed = 1; seed <= 1000; ++seed) {
        Bench bench(errors, seed);
        bench.wake(3, 4);
        Statistics rate, force;
        for (int i = 0; i < 100; ++i) {
            const Sample s = bench.next(Truth{});
            rate.add(s.gyro[seed % 3] / 16.4);
            force.add(s.accel[seed % 3] / 4096.0);
        }
        gyro.add(rate.mean());
        accel.add(force.mean());
    }
    EXPECT_NEAR(gyro.mean(), 0, 0.06);
    EXPECT_NEAR(gyro.deviation(), errors.gyro_bias_dps, 0.03);
    EXPECT_NEAR(accel.mean(), 0, 0.0004);
    EXPECT_NEAR(accel.deviation(), errors.accel_bias_g, 0.0003);
}

TEST(Mpu6000, errs_by_the_noise_and_vibration_of_the_table) {
    const SensorErrors errors;
    for (double throttle : {0.0, 0.5, 1.0}) {
        Bench bench(errors);
        bench.wake(4, 4);
        Truth truth{};
        truth.throttle = throttle;
        Statistics gyro, accel;
        for (int i = 0; i < 20'000; ++i) {
            const Sample s = bench.next(truth);
            gyro.add(s.gyro[2] / 16.4);
            accel.add(s.accel[0] / 4096.0);
        }
        const double gyro_dps =
            std::hypot(errors.gyro_noise_dps, throttle * errors.gyro_vibration_dps);
        const double accel_g =
            std::hypot(errors.accel_noise_g, throttle * errors.accel_vibration_g);
        EXPECT_NEAR(gyro.deviation(), gyro_dps, 0.03 * gyro_dps);
        EXPECT_NEAR(accel.deviation(), accel_g, 0.03 * accel_g);
    }
}

TEST(Mpu6000, gives_the_same_bits_for_the_same_seed) {
    Bench a(SensorErrors{}, 5), b(SensorErrors{}, 5);
    a.wake(3, 4);
    b.wake(3, 4);
    for (int i = 0; i < 100; ++i) {
        const Sample first = a.next(level()), second = b.next(level());
        EXPECT_EQ(first.accel, second.accel);
        EXPECT_EQ(first.gyro, second.gyro);
    }
}

TEST(Mpu6000Clock, over_1_mhz_garbles_all_but_the_sensors_registers) {
    Bench bench;
    bench.wake(3, 4);
    bench.imu.clock(8'000'000);
    bench.sample(level());
    EXPECT_EQ(bench.read(0x3A) & 1, 1);
    EXPECT_EQ(bench.imu.bytesTooFast(), 0u);
    int wrong = 0;
    for (int i = 0; i < 10; ++i) wrong += bench.read(0x75) != 0x68;
    EXPECT_GT(wrong, 5);
    EXPECT_EQ(bench.imu.bytesTooFast(), 10u);
    bench.imu.clock(1'000'000);
    EXPECT_EQ(bench.read(0x75), 0x68);
    EXPECT_EQ(bench.read(0x19), 4);
    bench.imu.clock(4'000'000);
    for (int i = 0; i < 4; ++i) bench.write(0x19, 9);
    bench.imu.clock(500'000);
    EXPECT_NE(bench.read(0x19), 9);
}
