// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/devices/ms5611.hpp"

#include <gtest/gtest.h>

#include "statistics.hpp"

using namespace simulator;

namespace {

struct Reading {
    double pressure_pa, temperature_c;
};

// The data sheet's formulas, second order included, in its own integers.
Reading compensated(const Ms5611::Prom& c, uint32_t d1, uint32_t d2) {
    const int64_t dt = static_cast<int64_t>(d2) - c[5] * 256;
    int64_t temperature = 2000 + dt * c[6] / (1 << 23);
    int64_t offset = c[2] * (int64_t{1} << 16) + c[4] * dt / (1 << 7);
    int64_t sensitivity = c[1] * (int64_t{1} << 15) + c[3] * dt / (1 << 8);
    if (temperature < 2000) {
        const int64_t cold = (temperature - 2000) * (temperature - 2000);
        offset -= 5 * cold / 2;
        sensitivity -= 5 * cold / 4;
        if (temperature < -1500) {
            const int64_t frost = (temperature + 1500) * (temperature + 1500);
            offset -= 7 * frost;
            sensitivity -= 11 * frost / 2;
        }
        temperature -= dt * dt / (int64_t{1} << 31);
    }
    const double pressure = (static_cast<double>(d1) * static_cast<double>(sensitivity) / 0x1p21 -
                             static_cast<double>(offset)) /
                            0x1p15;
    return {pressure, static_cast<double>(temperature) / 100};
}

struct Bench {
    explicit Bench(SensorErrors errors = SensorErrors::none(), uint64_t seed = 1)
        : barometer(seed, errors) {
        now_us = 5000;
    }
    void command(uint8_t byte) {
        barometer.select(true, now_us);
        barometer.transfer(byte, now_us);
        barometer.select(false, now_us);
    }
    uint32_t ask(uint8_t byte, int size) {
        barometer.select(true, now_us);
        barometer.transfer(byte, now_us);
        uint32_t value = 0;
        for (int i = 0; i < size; ++i) value = value << 8 | barometer.transfer(0, now_us);
        barometer.select(false, now_us);
        return value;
    }
    Ms5611::Prom prom() {
        Ms5611::Prom out;
        for (uint8_t i = 0; i < 8; ++i)
            out[i] = static_cast<uint16_t>(ask(static_cast<uint8_t>(0xA0 + 2 * i), 2));
        return out;
    }
    uint32_t converted(uint8_t byte) {
        command(byte);
        now_us += 9100;
        return ask(0, 3);
    }
    Reading reading() {
        const uint32_t d2 = converted(0x58), d1 = converted(0x48);
        return compensated(prom(), d1, d2);
    }

    Ms5611 barometer;
    uint64_t now_us;
};

}  // namespace

TEST(Ms5611, has_a_prom_whose_crc_is_right) {
    Bench bench;
    const auto prom = bench.prom();
    EXPECT_EQ(prom[1], 40127);
    EXPECT_EQ(prom[6], 28312);
    EXPECT_EQ(prom[7] & 0xF, Ms5611::crc4(prom));
}

TEST(Ms5611, computes_the_crc_of_the_application_note) {
    EXPECT_EQ(Ms5611::crc4({0x3132, 0x3334, 0x3536, 0x3738, 0x3940, 0x4142, 0x4344, 0x4500}), 0xB);
}

TEST(Ms5611, is_turned_back_into_pressure_and_temperature_by_the_data_sheets_formulas) {
    for (double temperature_c : {-35.0, -15.01, -10.0, 0.0, 19.99, 20.0, 25.0, 45.0})
        for (double pressure_pa : {30'000.0, 70'000.0, 95'123.4, 101'325.0}) {
            Bench bench;
            bench.barometer.sense(pressure_pa, temperature_c);
            const Reading r = bench.reading();
            EXPECT_NEAR(r.pressure_pa, pressure_pa, 1.0) << temperature_c;
            EXPECT_NEAR(r.temperature_c, temperature_c, 0.02) << pressure_pa;
        }
}

TEST(Ms5611, takes_the_time_of_the_oversampling) {
    constexpr uint64_t kLongest_us[] = {600, 1170, 2280, 4540, 9040};
    for (int i = 0; i < 5; ++i)
        for (uint8_t quantity : {0x40, 0x50}) {
            const auto command = static_cast<uint8_t>(quantity + 2 * i);
            Bench early, ready;
            early.command(command);
            early.now_us += kLongest_us[i] - 1;
            EXPECT_EQ(early.ask(0, 3), 0u);
            ready.command(command);
            ready.now_us += kLongest_us[i];
            EXPECT_GT(ready.ask(0, 3), 1'000'000u);
        }
}

TEST(Ms5611, gives_zero_without_a_conversion_and_when_asked_twice) {
    Bench bench;
    EXPECT_EQ(bench.ask(0, 3), 0u);
    EXPECT_NE(bench.converted(0x48), 0u);
    EXPECT_EQ(bench.ask(0, 3), 0u);
}

TEST(Ms5611, ignores_commands_while_it_reloads_after_a_reset) {
    Bench bench;
    bench.command(0x1E);
    bench.now_us += 2700;
    EXPECT_EQ(bench.prom()[1], 0);
    bench.now_us += 100;
    EXPECT_EQ(bench.prom()[1], 40127);
}

TEST(Ms5611, measures_the_air_of_the_moment_of_the_command) {
    Bench bench;
    bench.barometer.sense(100'000, 25);
    const uint32_t d2 = bench.converted(0x58);
    bench.command(0x48);
    bench.barometer.sense(90'000, 25);
    bench.now_us += 9100;
    EXPECT_NEAR(compensated(bench.prom(), bench.ask(0, 3), d2).pressure_pa, 100'000, 1);
}

TEST(Ms5611, errs_by_the_noise_of_the_table) {
    SensorErrors errors;
    Bench bench(errors);
    bench.barometer.sense(95'000, 25);
    Statistics difference;
    double last = bench.reading().pressure_pa;
    for (int i = 0; i < 5000; ++i) {
        const double pressure_pa = bench.reading().pressure_pa;
        difference.add(pressure_pa - last);
        last = pressure_pa;
    }
    EXPECT_NEAR(difference.deviation() / M_SQRT2, errors.baro_noise_pa, 0.1);
}

TEST(Ms5611, drifts_as_slowly_and_as_far_as_the_table_says) {
    const SensorErrors errors;
    Statistics before, after;
    const auto average = [](Bench& bench) {
        Statistics pressure;
        for (int i = 0; i < 50; ++i) pressure.add(bench.reading().pressure_pa);
        return pressure.mean() - 95'000;
    };
    for (uint64_t seed = 1; seed <= 1500; ++seed) {
        Bench bench(errors, seed);
        bench.barometer.sense(95'000, 25);
        before.add(average(bench));
        bench.now_us += static_cast<uint64_t>(errors.baro_drift_s * 1e6);
        after.add(average(bench));
    }
    EXPECT_NEAR(before.deviation(), errors.baro_drift_pa, 0.25);
    EXPECT_NEAR(after.deviation(), errors.baro_drift_pa, 0.25);
    EXPECT_NEAR(correlation(before, after), std::exp(-1), 0.07);
}
