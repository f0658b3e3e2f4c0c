// SPDX-License-Identifier: GPL-3.0-or-later
#include "toolchain/mission_tool/power.hpp"

#include <algorithm>
#include <cmath>

#include "simulator/airplane/atmosphere.hpp"
#include "simulator/airplane/propulsion.hpp"

namespace mission_tool {
namespace {

using simulator::kGravity_mss;
using simulator::kSeaLevelDensity_kgm3;

int hundredths(double value) {
    constexpr double kLargest = 1e6;
    return static_cast<int>(std::lround(std::max(-kLargest, std::min(kLargest, value)) * 100));
}

}  // namespace

Power::Power(const simulator::AirplaneParameters& airplane)
    : airplane_(airplane), capacity_mah_(airplane.battery.capacity_mah) {
    constexpr double kHalf = 0.5, kEndless_mah = 1e9;
    auto& battery = airplane_.battery;
    battery.full_v = battery.knee_v + (battery.full_v - battery.knee_v) *
                                          (kHalf - battery.knee_charge) / (1 - battery.knee_charge);
    battery.capacity_mah = kEndless_mah;
}

// The drag of the lift that carries `load` times the weight: the polar of aerodynamics.hpp below
// the stall.
double Power::drag_n(double airspeed_mps, double load) const {
    const double pressure_n =
        0.5 * kSeaLevelDensity_kgm3 * airspeed_mps * airspeed_mps * airplane_.area_m2;
    const double lift = load * airplane_.mass_kg * kGravity_mss / pressure_n;
    const auto& shape = airplane_.drag;
    return pressure_n * (shape.parasite + shape.induced * lift * lift);
}

Power::Steady Power::steady(double throttle, double airspeed_mps) const {
    constexpr double kStep_s = 0.0025, kSettled_s = 1.5;
    simulator::Propulsion propulsion(airplane_);
    for (double time_s = 0; time_s < kSettled_s; time_s += kStep_s)
        propulsion.advance(kStep_s, throttle, airspeed_mps, kSeaLevelDensity_kgm3);
    return {propulsion.thrust_n(airspeed_mps, kSeaLevelDensity_kgm3), propulsion.battery_a()};
}

double Power::battery_a(double airspeed_mps, double climb_mps, double load) const {
    const auto key = std::make_tuple(hundredths(airspeed_mps), hundredths(climb_mps),
                                     hundredths(load));
    if (const auto known = known_.find(key); known != known_.end()) return known->second;
    const double weight_n = airplane_.mass_kg * kGravity_mss;
    const double needed_n = drag_n(airspeed_mps, load) + weight_n * climb_mps / airspeed_mps;
    double low = 0, high = 1;
    for (int i = 0; i < 12; ++i) {
        const double middle = (low + high) / 2;
        (steady(middle, airspeed_mps).thrust_n < needed_n ? low : high) = middle;
    }
    // closed, the propeller may brake more than is needed: then nothing is drawn by the motor
    const bool closed = needed_n <= 0;
    return known_[key] = steady(closed ? 0 : high, airspeed_mps).battery_a;
}

double Power::largestClimb_mps(double airspeed_mps) const {
    const double spare_n = steady(1, airspeed_mps).thrust_n - drag_n(airspeed_mps, 1);
    return spare_n * airspeed_mps / (airplane_.mass_kg * kGravity_mss);
}

}  // namespace mission_tool
