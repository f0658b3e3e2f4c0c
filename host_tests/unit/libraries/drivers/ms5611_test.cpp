// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivers/ms5611.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "model_bus.hpp"

namespace {

using drivers::Ms5611Compensation;

// The data sheet's example, "Pressure and temperature calculation"; word 7 carries the CRC.
void example(uint16_t (&prom)[8]) {
    const uint16_t words[8] = {0, 40127, 36924, 23317, 23282, 33464, 28312, 0};
    for (int i = 0; i < 8; ++i) prom[i] = words[i];
    prom[7] = Ms5611Compensation::crc4(prom);
}

TEST(Ms5611Compensation, agrees_with_the_data_sheets_example) {
    uint16_t prom[8];
    example(prom);
    Ms5611Compensation compensation;
    ASSERT_TRUE(compensation.load(prom));

    compensation.temperature(8569150);

    EXPECT_EQ(compensation.temperature_cc(), 2007);
    EXPECT_EQ(compensation.pressure_pa(9085466), 100009);
}

TEST(Ms5611Compensation, knows_the_crc_of_application_note_520) {
    const uint16_t prom[8] = {0x3132, 0x3334, 0x3536, 0x3738, 0x3940, 0x4142, 0x4344, 0x4500};

    EXPECT_EQ(Ms5611Compensation::crc4(prom), 0xB);
}

// The formulas of the data sheet once more, in floating point of 64 bits of mantissa.
struct Reference {
    long double temperature_cc, pressure_pa;
};
Reference reference(const uint16_t (&c)[8], uint32_t d1, uint32_t d2) {
    const long double dt = d2 - c[5] * 256.0L;
    long double temperature = 2000 + std::floor(dt * c[6] / 8388608.0L);  // whole 0.01 C
    long double off = c[2] * 65536.0L + c[4] * dt / 128.0L;
    long double sens = c[1] * 32768.0L + c[3] * dt / 256.0L;
    if (temperature < 2000) {
        const long double low = temperature - 2000, very_low = temperature + 1500;
        long double off2 = 5 * low * low / 2, sens2 = 5 * low * low / 4;
        if (temperature < -1500) {
            off2 += 7 * very_low * very_low;
            sens2 += 11 * very_low * very_low / 2;
        }
        off -= off2;
        sens -= sens2;
        temperature -= dt * dt / 2147483648.0L;
    }
    return {temperature, (d1 * sens / 2097152.0L - off) / 32768.0L};
}

TEST(Ms5611Compensation, follows_both_orders_over_the_whole_range_of_temperature) {
    uint16_t prom[8];
    example(prom);
    Ms5611Compensation compensation;
    ASSERT_TRUE(compensation.load(prom));
    std::mt19937 random(1);
    for (int i = 0; i < 20000; ++i) {
        const uint32_t d2 = 6600000 + random() % 3600000;  // -38..70 C
        const uint32_t d1 = 4000000 + random() % 6000000;
        compensation.temperature(d2);
        const Reference r = reference(prom, d1, d2);
        ASSERT_NEAR(compensation.temperature_cc(), static_cast<double>(r.temperature_cc), 1.5)
            << d2;
        const double lost = static_cast<double>(r.pressure_pa) - compensation.pressure_pa(d1);
        ASSERT_GT(lost, -0.05) << d1;
        ASSERT_LT(lost, 1.05) << d1;  // whole pascals
    }
}

TEST(Ms5611Compensation, refuses_a_prom_with_any_one_bit_wrong) {
    uint16_t good[8];
    example(good);
    for (int word = 0; word < 7; ++word) {
        for (int bit = 0; bit < 16; ++bit) {
            uint16_t prom[8];
            std::copy(good, good + 8, prom);
            prom[word] = static_cast<uint16_t>(prom[word] ^ 1 << bit);
            Ms5611Compensation compensation;
            EXPECT_FALSE(compensation.load(prom)) << word << " " << bit;
        }
    }
}

TEST(Ms5611Compensation, refuses_a_prom_of_zeros_though_its_crc_is_right) {
    const uint16_t prom[8] = {};
    Ms5611Compensation compensation;

    EXPECT_EQ(Ms5611Compensation::crc4(prom), 0);
    EXPECT_FALSE(compensation.load(prom));
}

struct Ms5611 : ::testing::Test {
    model::Bench bench;
    model::Barometer driver;
    int readings = 0;

    Ms5611() { driver.start(); }
    void fly(uint32_t for_ms) {
        const uint64_t end_us = bench.now_us + for_ms * 1000ull;
        while (bench.now_us < end_us) {
            bench.advance_us(10000);
            readings += driver.step(static_cast<uint32_t>(bench.now_us));
        }
    }
};

TEST_F(Ms5611, gives_eighty_pressures_a_second) {
    fly(300);
    readings = 0;
    fly(10000);

    EXPECT_TRUE(driver.healthy());
    EXPECT_EQ(readings, 800);
    EXPECT_EQ(driver.badReads(), 0);
}

TEST_F(Ms5611, reads_the_true_pressure_in_hot_and_cold_air) {
    for (double temperature_c : {-35.0, -20.0, -15.0, 0.0, 19.0, 21.0, 50.0}) {
        for (double pressure_pa : {50000.0, 80000.0, 101325.0}) {
            bench.barometer.sense(pressure_pa, temperature_c);
            fly(400);
            EXPECT_NEAR(driver.pressure_pa(), pressure_pa, 4) << temperature_c;
            EXPECT_NEAR(driver.temperature_cc() / 100.0, temperature_c, 0.05);
        }
    }
}

TEST_F(Ms5611, called_too_early_leaves_the_conversion_alone) {
    fly(300);
    const uint64_t end_us = bench.now_us + 1'000'000;
    readings = 0;
    while (bench.now_us < end_us) {
        bench.advance_us(1700);
        readings += driver.step(static_cast<uint32_t>(bench.now_us));
    }

    EXPECT_EQ(driver.badReads(), 0);
    EXPECT_GT(readings, 70);
}

// The time a step is called with is that before it reads and computes, and a frame may be late.
TEST_F(Ms5611, a_command_that_leaves_late_is_given_its_time) {
    fly(300);
    readings = 0;
    for (int i = 0; i < 1000; ++i) {
        const uint64_t called_us = bench.now_us;
        bench.advance_us(i % 2 ? 0 : 200);
        readings += driver.step(static_cast<uint32_t>(called_us));
        const uint64_t next_us = called_us + (i % 2 ? 10700 : 9100 + i % 400);
        bench.advance_us(next_us - bench.now_us);
    }

    EXPECT_EQ(driver.badReads(), 0);
    EXPECT_GT(readings, 350);
    EXPECT_NEAR(driver.pressure_pa(), 101325, 4);
}

TEST_F(Ms5611, works_across_the_wrap_of_the_microsecond_clock) {
    bench.now_us = 0xFFFFFFFFull - 500000;
    fly(1500);

    EXPECT_TRUE(driver.healthy());
    EXPECT_EQ(driver.restarts(), 0);
}

TEST_F(Ms5611, unplugged_turns_unhealthy_and_comes_back_when_plugged_in) {
    fly(300);
    for (uint8_t level : {0x00, 0xFF}) {
        bench.floating = level;
        bench.barometer_unplugged = true;
        fly(500);
        EXPECT_FALSE(driver.healthy());
        bench.barometer_unplugged = false;
        fly(1200);
        EXPECT_TRUE(driver.healthy());
    }
    EXPECT_NEAR(driver.pressure_pa(), 101325, 4);
}

TEST_F(Ms5611, with_a_damaged_prom_never_turns_healthy) {
    bench.barometer.prom()[3] ^= 0x0100;
    fly(3000);

    EXPECT_FALSE(driver.healthy());
    EXPECT_EQ(readings, 0);
    EXPECT_GE(driver.restarts(), 3);
}

// One in sixteen wrong PROMs has the right CRC.
TEST_F(Ms5611, never_computes_with_a_prom_that_was_read_wrong_on_a_noisy_bus) {
    for (uint32_t seed = 0; seed < 200; ++seed) {
        driver = model::Barometer();
        driver.start();
        bench.random.seed(seed);
        bench.noise = 0.05;
        fly(2000);
        bench.noise = 0;
        fly(1000);
        ASSERT_TRUE(driver.healthy()) << seed;
        ASSERT_NEAR(driver.pressure_pa(), 101325, 4) << seed;
    }
}

TEST_F(Ms5611, keeps_the_sensors_interrupt_off_its_bus_for_less_than_30_us) {
    uint64_t longest_us = 0;
    for (int n = 0; n < 200; ++n) {
        bench.advance_us(10000);
        const uint64_t before_us = bench.now_us;
        driver.step(static_cast<uint32_t>(bench.now_us));
        longest_us = std::max(longest_us, bench.now_us - before_us);
    }

    EXPECT_LT(longest_us, 30u);
}

}  // namespace
