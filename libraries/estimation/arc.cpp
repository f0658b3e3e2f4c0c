// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/arc.hpp"

#include <stdint.h>

#include "core/maths.hpp"
#include "core/rom.hpp"

namespace estimation {
namespace {

// asin at steps of 1/64 up to 0.75, past 45 degrees, where the cosine takes over; in 2^-15 rad.
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
            static_cast<uint16_t>(arcsine(static_cast<float>(i) / 64.0f) * 32768.0f + 0.5f);
    }
    return table;
}
constexpr Table kTable ROM = makeTable();

// The smaller of a sine and its cosine, both positive.
float tableArcsine(float x) {
    uint16_t fixed = static_cast<uint16_t>(x * 16384.0f);  // 64 steps of 256
    if (fixed > kSteps * 256U) fixed = kSteps * 256U;
    const uint8_t step = static_cast<uint8_t>(fixed >> 8);
    const uint8_t part = static_cast<uint8_t>(fixed);
    const uint16_t low = core::romRead(kTable.arc[step]);
    const uint16_t rise = core::romRead(kTable.arc[step + 1]) - low;  // below 1024
    const uint16_t between =
        static_cast<uint16_t>((static_cast<uint32_t>(rise) * static_cast<uint16_t>(part)) >> 8);
    return static_cast<float>(static_cast<uint16_t>(low + between)) * (1.0f / 32768.0f);
}

}  // namespace

float arc_rad(float sine, float cosine) {
    const float rise = fabsf(sine), run = fabsf(cosine);
    float angle = rise < run ? tableArcsine(rise) : core::kPi / 2 - tableArcsine(run);
    if (cosine < 0) angle = core::kPi - angle;
    return sine < 0 ? -angle : angle;
}

}  // namespace estimation
