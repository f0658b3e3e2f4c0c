// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivers/orientation.hpp"

#include "core/rom.hpp"

namespace drivers {
namespace {

constexpr uint8_t kHalfQuarter = 1 << 6;

// Quarters of a turn of roll and pitch, eighths of yaw, as two bits each and kHalfQuarter.
constexpr uint8_t turns(uint8_t roll, uint8_t pitch, uint8_t yaw) {
    return static_cast<uint8_t>(roll | pitch << 2 | yaw / 2 << 4 | yaw % 2 * kHalfQuarter);
}

// clang-format off
constexpr uint8_t kMountings[kOrientations] ROM = {
    turns(0, 0, 0), turns(0, 0, 1), turns(0, 0, 2), turns(0, 0, 3),  // from 0 on
    turns(0, 0, 4), turns(0, 0, 5), turns(0, 0, 6), turns(0, 0, 7),  // from 4 on
    turns(2, 0, 0), turns(2, 0, 1), turns(2, 0, 2), turns(2, 0, 3),  // from 8 on
    turns(0, 2, 0), turns(2, 0, 5), turns(2, 0, 6), turns(2, 0, 7),  // from 12 on
    turns(1, 0, 0), turns(1, 0, 1), turns(1, 0, 2), turns(1, 0, 3),  // from 16 on
    turns(3, 0, 0), turns(3, 0, 1), turns(3, 0, 2), turns(3, 0, 3),  // from 20 on
    turns(0, 1, 0), turns(0, 3, 0), turns(0, 2, 2), turns(0, 2, 6),  // from 24 on
    turns(1, 1, 0), turns(2, 1, 0), turns(3, 1, 0), turns(1, 2, 0),  // from 28 on
    turns(3, 2, 0), turns(1, 3, 0), turns(2, 3, 0), turns(3, 3, 0),  // from 32 on
    turns(1, 2, 2), turns(1, 0, 6),  // from 36 on
};
// clang-format on

}  // namespace

core::Vector3 fromMounting(const core::Vector3& measured, uint8_t orientation) {
    constexpr float kHalfSqrt2 = 0.70710678f;
    core::Vector3 v = measured;
    if (orientation >= kOrientations) return v;
    const uint8_t mounting = core::romRead(kMountings[orientation]);
    uint8_t quarters = mounting;
    for (uint8_t axis = 0; axis < 3; ++axis, quarters >>= 2) {
        float& from = (&v.x)[(axis + 1) % 3];
        float& towards = (&v.x)[(axis + 2) % 3];
        for (uint8_t turned = 0; turned < (quarters & 3); ++turned) {
            const float before = from;
            from = -towards;
            towards = before;
        }
    }
    if (mounting & kHalfQuarter) v = {(v.x - v.y) * kHalfSqrt2, (v.x + v.y) * kHalfSqrt2, v.z};
    return v;
}

}  // namespace drivers
