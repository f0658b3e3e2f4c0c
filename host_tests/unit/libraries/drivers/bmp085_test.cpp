// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivers/bmp085.hpp"

#include <gtest/gtest.h>

#include "fakes/fakes.hpp"
#include "simulator/devices/bmp085.hpp"

namespace {

using drivers::Bmp085Compensation;

// The data sheet's example: AC1..AC6, B1, B2, MB, MC, MD.
constexpr int kExample[11] = {408, -72, -14383, 32741, 32757, 23153, 6190, 4, -32768, -8711, 2868};

void example(uint16_t (&words)[11]) {
    for (int i = 0; i < 11; ++i) words[i] = static_cast<uint16_t>(kExample[i]);
}

TEST(Bmp085Compensation, agrees_with_the_data_sheets_example) {
    uint16_t words[11];
    example(words);
    Bmp085Compensation compensation;
    ASSERT_TRUE(compensation.load(words));

    compensation.temperature(27898);

    EXPECT_EQ(compensation.temperature_dc(), 150);
    EXPECT_EQ(compensation.pressure_pa(23843, 0), 69964);
}

TEST(Bmp085Compensation, refuses_invalid_calibration_words) {
    for (const uint16_t wrong : {0x0000, 0xFFFF}) {
        for (int i = 0; i < 11; ++i) {
            uint16_t words[11];
            example(words);
            words[i] = wrong;
            Bmp085Compensation compensation;
            EXPECT_FALSE(compensation.load(words)) << i;
        }
    }
}

struct Bmp085 : ::testing::Test {
    simulator::Bmp085 chip{1, simulator::SensorErrors::none()};
    drivers::Bmp085 driver;
    uint64_t now_us = 0;
    int readings = 0;
    double noise = 0;  // share of the bytes read that have a wrong bit
    std::mt19937 random{1};

    Bmp085() {
        fakes::reset();
        fakes::i2c().device = [this](const fakes::I2cTransfer& transfer) {
            std::vector<uint8_t> in;
            EXPECT_EQ(transfer.address, simulator::Bmp085::kAddress);
            if (!transfer.out.empty()) chip.start(false, now_us);
            for (uint8_t byte : transfer.out) chip.write(byte, now_us);
            if (transfer.in_size > 0) chip.start(true, now_us);
            for (int i = 0; i < transfer.in_size; ++i)
                in.push_back(noisy(chip.read(i + 1 < transfer.in_size, now_us)));
            chip.stop(now_us);
            return in;
        };
        driver.start();
    }
    uint8_t noisy(uint8_t byte) {
        const bool wrong = std::uniform_real_distribution<>()(random) < noise;
        return wrong ? byte ^ 1 << random() % 8 : byte;
    }
    void fly(uint32_t for_ms) {
        for (uint32_t ms = 0; ms < for_ms; ms += 10) {
            now_us += 10000;
            readings += driver.step(static_cast<uint32_t>(now_us));
        }
    }
};

TEST_F(Bmp085, gives_forty_pressures_a_second) {
    fly(300);
    readings = 0;
    fly(10000);

    EXPECT_TRUE(driver.healthy());
    EXPECT_NEAR(readings, 400, 10);
    EXPECT_EQ(driver.badReads(), 0);
}

TEST_F(Bmp085, reads_the_true_pressure_in_hot_and_cold_air) {
    for (const double temperature_c : {-30.0, 0.0, 25.0, 60.0}) {
        for (const double pressure_pa : {50000.0, 80000.0, 101325.0}) {
            chip.sense(pressure_pa, temperature_c);
            fly(600);
            EXPECT_NEAR(driver.pressure_pa(), pressure_pa, 12) << temperature_c;
            EXPECT_NEAR(driver.temperature_cc() / 100.0, temperature_c, 0.15);
        }
    }
}

TEST_F(Bmp085, never_reads_an_unfinished_conversion) {
    chip.sense(90000, 20);
    fly(600);
    while (now_us < 3'000'000) {
        now_us += 1700;
        if (driver.step(static_cast<uint32_t>(now_us))) {
            EXPECT_NEAR(driver.pressure_pa(), 90000, 12);
            ++readings;
        }
    }

    EXPECT_GT(readings, 60);
    EXPECT_EQ(driver.badReads(), 0);
}

TEST_F(Bmp085, works_across_the_wrap_of_the_microsecond_clock) {
    now_us = 0xFFFFFFFFull - 500000;
    fly(1500);

    EXPECT_TRUE(driver.healthy());
    EXPECT_EQ(driver.restarts(), 0);
}

TEST_F(Bmp085, turns_unhealthy_when_silent_and_recovers) {
    fly(500);
    EXPECT_TRUE(driver.healthy());
    fakes::i2c().status = core::Status::timeout;
    fly(1000);
    EXPECT_FALSE(driver.healthy());

    fakes::i2c().status = core::Status::ok;
    fly(1000);
    EXPECT_TRUE(driver.healthy());
    EXPECT_NEAR(driver.pressure_pa(), 101325, 12);
}

TEST_F(Bmp085, one_failed_transfer_is_not_silence) {
    fly(500);
    fakes::i2c().status = core::Status::timeout;
    fly(40);
    fakes::i2c().status = core::Status::ok;
    fly(100);

    EXPECT_TRUE(driver.healthy());
    EXPECT_EQ(driver.restarts(), 0);
    EXPECT_GE(driver.badReads(), 1);
}

TEST_F(Bmp085, with_invalid_calibration_words_never_turns_healthy) {
    chip.words()[3] = 0xFFFF;
    fly(3000);

    EXPECT_FALSE(driver.healthy());
    EXPECT_EQ(readings, 0);
    EXPECT_GE(driver.restarts(), 3);
}

// Its words have no check.
TEST_F(Bmp085, never_computes_with_words_that_were_read_wrong_on_a_noisy_bus) {
    for (uint32_t seed = 0; seed < 100; ++seed) {
        fakes::i2c().status = core::Status::timeout;
        fly(1000);  // begins again
        fakes::i2c().status = core::Status::ok;
        random.seed(seed);
        noise = 0.03;
        fly(3000);
        noise = 0;
        fly(2000);
        ASSERT_TRUE(driver.healthy()) << seed;
        ASSERT_NEAR(driver.pressure_pa(), 101325, 12) << seed;
    }
}

TEST_F(Bmp085, another_chip_is_refused) {
    fakes::i2c().device = [](const fakes::I2cTransfer& t) {
        return std::vector<uint8_t>(t.in_size, 0x58);  // its successors say so
    };
    fly(3000);

    EXPECT_FALSE(driver.healthy());
    EXPECT_EQ(readings, 0);
}

TEST_F(Bmp085, retries_on_a_busy_bus) {
    fakes::i2c().busy_polls = 2;
    fly(3000);

    EXPECT_TRUE(driver.healthy());
}

}  // namespace
