// SPDX-License-Identifier: GPL-3.0-or-later
#include "toolchain/mission_tool/turns.hpp"

#include <algorithm>
#include <cmath>

#include "firmware/state/parameters.hpp"
#include "simulator/airplane/atmosphere.hpp"

namespace mission_tool {
namespace {

using firmware::state::parameters;

constexpr double kDegree = M_PI / 180;

double courseOf(const Stretch& s) {
    return std::atan2(s.to.east_m - s.from.east_m, s.to.north_m - s.from.north_m);
}
bool straight(const Stretch& s) {
    return s.circle_m == 0 && simulator::distance_m(s.from, s.to) > 1;
}

}  // namespace

double bankLimit_deg(double airspeed_mps) {
    constexpr double kAlways_deg = 25;
    const double limit_deg = parameters.roll_limit_cd * 0.01;
    const double ratio = parameters.speed_min_mps / airspeed_mps;
    if (parameters.stall_prevention == 0 || ratio >= 1) return limit_deg;
    return std::min(limit_deg, std::max(kAlways_deg, std::acos(ratio * ratio) / kDegree));
}

double turnTangent(double airspeed_mps) {
    constexpr double kTurnShare = 0.7, kSteepest_deg = 80;
    return kTurnShare * std::tan(std::min(bankLimit_deg(airspeed_mps), kSteepest_deg) * kDegree);
}

double turnRadius_m(double airspeed_mps, double ground_mps) {
    return ground_mps * ground_mps / (simulator::kGravity_mss * turnTangent(airspeed_mps));
}

double turnBetween_rad(const Stretch& before, const Stretch& after) {
    if (!before.placed || !straight(before) || !straight(after)) return 0;
    return std::abs(std::remainder(courseOf(after) - courseOf(before), 2 * M_PI));
}

}  // namespace mission_tool
