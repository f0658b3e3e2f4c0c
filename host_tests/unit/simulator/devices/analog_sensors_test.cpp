// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "simulator/devices/analog_sensors.hpp"
#include "simulator/world.hpp"
#include "statistics.hpp"

using namespace simulator;

namespace {

Truth flying(double equivalent_airspeed_mps) {
    Truth truth{};
    truth.equivalent_airspeed_mps = equivalent_airspeed_mps;
    truth.battery_v = 11.1;
    truth.motor_current_a = 8.5;
    return truth;
}

}  // namespace

TEST(AnalogSensors, give_a_volt_a_kilopascal_about_half_the_supply) {
    AnalogSensors sensors(1, SensorErrors::none());
    EXPECT_DOUBLE_EQ(sensors.volts(0, flying(0)), 2.5);
    EXPECT_NEAR(sensors.volts(0, flying(20)), 2.5 + 0.245, 1e-9);
}

TEST(AnalogSensors, measure_no_airspeed_from_behind) {
    AnalogSensors sensors(1, SensorErrors::none());
    Truth truth = flying(5);
    truth.alpha_rad = M_PI;
    EXPECT_DOUBLE_EQ(sensors.volts(0, truth), 2.5);
    truth.alpha_rad = 0.3;
    EXPECT_NEAR(sensors.volts(0, truth), 2.5 + 0.0153, 1e-4);
}

TEST(AnalogSensors, show_the_power_modules_voltage_and_current) {
    AnalogSensors sensors;
    EXPECT_NEAR(sensors.volts(13, flying(0)) * 10.1, 11.1, 1e-9);
    EXPECT_NEAR(sensors.volts(12, flying(0)) * 17.0, 8.5, 1e-9);
    EXPECT_EQ(sensors.volts(5, flying(0)), 0);
}

TEST(AnalogSensors, err_by_the_noise_of_the_table) {
    const SensorErrors errors;
    AnalogSensors sensors(1, errors);
    Statistics volts;
    for (int i = 0; i < 20'000; ++i) volts.add(sensors.volts(0, flying(0)));
    EXPECT_NEAR(volts.deviation(), errors.airspeed_noise_v, 0.0001);
}

TEST(AnalogSensors, err_by_the_ratio_and_offset_of_the_table) {
    SensorErrors errors;
    errors.airspeed_noise_v = 0;
    Statistics ratio, offset;
    for (uint64_t seed = 1; seed <= 4000; ++seed) {
        AnalogSensors sensors(seed, errors);
        const double zero_v = sensors.volts(0, flying(0));
        offset.add(zero_v - 2.5);
        ratio.add((sensors.volts(0, flying(20)) - zero_v) / 0.245);
    }
    EXPECT_NEAR(ratio.mean(), 1, 0.001);
    EXPECT_NEAR(ratio.deviation(), errors.airspeed_ratio, 0.001);
    EXPECT_NEAR(offset.deviation(), errors.airspeed_offset_v, 0.001);
}
