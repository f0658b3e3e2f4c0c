// SPDX-License-Identifier: GPL-3.0-or-later
// What the accelerometers read too much and by how much they stretch, worked out of how they read
// at rest on each of six sides: there they measure gravity alone, and that is known.
#pragma once
#include <stdint.h>

#include "core/maths.hpp"

namespace firmware {
namespace sensors {

constexpr uint8_t kSides = 6;
constexpr uint8_t kLevelSide = 0;  // of the order in which ground stations show them

struct SideForces {
    static constexpr float kSteps = 1024;  // of a m/s2
    int16_t of[kSides][3];
    void put(uint8_t side, const core::Vector3& force_mss);
    core::Vector3 at(uint8_t side) const;
};

// Is what it measures what it would on that side, give or take 25 degrees?
bool liesOn(uint8_t side, const core::Vector3& force_mss);

struct AccelerometerFit {
    float offset_mss[3], scale[3];  // as INS_ACCOFFS and INS_ACCSCAL have them
};
// The numbers with which each of the six is as long as gravity. False: there are none.
bool fitSides(const SideForces& forces, AccelerometerFit& fit);

// Of a level side that has been taken off its errors: how the board lies in the airplane.
void lieOf(const core::Vector3& force_mss, float (&roll_pitch_rad)[2]);

}  // namespace sensors
}  // namespace firmware
