// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/sensors/accelerometer_fit.hpp"

#include <math.h>

#include "core/rom.hpp"

namespace firmware {
namespace sensors {

namespace {

// Up to which axis of the body each side points; force at rest points up.
struct Side {
    uint8_t axis;
    int8_t sign;
};
constexpr Side kUp[kSides] ROM = {{2, -1}, {1, 1}, {1, -1}, {0, -1}, {0, 1}, {2, 1}};

constexpr uint8_t kUnknowns = 6;
using Equations = float[kUnknowns][kUnknowns + 1];

uint8_t largestBelow(const Equations& m, uint8_t column) {
    uint8_t best = column;
    for (uint8_t row = column + 1; row < kUnknowns; ++row)
        if (fabsf(m[row][column]) > fabsf(m[best][column])) best = row;
    return best;
}

void exchange(float (&a)[kUnknowns + 1], float (&b)[kUnknowns + 1]) {
    for (uint8_t i = 0; i <= kUnknowns; ++i) {
        const float old = a[i];
        a[i] = b[i];
        b[i] = old;
    }
}

// Gauss and Jordan's elimination; the solution is left in the last column. 2 ms.
bool solve(Equations& m) {
    constexpr float kLeastPivot = 0.05f;
    for (uint8_t column = 0; column < kUnknowns; ++column) {
        exchange(m[column], m[largestBelow(m, column)]);
        const float pivot = m[column][column];
        if (!(fabsf(pivot) > kLeastPivot)) return false;
        const float part = core::inverse(pivot);
        for (uint8_t i = column; i <= kUnknowns; ++i) m[column][i] *= part;
        for (uint8_t row = 0; row < kUnknowns; ++row) {
            if (row == column) continue;
            const float times = m[row][column];
            for (uint8_t i = column; i <= kUnknowns; ++i) m[row][i] -= times * m[column][i];
        }
    }
    return true;
}

}  // namespace

void SideForces::put(uint8_t side, const core::Vector3& force_mss) {
    const float* const axes = &force_mss.x;
    for (uint8_t i = 0; i < 3; ++i)
        of[side][i] =
            static_cast<int16_t>(core::rounded(core::limit(axes[i] * kSteps, -32000.0f, 32000.0f)));
}

core::Vector3 SideForces::at(uint8_t side) const {
    const int16_t* const axes = of[side];
    return core::Vector3{core::real(axes[0]), core::real(axes[1]), core::real(axes[2])} *
           (1 / kSteps);
}

bool liesOn(uint8_t side, const core::Vector3& force_mss) {
    const Side up = core::romRead(kUp[side]);
    const float along = (&force_mss.x)[up.axis] * core::real(up.sign);
    return core::isPositive(along) && along * along > 0.82f * core::dot(force_mss, force_mss);
}

// A side reads a; s (a - o) is as long as g. With p = s^2 / c, q = -2 o p and c = g^2 - sum s^2 o^2
// that is sum (p a^2 + q a) = 1, linear in p and q.
bool fitSides(const SideForces& forces, AccelerometerFit& fit) {
    Equations m;
    for (uint8_t side = 0; side < kSides; ++side) {
        const core::Vector3 in_g = forces.at(side) * (1 / core::kGravity_mss);
        for (uint8_t i = 0; i < 3; ++i) {
            const float a = (&in_g.x)[i];
            m[side][i] = a * a;
            m[side][3 + i] = a;
        }
        m[side][kUnknowns] = 1;
    }
    if (!solve(m)) return false;
    float sum = 1;
    for (uint8_t i = 0; i < 3; ++i) {
        const float p = m[i][kUnknowns];
        if (!(p > 0.1f)) return false;
        const float offset_g = m[3 + i][kUnknowns] / (-2 * p);
        fit.offset_mss[i] = offset_g * core::kGravity_mss;
        sum += p * offset_g * offset_g;
    }
    for (uint8_t i = 0; i < 3; ++i) fit.scale[i] = sqrtf(m[i][kUnknowns] / sum);
    return true;
}

void lieOf(const core::Vector3& force_mss, float (&roll_pitch_rad)[2]) {
    roll_pitch_rad[0] = atan2f(-force_mss.y, -force_mss.z);
    roll_pitch_rad[1] = atan2f(force_mss.x, -force_mss.z);
}

}  // namespace sensors
}  // namespace firmware
