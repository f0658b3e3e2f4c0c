// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/ground/landing_check.hpp"

#include <cmath>

namespace simulator {

// Where it stands is the wheels' and the grass's doing: they roll 150 m from 14 m/s.
constexpr double kTouchesWithin_m = 60, kStandsWithin_m = 250;

static std::string beyond(const char* does, double away_m, double most_m) {
    return does + std::to_string(std::lround(away_m)) + " m from the landing point, more than " +
           std::to_string(std::lround(most_m)) + " m";
}

std::string landingFault(std::optional<double> touchdown_m, double standing_m) {
    if (!touchdown_m) return "it never touched down";
    if (*touchdown_m > kTouchesWithin_m)
        return beyond("it touched down ", *touchdown_m, kTouchesWithin_m);
    if (standing_m > kStandsWithin_m) return beyond("it stands ", standing_m, kStandsWithin_m);
    return "";
}

}  // namespace simulator
