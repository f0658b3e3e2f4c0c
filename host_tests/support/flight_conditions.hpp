// SPDX-License-Identifier: GPL-3.0-or-later
// A mission that has nothing to be found, what is to be changed of it, and the findings.
#pragma once
#include "firmware/state/parameters.hpp"
#include "mission_tool_rig.hpp"
#include "toolchain/mission_tool/airplane.hpp"
#include "toolchain/mission_tool/flight_findings.hpp"

namespace mission_tool {

constexpr char kHome[] = "APM 2.0\n0x10 0 0 0 470000000 80000000\n";
constexpr char kTakeoff[] = "0x16 1 15 5000 0 0\n";
constexpr char kNorth[] = "0x10 1 0 6000 470050000 80000000\n";  // 556 m
constexpr char kEast[] = "0x10 1 0 6000 470050000 80080000\n";   // 608 m on
constexpr char kLand[] = "0x15 1 0 0 470000000 80000000\n";

inline std::string good(const std::string& lines = std::string(kNorth) + kEast) {
    return kHome + std::string(kTakeoff) + lines + kLand;
}

// "item: text", warnings with "warning: "; set: what to change of the board's parameters.
template <class Set>
std::string found(const std::string& text, const Conditions& conditions, Set set) {
    static const Power power(airplaneNamed(kUsualAirplane));
    Document document = loaded(text);
    set();
    const FlightOrder order = flightOrder(document);
    std::string all;
    for (const Finding& each : flightFindings(
             document, order, estimate(document, order, power, conditions.wind), conditions))
        all += std::to_string(each.index) + (each.error ? ": " : ": warning: ") + each.text + '\n';
    return all;
}
inline std::string found(const std::string& text, const Conditions& conditions = {}) {
    return found(text, conditions, [] {});
}
inline Conditions inWind(double speed_mps) { return {{speed_mps, {}}, 5000, {}}; }

// Metres around home.
inline simulator::Place at(double north_m, double east_m) {
    return {47 + north_m / 111'180, 8 + east_m / 76'060};
}
inline Conditions within(double south_m, double north_m, double west_m, double east_m) {
    Conditions conditions;
    conditions.fence.areas = {
        {true,
         {at(south_m, west_m), at(south_m, east_m), at(north_m, east_m), at(north_m, west_m)},
         0}};
    conditions.fence.way_back = at(0, 0);
    return conditions;
}

}  // namespace mission_tool
