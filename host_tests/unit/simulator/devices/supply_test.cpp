// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/devices/supply.hpp"

#include <gtest/gtest.h>

#include <string>

#include "simulator/devices/at45db.hpp"
#include "simulator/devices/bmp085.hpp"
#include "simulator/devices/hmc5883l.hpp"
#include "simulator/devices/mpu6000.hpp"
#include "simulator/devices/ms5611.hpp"

using namespace simulator;

namespace {

Supply supplyWith(const Sag& sag) {
    Supply supply;
    supply.add(sag);
    return supply;
}

uint8_t imuRegister(Mpu6000& imu, uint8_t reg, uint64_t now_us) {
    imu.select(true, now_us);
    imu.transfer(static_cast<uint8_t>(reg | 0x80), now_us);
    const uint8_t value = imu.transfer(0, now_us);
    imu.select(false, now_us);
    return value;
}

void writeImu(Mpu6000& imu, uint8_t reg, uint8_t value, uint64_t now_us) {
    imu.select(true, now_us);
    imu.transfer(reg, now_us);
    imu.transfer(value, now_us);
    imu.select(false, now_us);
}

uint8_t flashStatus(At45db& flash, uint64_t now_us) {
    flash.select(true, now_us);
    flash.transfer(0xD7, now_us);
    const uint8_t status = flash.transfer(0, now_us);
    flash.select(false, now_us);
    return status;
}

}  // namespace

TEST(Supply, falls_along_its_slope_and_rises_by_5_v_in_a_millisecond) {
    const Supply supply = supplyWith({1, 10'000, 50'000, 20'000});
    EXPECT_EQ(supply.volts(9'999), 5);
    EXPECT_NEAR(supply.volts(20'000), 3, 1e-9);
    EXPECT_EQ(supply.volts(40'000), 1);
    EXPECT_NEAR(supply.volts(50'500), 3.5, 1e-9);
    EXPECT_EQ(supply.volts(51'000), 5);
}

TEST(Supply, of_a_bench_is_what_it_is_set_to_and_falls_from_there) {
    Supply supply = supplyWith({1, 10'000, 50'000, 20'000});
    supply.adjust(5.4);
    EXPECT_EQ(supply.volts(9'999), 5.4);
    EXPECT_NEAR(supply.volts(20'000), 3.2, 1e-9);
    EXPECT_FALSE(supply.below(3.2, 19'990));
    EXPECT_TRUE(supply.below(3.2, 20'010));
    EXPECT_NEAR(supply.volts(50'500), 3.5, 1e-9);
    EXPECT_EQ(supply.volts(51'000), 5.4);
}

TEST(Supply, that_is_back_before_it_has_fallen_turns_where_it_is) {
    const Supply supply = supplyWith({0, 0, 8'000, 20'000});
    EXPECT_NEAR(supply.volts(7'999), 3, 0.001);
    EXPECT_FALSE(supply.below(2.7, 8'000));
    EXPECT_TRUE(supply.below(4.5, 8'000));
    EXPECT_EQ(supply.volts(8'400), 5);
}

TEST(Supply, may_drop_at_once) {
    const Supply supply = supplyWith({2, 5'000, 6'000, 0});
    EXPECT_EQ(supply.volts(4'999), 5);
    EXPECT_EQ(supply.volts(5'000), 2);
    EXPECT_TRUE(supply.below(2.7, 5'000));
}

TEST(Supply, announces_when_it_crosses_a_level) {
    const Supply supply = supplyWith({0, 1'000, 101'000, 5'000});
    const uint64_t down_us = supply.nextCrossing_us(2.7, 0);
    EXPECT_EQ(down_us, 3'300u);
    EXPECT_FALSE(supply.below(2.7, down_us - 1));
    EXPECT_TRUE(supply.below(2.7, down_us));
    const uint64_t up_us = supply.nextCrossing_us(2.7, down_us);
    EXPECT_EQ(up_us, 101'540u);
    EXPECT_TRUE(supply.below(2.7, up_us - 1));
    EXPECT_FALSE(supply.below(2.7, up_us));
    EXPECT_EQ(supply.nextCrossing_us(2.7, up_us), UINT64_MAX);
}

TEST(Supply, is_as_low_as_the_deeper_of_two_sags) {
    Supply supply = supplyWith({4, 0, 100'000, 0});
    supply.add({1, 50'000, 60'000, 0});
    EXPECT_EQ(supply.volts(40'000), 4);
    EXPECT_EQ(supply.volts(55'000), 1);
}

TEST(PoweredParts, are_switched_at_their_own_voltages) {
    const Supply supply = supplyWith({2.5, 1'000, 20'000, 0});
    PoweredParts parts(supply);
    std::string log;
    parts.add(2.0, [&](bool on, uint64_t) { log += on ? "A" : "a"; });
    parts.add(2.7, [&](bool on, uint64_t) { log += on ? "B" : "b"; });
    parts.add(3.3, [&](bool on, uint64_t) { log += on ? "C" : "c"; });
    for (uint64_t now_us = 0; (now_us = parts.nextEvent_us(now_us)) != UINT64_MAX;)
        parts.run(now_us);
    EXPECT_EQ(log, "bcBC");
}

TEST(PowerCut, leaves_the_inertial_sensor_asleep_and_deaf_for_100_ms) {
    Mpu6000 imu;
    for (uint64_t now_us : {15'000, 20'000}) writeImu(imu, 0x6B, 0x03, now_us);
    EXPECT_EQ(imuRegister(imu, 0x6B, 30'000), 0x03);
    imu.power(false, 40'000);
    EXPECT_EQ(imuRegister(imu, 0x75, 41'000), 0);
    EXPECT_EQ(imu.nextSample_us(), UINT64_MAX);
    imu.power(true, 50'000);
    EXPECT_EQ(imuRegister(imu, 0x75, 149'000), 0);
    EXPECT_EQ(imuRegister(imu, 0x75, 150'000), 0x68);
    EXPECT_EQ(imuRegister(imu, 0x6B, 150'000), 0x40);
}

TEST(PowerCut, ends_a_conversion_of_the_barometer) {
    Ms5611 barometer;
    const auto ask = [&](uint8_t command, uint64_t now_us) {
        uint32_t value = 0;
        barometer.select(true, now_us);
        barometer.transfer(command, now_us);
        for (int i = 0; i < 3; ++i) value = value << 8 | barometer.transfer(0, now_us);
        barometer.select(false, now_us);
        return value;
    };
    ask(0x48, 10'000);
    barometer.power(false, 11'000);
    EXPECT_EQ(ask(0xA2, 12'000), 0u);
    barometer.power(true, 13'000);
    EXPECT_EQ(ask(0, 30'000), 0u) << "what it measured is lost";
    EXPECT_EQ(ask(0xA2, 30'000) >> 8, 40127u);
}

TEST(PowerCut, puts_the_compass_to_rest) {
    Hmc5883l compass;
    const auto configA = [&](uint64_t now_us) {
        if (!compass.start(false, now_us)) return -1;
        compass.write(0, now_us);
        compass.start(true, now_us);
        return static_cast<int>(compass.read(false, now_us));
    };
    compass.start(false, 0);
    for (const uint8_t byte : {0, 0x78}) compass.write(byte, 0);
    EXPECT_EQ(configA(1'000), 0x78);
    compass.power(false, 2'000);
    EXPECT_EQ(configA(3'000), -1);
    compass.power(true, 4'000);
    EXPECT_EQ(configA(4'100), -1);
    EXPECT_EQ(configA(4'200), 0x10);
}

TEST(PowerCut, keeps_the_first_measurement_of_the_compass_back_for_50_ms) {
    Hmc5883l compass;
    compass.power(false, 0);
    compass.power(true, 1'000);
    compass.start(false, 2'000);
    for (const uint8_t byte : {2, 1}) compass.write(byte, 2'000);
    const auto ready = [&](uint64_t now_us) {
        compass.start(false, now_us);
        compass.write(9, now_us);
        compass.start(true, now_us);
        return compass.read(false, now_us) & 1;
    };
    EXPECT_FALSE(ready(50'000));
    EXPECT_TRUE(ready(51'000));
}

TEST(PowerCut, takes_the_other_barometer_10_ms) {
    Bmp085 barometer;
    barometer.power(false, 0);
    EXPECT_FALSE(barometer.start(false, 1'000));
    barometer.power(true, 2'000);
    EXPECT_FALSE(barometer.start(false, 11'000));
    EXPECT_TRUE(barometer.start(false, 12'000));
}

TEST(PowerCut, of_the_log_chip_damages_the_page_and_forbids_writing_for_20_ms) {
    At45db flash;
    const auto store = [&](uint64_t now_us) {
        flash.select(true, now_us);
        for (const uint8_t byte : {0x83, 0x00, 0x04, 0x00}) flash.transfer(byte, now_us);
        flash.select(false, now_us);
    };
    const std::vector<uint8_t> before = flash.image(0);
    store(1'000);
    flash.power(false, 5'000);
    EXPECT_EQ(flashStatus(flash, 6'000), 0xFF);
    EXPECT_NE(flash.image(6'000), before);
    flash.power(true, 10'000);
    EXPECT_EQ(flashStatus(flash, 11'000) & 0x80, 0x80);
    const uint64_t ignored = flash.ignored();
    store(20'000);
    EXPECT_EQ(flash.ignored(), ignored + 1);
    store(30'000);
    EXPECT_TRUE(flash.busy(31'000));
}
