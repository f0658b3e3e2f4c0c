// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivers/hmc5883l.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>

#include "fakes/fakes.hpp"
#include "simulator/devices/hmc5883l.hpp"

namespace {

struct Hmc5883l : ::testing::Test {
    static std::unique_ptr<simulator::Hmc5883l> fresh() {
        return std::make_unique<simulator::Hmc5883l>(1, simulator::SensorErrors::none());
    }
    std::unique_ptr<simulator::Hmc5883l> chip = fresh();
    drivers::Hmc5883l driver;
    uint64_t now_us = 0;
    int readings = 0;
    uint8_t damage = 0;  // XORed to every byte read

    Hmc5883l() {
        fakes::reset();
        chip->sense({200, -50, 430});
        plug();
        driver.start();
    }
    void plug() {
        fakes::i2c().device = [this](const fakes::I2cTransfer& transfer) {
            std::vector<uint8_t> in;
            EXPECT_EQ(transfer.address, simulator::Hmc5883l::kAddress);
            chip->start(false, now_us);
            for (uint8_t byte : transfer.out) chip->write(byte, now_us);
            if (transfer.in_size > 0) chip->start(true, now_us);
            for (int i = 0; i < transfer.in_size; ++i) {
                in.push_back(chip->read(i + 1 < transfer.in_size, now_us) ^ damage);
            }
            chip->stop(now_us);
            return in;
        };
    }
    // In steps of the firmware's task.
    void fly(uint32_t for_ms) {
        for (uint32_t ms = 0; ms < for_ms; ms += 20) {
            now_us += 20000;
            readings += driver.step(static_cast<uint32_t>(now_us / 1000));
        }
    }
};

TEST_F(Hmc5883l, tests_itself_and_reads_milligauss_in_the_airplanes_axes) {
    fly(2000);

    EXPECT_TRUE(driver.healthy());
    EXPECT_NEAR(driver.field_mg().x, 200, 2);
    EXPECT_NEAR(driver.field_mg().y, -50, 2);
    EXPECT_NEAR(driver.field_mg().z, 430, 2);
    EXPECT_NEAR(std::abs(driver.sum_mg()), 200 - 50 + 430, 18);
    for (uint8_t axis = 0; axis < 3; ++axis) EXPECT_NEAR(driver.scale(axis), 1, 0.01);
}

TEST_F(Hmc5883l, reads_some_seventeen_times_a_second) {
    fly(2000);
    readings = 0;
    fly(10000);

    EXPECT_GE(readings, 160);
}

TEST_F(Hmc5883l, asks_one_thing_at_a_time_on_a_slow_bus) {
    fakes::i2c().busy_polls = 3;
    fly(3000);

    EXPECT_TRUE(driver.healthy());
}

TEST_F(Hmc5883l, counts_saturation_and_gives_no_field_then) {
    fly(2000);
    chip->sense({3000, 0, 0});
    readings = 0;
    fly(2000);

    EXPECT_LE(readings, 1);
    EXPECT_GT(driver.saturated(), 25);
    EXPECT_FALSE(driver.healthy());
    chip->sense({200, 0, 430});
    fly(100);
    EXPECT_TRUE(driver.healthy());
}

TEST_F(Hmc5883l, turns_unhealthy_when_silent_and_recovers) {
    fly(2000);
    fakes::i2c().device = nullptr;
    fly(700);
    EXPECT_FALSE(driver.healthy());

    plug();
    fly(2500);
    EXPECT_TRUE(driver.healthy());
}

TEST_F(Hmc5883l, one_failed_transfer_is_not_silence) {
    fly(2000);
    fakes::i2c().status = core::Status::timeout;
    fly(40);
    fakes::i2c().status = core::Status::ok;
    fly(100);

    EXPECT_TRUE(driver.healthy());
    EXPECT_EQ(driver.restarts(), 0);
}

TEST_F(Hmc5883l, a_chip_that_lost_its_supply_for_a_moment_is_set_up_again) {
    fly(2000);
    chip = fresh();
    chip->sense({0, 300, 430});
    fly(4500);

    EXPECT_TRUE(driver.healthy());
    EXPECT_NEAR(driver.field_mg().y, 300, 3);
    EXPECT_GE(driver.restarts(), 1);
}

TEST_F(Hmc5883l, another_chip_is_refused) {
    damage = 0x01;
    fly(5000);

    EXPECT_FALSE(driver.healthy());
    EXPECT_EQ(readings, 0);
}

// A chip of another sensitivity, seen through its own self-test.
struct Scripted {
    double factor;
    bool testing = false;
    uint8_t configuration = 0x78;
    std::vector<uint8_t> operator()(const fakes::I2cTransfer& t) {
        if (t.out[0] == 10) return {'H', '4', '3'};
        if (t.out.size() == 2 && t.out[0] == 0) testing = t.out[1] == 0x11;
        if (t.out[0] == 0) return {configuration, 0x20, 0x00};
        auto put = [](std::vector<uint8_t>& to, double counts) {
            const int16_t value = static_cast<int16_t>(counts);
            to.push_back(static_cast<uint8_t>(value >> 8));
            to.push_back(static_cast<uint8_t>(value));
        };
        std::vector<uint8_t> in;
        put(in, factor * (testing ? 1.16 * 660 : 0.2 * 1090));
        put(in, factor * (testing ? 1.08 * 660 : 0));
        put(in, factor * (testing ? 1.16 * 660 : 0));
        return in;
    }
};

TEST_F(Hmc5883l, takes_the_self_tests_scale_out_of_the_field) {
    fakes::i2c().device = Scripted{0.85};
    fly(2000);

    EXPECT_NEAR(driver.scale(0), 1 / 0.85, 0.01);
    EXPECT_NEAR(driver.field_mg().y, -200, 2);
}

TEST_F(Hmc5883l, takes_a_coil_that_is_wound_the_other_way_round) {
    simulator::CompassMount clone;
    clone.inverted_self_test = true;
    chip = std::make_unique<simulator::Hmc5883l>(1, simulator::SensorErrors::none(), clone);
    chip->sense({200, -50, 430});
    fly(2000);

    EXPECT_TRUE(driver.healthy());
    EXPECT_NEAR(driver.field_mg().x, 200, 2);
    EXPECT_NEAR(driver.scale(2), 1, 0.01);
}

TEST_F(Hmc5883l, a_self_test_far_out_is_a_broken_chip) {
    fakes::i2c().device = Scripted{0.5};
    fly(6000);

    EXPECT_FALSE(driver.healthy());
    EXPECT_GE(driver.restarts(), 1);
}

TEST_F(Hmc5883l, a_chip_with_another_configuration_is_neither_of_the_two) {
    Scripted other{1.0};
    other.configuration = 0x58;
    fakes::i2c().device = other;
    fly(6000);

    EXPECT_FALSE(driver.healthy());
    EXPECT_EQ(readings, 0);
}

struct Hmc5843 : Hmc5883l {
    Hmc5843() {
        simulator::CompassMount mount;
        mount.kind = simulator::CompassKind::hmc5843;
        chip = std::make_unique<simulator::Hmc5883l>(1, simulator::SensorErrors::none(), mount);
        chip->sense({200, -50, 430});
    }
};

TEST_F(Hmc5843, is_identified_and_reads_milligauss_in_body_axes) {
    fly(1500);

    EXPECT_TRUE(driver.healthy());
    EXPECT_EQ(driver.restarts(), 0);
    EXPECT_NEAR(driver.field_mg().x, 200, 2);
    EXPECT_NEAR(driver.field_mg().y, -50, 2);
    EXPECT_NEAR(driver.field_mg().z, 430, 2);
    EXPECT_NEAR(std::abs(driver.sum_mg()), 200 + 50 + 430, 20);  // its second axis the other way
    for (uint8_t axis = 0; axis < 3; ++axis) EXPECT_NEAR(driver.scale(axis), 1, 0.01);
}

TEST_F(Hmc5843, is_verified_by_the_configuration_that_it_reads_back) {
    fly(20000);

    EXPECT_TRUE(driver.healthy());
    EXPECT_EQ(driver.restarts(), 0);
}

}  // namespace
