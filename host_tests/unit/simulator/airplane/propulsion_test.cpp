// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/airplane/propulsion.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <new>

#include "flying.hpp"

using namespace simulator;

namespace {

const AirplaneParameters kTrainer = loadAirplane("foam_trainer");
constexpr double kDensity = 1.225;

Propulsion running(double throttle, double ahead_mps, double duration_s = 2) {
    Propulsion propulsion(kTrainer);
    for (int i = 0; i < duration_s / Airplane::kStep_s; ++i)
        propulsion.advance(Airplane::kStep_s, throttle, ahead_mps, kDensity);
    return propulsion;
}

}  // namespace

TEST(Propulsion, pulls_about_four_fifths_of_the_weight_standing) {
    const double weight_n = kTrainer.mass_kg * kGravity_mss;
    EXPECT_NEAR(running(1, 0).thrust_n(0, kDensity) / weight_n, 0.8, 0.03);
}

// Whatever stood in the memory before.
TEST(Propulsion, begins_with_a_full_battery) {
    alignas(Propulsion) unsigned char memory[sizeof(Propulsion)];
    void* place = memory;
    std::memset(place, 0x7F, sizeof memory);  // 1.4e306 as a double
    asm volatile("" : "+r"(place) : : "memory");
    const auto* propulsion = new (place) Propulsion(kTrainer);

    EXPECT_DOUBLE_EQ(propulsion->battery_v(), kTrainer.battery.full_v * kTrainer.battery.cells);
}

TEST(Propulsion, pulls_less_the_faster_it_flies) {
    double last_n = 1e9;
    for (double speed : {0.0, 5.0, 10.0, 15.0, 20.0}) {
        const double thrust_n = running(0.8, speed).thrust_n(speed, kDensity);
        EXPECT_LT(thrust_n, last_n);
        last_n = thrust_n;
    }
}

TEST(Propulsion, brakes_a_little_with_the_motor_off) {
    Propulsion propulsion = running(0, 12.5);
    EXPECT_LT(propulsion.thrust_n(12.5, kDensity), 0);
    EXPECT_GT(propulsion.thrust_n(12.5, kDensity), -1);
    EXPECT_EQ(running(0, 0).shaft_rads(), 0);
}

TEST(Propulsion, never_creates_power) {
    for (double throttle : {0.3, 0.6, 1.0}) {
        const Propulsion p = running(throttle, 12.5);
        const double in_w = p.battery_v() * p.battery_a();
        const double out_w = p.thrust_n(12.5, kDensity) * 12.5;
        EXPECT_LT(out_w, 0.75 * in_w);
        EXPECT_LT(out_w, p.torque_nm(12.5, kDensity) * p.shaft_rads());
    }
}

TEST(Propulsion, sags_the_battery_by_its_resistance_and_counts_what_it_takes) {
    const Propulsion idle = running(0, 0), full = running(1, 0);
    const double sag_v = idle.battery_v() - full.battery_v();
    EXPECT_NEAR(sag_v, (full.battery_a() - idle.battery_a()) * kTrainer.battery.resistance_ohm,
                0.02);
    EXPECT_NEAR(running(0, 0, 360).used_mah(), kTrainer.battery.avionics_a * 100, 0.1);
}

TEST(Propulsion, dies_with_an_empty_battery) {
    const double fresh_n = running(1, 0).thrust_n(0, kDensity);
    const Propulsion flat = running(1, 0, 700);
    EXPECT_GT(flat.used_mah(), kTrainer.battery.capacity_mah * 0.95);
    EXPECT_LT(flat.thrust_n(0, kDensity), 0.8 * fresh_n);
}
