// SPDX-License-Identifier: GPL-3.0-or-later
// From deflections to servo pulses: trim, ends and direction of one servo, and the sums that a
// pair of surfaces makes of two controls.
#pragma once
#include <stdint.h>

#include "core/fixed.hpp"

namespace control {

struct ServoRange {
    int16_t min_us, trim_us, max_us;
    int8_t reverse;  // 1 or -1
};

// -1 .. 0 .. 1 lies on min .. trim .. max, or max .. trim .. min when reversed.
uint16_t surfacePulse_us(const ServoRange& range, core::Ratio deflection);
// 0 .. 1 lies on min .. max, trim plays no part.
uint16_t throttlePulse_us(const ServoRange& range, core::Ratio throttle);

// A pair of surfaces, each moved by two controls. The parameters' kinds 1..4 are the four ways
// the linkages can be turned.
enum class Pair : uint8_t { none, up_up, up_down, down_up, down_down };
constexpr uint8_t kPairKinds = 5;

struct PairDeflection {
    float left, right;
};
// `common` moves both alike (elevator), `differential` one up and one down (aileron, rudder);
// `gain` is MIXING_GAIN. When the sum is more than a surface has, `common` gives way last.
PairDeflection mixPair(Pair kind, float common, float differential, float gain);

}  // namespace control
