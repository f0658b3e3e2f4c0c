// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/atan2_table.hpp"

#include <stdint.h>

#include "core/maths.hpp"
#include "core/rom.hpp"

namespace estimation {
namespace {

// asin at steps of 1/64 up to 0.75, past 45 degrees, where the cosine takes over; in radians.
using Arc = core::Fixed<15>;
constexpr uint8_t kSteps = 48;
struct Table {
    uint16_t arc[kSteps + 2];
};

constexpr float arcsine(float x) {  // its power series; converges to 1e-6 for x <= 0.77
    float term = x, sum = x;
    for (int n = 1; n < 40; ++n) {
        term *= x * x * static_cast<float>(2 * n - 1) / static_cast<float>(2 * n);
        sum += term / static_cast<float>(2 * n + 1);
    }
    return sum;
}

constexpr Table makeTable() {
    Table table = {};
    for (uint8_t i = 0; i < kSteps + 2; ++i) {
        table.arc[i] =
            static_cast<uint16_t>(arcsine(static_cast<float>(i) / 64.0f) * Arc::kSteps + 0.5f);
    }
    return table;
}
constexpr Table kTable ROM = makeTable();

// An Arc's steps, of those of the smaller of a sine and its cosine, both positive Ratios.
uint16_t tableArcsine(uint16_t x) {  // 64 steps of 256
    if (x > kSteps * 256U) x = kSteps * 256U;
    const uint8_t step = static_cast<uint8_t>(x >> 8);
    const uint8_t part = static_cast<uint8_t>(x);
    const uint16_t low = core::romRead(kTable.arc[step]);
    const uint16_t rise = core::romRead(kTable.arc[step + 1]) - low;  // below 1024
    // in two parts, as 16 bits hold no product of both
    const uint16_t between = static_cast<uint16_t>((rise >> 8) * part) +
                             (static_cast<uint16_t>(static_cast<uint8_t>(rise) * part) >> 8);
    return low + between;
}

// An Angle's steps.
uint16_t tableArcsine_turn(uint16_t x) {
    constexpr core::Fixed<16> kAngles(core::Angle::kSteps / Arc::kSteps);
    return static_cast<uint16_t>((static_cast<uint32_t>(tableArcsine(x)) * kAngles.raw + 0x8000) >>
                                 16);
}

}  // namespace

core::Angle tableAtan2(core::Ratio sine, core::Ratio cosine) {
    const uint16_t rise = static_cast<uint16_t>(sine.raw < 0 ? -sine.raw : sine.raw);
    const uint16_t run = static_cast<uint16_t>(cosine.raw < 0 ? -cosine.raw : cosine.raw);
    uint16_t angle = rise < run ? tableArcsine_turn(rise) : 0x4000 - tableArcsine_turn(run);
    if (cosine.raw < 0) angle = 0x8000 - angle;
    if (sine.raw < 0) angle = -angle;
    return core::Angle::fromRaw(static_cast<int16_t>(angle));
}

}  // namespace estimation
