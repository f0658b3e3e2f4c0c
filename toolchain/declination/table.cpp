// SPDX-License-Identifier: GPL-3.0-or-later
#include "toolchain/declination/table.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace declination {
namespace {

constexpr int kStep_deg = 10, kMax_deg = 70;
constexpr double kPerDegree = 8.0 / 5;  // one byte holds +-79 degrees
constexpr double kSouthernmostPerDegree = kPerDegree / 2;  // and there +-158

constexpr char kAbove[] =
    R"(// SPDX-License-Identifier: GPL-3.0-or-later
// Magnetic declination in 5/8 degrees (at 70 S in 5/4, where it is larger: at most 158) every 10
// degrees, from 70 S northwards and from 180 W eastwards, at sea level in mid-2027. Made by
// toolchain/declination from the World Magnetic Model 2025 of NOAA NCEI and the British Geological
// Survey: do not edit.
#pragma once
#include <stdint.h>

#include "core/rom.hpp"

namespace geo {

constexpr uint8_t kDeclinationRows = 15, kDeclinationColumns = 36;

// clang-format off
constexpr int8_t kDeclinations[] ROM = {
)";
constexpr char kBelow[] = R"(};
static_assert(sizeof kDeclinations == kDeclinationRows * kDeclinationColumns, "");

// Latitude in degrees at which the field lies level, in the middle of every 10 degrees from 180 W
// eastwards.
constexpr int8_t kDipEquator_deg[kDeclinationColumns] ROM = {
LEVEL};
// clang-format on

}  // namespace geo
)";
constexpr char kLevel[] = "LEVEL";

long numberAt(const Model& model, int latitude_deg, int longitude_deg) {
    const bool southernmost = latitude_deg == -kMax_deg;
    const double per_degree = southernmost ? kSouthernmostPerDegree : kPerDegree;
    const double declination_deg =
        model.at(latitude_deg, longitude_deg, 0, kTableYear).declination_deg();
    const long number = std::lround(declination_deg * per_degree);
    if (southernmost) return std::clamp(number, -127L, 127L);  // where no compass shows a heading
    if (number < -128 || number > 127) throw std::runtime_error("no byte holds it");
    return number;
}

double dipEquator_deg(const Model& model, double longitude_deg) {
    double south_deg = -40, north_deg = 40;
    while (north_deg - south_deg > 0.01) {
        const double middle_deg = (south_deg + north_deg) / 2;
        const bool down = model.at(middle_deg, longitude_deg, 0, kTableYear).down_nt > 0;
        (down ? north_deg : south_deg) = middle_deg;
    }
    return south_deg;
}

std::string dipEquator(const Model& model) {
    std::string rows;
    for (int longitude = -180; longitude < 180; longitude += kStep_deg) {
        const double level_deg = dipEquator_deg(model, longitude + kStep_deg / 2.0);
        rows += (longitude + 180) % 120 == 0 ? "    " : " ";
        rows += std::to_string(std::lround(level_deg)) + ',';
        if ((longitude + 180) % 120 == 110) rows += '\n';
    }
    return rows;
}

}  // namespace

std::string tableHeader(const Model& model) {
    std::string text = kAbove;
    for (int latitude = -kMax_deg; latitude <= kMax_deg; latitude += kStep_deg) {
        text += "    // " + std::to_string(latitude);
        for (int longitude = -180; longitude < 180; longitude += kStep_deg) {
            text += (longitude + 180) % 120 == 0 ? "\n    " : " ";
            text += std::to_string(numberAt(model, latitude, longitude)) + ',';
        }
        text += '\n';
    }
    std::string below = kBelow;
    below.replace(below.find(kLevel), sizeof kLevel - 1, dipEquator(model));
    return text + below;
}

}  // namespace declination
