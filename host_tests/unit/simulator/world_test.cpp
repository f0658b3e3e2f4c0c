// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/world.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include "simulator/devices/hmc5883l.hpp"
#include "simulator/devices/mpu6000.hpp"
#include "simulator/devices/ms5611.hpp"
#include "simulator/devices/ppm_encoder.hpp"
#include "simulator/devices/supply.hpp"
#include "simulator/devices/ublox_gps.hpp"

using namespace simulator;

namespace {

void writeImu(World& world, uint8_t reg, uint8_t value, uint64_t now_us) {
    world.imu().select(true, now_us);
    world.imu().transfer(reg, now_us);
    world.imu().transfer(value, now_us);
    world.imu().select(false, now_us);
}

// It obeys when it is asked again.
void wakeImu(World& world, uint64_t done_us) {
    for (const uint64_t at_us : {done_us - 5'000, done_us}) {
        world.advanceTo(at_us);
        writeImu(world, 0x6B, 0x03, at_us);
    }
}

uint32_t askBarometer(World& world, uint8_t command, int size, uint64_t now_us) {
    uint32_t value = 0;
    world.barometer().select(true, now_us);
    world.barometer().transfer(command, now_us);
    for (int i = 0; i < size; ++i) value = value << 8 | world.barometer().transfer(0, now_us);
    world.barometer().select(false, now_us);
    return value;
}

}  // namespace

TEST(World, moves_the_airplane_in_steps_of_two_and_a_half_milliseconds) {
    World world({});
    world.advanceTo(2499);
    EXPECT_EQ(world.truth().time_us, 0u);
    world.advanceTo(1'000'000);
    EXPECT_EQ(world.truth().time_us, 1'000'000u);
    world.advanceTo(500'000);
    EXPECT_EQ(world.truth().time_us, 1'000'000u);
}

TEST(World, does_not_depend_on_the_steps_in_which_it_is_moved) {
    WorldOptions options;
    options.gusts = true;
    options.wind_mps = 5;
    World coarse(options), fine(options);
    for (World* world : {&coarse, &fine}) {
        world->advanceTo(20'000);
        writeImu(*world, 0x6B, 0x03, 20'000);
    }
    coarse.advanceTo(3'000'000);
    for (uint64_t t = 20'000; t <= 3'000'000; t += 777) fine.advanceTo(t);
    fine.advanceTo(3'000'000);
    EXPECT_EQ(coarse.truth().airspeed_mps, fine.truth().airspeed_mps);
    EXPECT_EQ(coarse.imu().samples().made, fine.imu().samples().made);
    EXPECT_EQ(coarse.imu().nextSample_us(), fine.imu().nextSample_us());
}

TEST(World, samples_the_imu_at_the_imus_own_times) {
    World world({});
    world.advanceTo(100'000);
    wakeImu(world, 105'000);
    writeImu(world, 0x1A, 0x03, 105'000);
    writeImu(world, 0x19, 4, 105'000);
    const uint64_t first_us = world.imu().nextSample_us();
    world.advanceTo(first_us - 1);
    EXPECT_EQ(world.imu().samples().made, 0u);
    world.advanceTo(first_us + 995'000);
    EXPECT_EQ(world.imu().samples().made, 200u);
}

TEST(World, shows_the_barometer_the_air_at_its_height) {
    WorldOptions options;
    options.sensor_errors = false;
    options.altitude_m = 500;
    World world(options);
    world.advanceTo(10'000);
    askBarometer(world, 0x58, 0, 10'000);
    const double d2 = askBarometer(world, 0, 3, 20'000);
    askBarometer(world, 0x48, 0, 20'000);
    const double d1 = askBarometer(world, 0, 3, 30'000);
    const auto& c = world.barometer().prom();
    const double dt = d2 - c[5] * 256.0;
    const double pressure_pa =
        (d1 * (c[1] * 0x1p15 + c[3] * dt / 256) / 0x1p21 - (c[2] * 0x1p16 + c[4] * dt / 128)) /
        0x1p15;
    EXPECT_NEAR(pressure_pa, 95461, 3);
}

TEST(World, turns_the_compass_with_the_airplane) {
    WorldOptions options;
    options.sensor_errors = false;
    options.heading_deg = 92.5;  // magnetic east
    World world(options);
    world.advanceTo(10'000);
    Hmc5883l& compass = world.compass();
    for (auto [at, value] : {std::pair{0, 0x78}, {1, 0x20}, {2, 0x00}}) {
        compass.start(false, 10'000);
        compass.write(static_cast<uint8_t>(at), 10'000);
        compass.write(static_cast<uint8_t>(value), 10'000);
        compass.stop(10'000);
    }
    world.advanceTo(100'000);
    compass.start(false, 100'000);
    compass.write(3, 100'000);
    compass.start(true, 100'000);
    uint8_t bytes[6];
    for (uint8_t& byte : bytes) byte = compass.read(true, 100'000);
    const auto chip_x = static_cast<int16_t>(bytes[0] << 8 | bytes[1]);
    const double level_counts = 480 * std::cos(63 * M_PI / 180) * 1.09;
    EXPECT_NEAR(-chip_x, -level_counts, 3) << "body y, to the right, looks south";
}

TEST(World, moves_servos_by_pulses_and_stops_the_motor_without_them) {
    World world({});
    uint64_t t = 0;
    for (; t < 1'000'000; t += 20'000) {
        world.advanceTo(t);
        world.servoPulse(1, 1900, t);
        world.servoPulse(3, 1500, t);
    }
    world.advanceTo(t);
    EXPECT_NEAR(world.truth().aileron, 1, 0.01);
    EXPECT_NEAR(world.truth().throttle, 0.5, 0.01);
    EXPECT_EQ(world.servoPulse_us(3), 1500);
    EXPECT_EQ(world.servoPulse_us(5), 0);
    world.advanceTo(t + 1'000'000);
    EXPECT_NEAR(world.truth().aileron, 1, 0.01) << "stands where it is";
    EXPECT_NEAR(world.truth().throttle, 0, 0.01);
    EXPECT_EQ(world.servoPulse_us(3), 0);
}

TEST(World, has_the_motor_off_at_the_idle_pulse_and_full_at_1900) {
    for (auto [pulse, throttle] : {std::pair{1100.0, 0.0}, {900.0, 0.0}, {1900.0, 1.0}}) {
        World world({});
        for (uint64_t t = 0; t < 500'000; t += 20'000) {
            world.advanceTo(t);
            world.servoPulse(3, pulse, t);
        }
        EXPECT_NEAR(world.truth().throttle, throttle, 0.01);
    }
}

TEST(World, feeds_the_analogue_pins) {
    WorldOptions options;
    options.sensor_errors = false;
    World world(options);
    EXPECT_NEAR(world.analog_v(13, 1'000'000) * 10.1, 12.6, 0.05);
    EXPECT_NEAR(world.analog_v(12, 1'000'000) * 17, 0.3, 0.01);
    EXPECT_NEAR(world.analog_v(0, 1'000'000), 2.5, 1e-6);
    EXPECT_EQ(world.truth().time_us, 1'000'000u);
}

TEST(World, lets_the_gps_find_its_place) {
    World world({});
    uint64_t first_us = 0;
    for (uint64_t t = 0; t < 2'000'000 && first_us == 0; t += 1000) {
        world.advanceTo(t);
        if (world.gps().nextByte(t)) first_us = t;
    }
    EXPECT_NEAR(static_cast<double>(first_us), 1'201'000, 2000);
}

TEST(World, starts_the_radio_at_its_own_time) {
    World world({});
    world.advanceTo(777'000);
    world.radio().sticks({1500, 1500, 1100, 1500, 1500, 1500, 1500, 1500}, true);
    EXPECT_EQ(world.radio().nextEdge_us_x2(), 2 * (777'000u + PpmEncoder::kGap_us));
}

TEST(World, refuses_an_airplane_it_does_not_have) {
    WorldOptions options;
    options.airplane = "concorde";
    EXPECT_THROW(World{options}, std::runtime_error);
}

TEST(World, remembers_the_relay) {
    World world({});
    EXPECT_FALSE(world.relayOn());
    world.relay(true);
    EXPECT_TRUE(world.relayOn());
}

TEST(World, restarts_its_parts_when_the_supply_breaks_down) {
    WorldOptions options;
    options.faults = {*parseFault("supply:cut@1-1.1")};
    World world(options);
    world.advanceTo(20'000);
    wakeImu(world, 25'000);
    world.radio().sticks({1500, 1500, 1100, 1500, 1500, 1500, 1500, 1500}, true);
    world.advanceTo(1'000'000);
    EXPECT_NE(world.imu().nextSample_us(), UINT64_MAX);
    EXPECT_NE(world.radio().nextEdge_us_x2(), UINT64_MAX);
    world.advanceTo(1'050'000);
    EXPECT_EQ(world.supply_v(1'050'000), 0);
    EXPECT_EQ(world.imu().nextSample_us(), UINT64_MAX) << "asleep";
    EXPECT_EQ(world.radio().nextEdge_us_x2(), UINT64_MAX);
    EXPECT_EQ(world.gps().nextByte_us(), UINT64_MAX);
    world.advanceTo(1'590'000);
    EXPECT_EQ(world.radio().nextEdge_us_x2(), UINT64_MAX) << "the receiver has found nothing yet";
    world.advanceTo(1'640'000);
    EXPECT_NE(world.radio().nextEdge_us_x2(), UINT64_MAX);
}

// Whatever the firmware gives, also nothing for the motor.
TEST(World, connects_receiver_and_motor_by_channel_8_on_the_first_board_alone) {
    for (const bool first_board : {true, false}) {
        WorldOptions options;
        options.output_switch = first_board;
        World world(options);
        const auto fly = [&](uint16_t channel8_us, uint64_t from_us, uint64_t until_us) {
            world.radio().sticks({1500, 1500, 1700, 1500, 1500, 1500, 1500, channel8_us}, true);
            for (uint64_t t = from_us; t < until_us; t += 10'000) {
                world.advanceTo(t);
                while (world.radio().nextEdge_us_x2() <= 2 * t) world.radio().passEdge();
                for (int output = 1; output <= 4; ++output) world.servoPulse(output, 1100, t);
            }
        };
        fly(1300, 0, 1'000'000);
        EXPECT_NEAR(world.truth().throttle, 0, 0.01);
        fly(1850, 1'000'000, 2'000'000);
        EXPECT_NEAR(world.truth().throttle, first_board ? 0.75 : 0, 0.01);
        EXPECT_NEAR(world.truth().aileron, first_board ? 0 : -1, 0.01);
        EXPECT_EQ(world.servoPulse_us(3), 1100) << "what the firmware gives";
        fly(1300, 2'000'000, 3'000'000);
        EXPECT_NEAR(world.truth().throttle, 0, 0.01);
    }
}

TEST(World, sends_failsafe_values_after_a_brown_out_until_the_receiver_is_there) {
    World world({});
    world.radio().sticks({1500, 1500, 1800, 1500, 1500, 1500, 1500, 1165}, true);
    world.supply().add({1.5, 100'000, 120'000, 0});
    world.advanceTo(390'000);
    std::vector<uint64_t> widths;
    uint64_t last = 0;
    while (world.radio().nextEdge_us_x2() != UINT64_MAX && widths.size() < 9) {
        widths.push_back((world.radio().nextEdge_us_x2() - last) / 2);
        last = world.radio().nextEdge_us_x2();
        world.radio().passEdge();
    }
    ASSERT_EQ(widths.size(), 9u);
    EXPECT_EQ(widths[3], 900u);
    EXPECT_EQ(widths[5], 1555u);
    EXPECT_EQ(widths[8], 1500u);
}

TEST(World, gives_the_pitot_sensor_its_part_of_the_supply) {
    WorldOptions options;
    options.sensor_errors = false;
    options.faults = {*parseFault("supply:sag_4v_0ms@1-2")};
    World world(options);
    EXPECT_NEAR(world.analog_v(0, 900'000), 2.5, 1e-6);
    EXPECT_NEAR(world.analog_v(0, 1'500'000), 2.0, 1e-6);
    EXPECT_NEAR(world.analog_v(13, 1'500'000) * 10.1, 12.6, 0.05);
}

TEST(World, warms_its_board_up_in_minutes) {
    WorldOptions options;
    options.sensor_errors = false;
    options.board_warmth_start_c = -10;
    options.board_warmth_c = 25;
    World world(options);
    const auto raw = [&](uint64_t now_us) {
        world.advanceTo(now_us);
        askBarometer(world, 0x58, 0, now_us);
        world.advanceTo(now_us + 10'000);
        return askBarometer(world, 0, 3, now_us + 10'000);
    };
    const uint32_t cold = raw(100'000), warming = raw(240'000'000), warm = raw(1'500'000'000);
    const double part = (double(warming) - cold) / (double(warm) - cold);
    EXPECT_NEAR(part, 1 - std::exp(-1), 0.02);
}

TEST(World, delays_the_gps_as_its_receiver_does) {
    for (const double latency_s : {0.05, 0.4}) {
        WorldOptions options;
        options.gps_latency_s = latency_s;
        World world(options);
        world.advanceTo(1'000'000);
        EXPECT_EQ(world.gps().nextByte_us(), UINT64_MAX);
        world.advanceTo(1'000'000 + static_cast<uint64_t>(latency_s * 1e6));
        EXPECT_NE(world.gps().nextByte_us(), UINT64_MAX);
    }
}

TEST(World, has_a_band_gap_of_its_own) {
    WorldOptions options;
    EXPECT_NEAR(World(options).bandGap_v(), 1.1, 0.04);
    EXPECT_NE(World(options).bandGap_v(), 1.1);
    options.band_gap_v = 1.2;
    EXPECT_EQ(World(options).bandGap_v(), 1.2);
    options = {};
    options.sensor_errors = false;
    EXPECT_EQ(World(options).bandGap_v(), 1.1);
}

TEST(World, changes_the_mean_wind) {
    World world({});
    world.advanceTo(100'000);
    EXPECT_EQ(world.truth().wind_north_mps, 0);
    EXPECT_TRUE(world.setWind(5, 180));
    world.advanceTo(200'000);
    EXPECT_GT(world.truth().wind_north_mps, 0.3);  // standing it is below 10 m
    EXPECT_NEAR(world.truth().wind_east_mps, 0, 1e-9);

    WorldOptions held;
    held.bench_model = true;
    EXPECT_FALSE(World(held).setWind(5, 180));
}
