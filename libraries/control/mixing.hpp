// SPDX-License-Identifier: GPL-3.0-or-later
// From deflections to servo pulses: trim, ends and direction of one servo, and the sums that a
// pair of surfaces makes of two controls.
#pragma once
#include <stdint.h>

#include "core/fixed.hpp"
#include "core/maths.hpp"

namespace control {

constexpr int16_t kFullTravel = core::Ratio::kOne;

// Range, of a servo: int16_t min_us, trim_us, max_us and reverse, 1 or -1, read where they are.

// -1 .. 0 .. 1 lies on min .. trim .. max, or max .. trim .. min when reversed.
template <class Range>
uint16_t surfacePulse_us(const Range& range, core::Ratio deflection) {
    int16_t wanted = core::limit<int16_t>(deflection.raw, -kFullTravel, kFullTravel);
    if (range.reverse < 0) wanted = -wanted;
    const int16_t span_us =
        wanted > 0 ? range.max_us - range.trim_us : range.trim_us - range.min_us;
    const int16_t pulse_us = range.trim_us + core::times14(span_us, wanted);
    return static_cast<uint16_t>(core::limit(pulse_us, range.min_us, range.max_us));
}

// 0 .. 1 lies on min .. max, trim plays no part.
template <class Range>
uint16_t throttlePulse_us(const Range& range, core::Ratio throttle) {
    const int16_t wanted = core::limit<int16_t>(throttle.raw, 0, kFullTravel);
    const int16_t above_us = core::times14(range.max_us - range.min_us, wanted);
    return range.reverse < 0 ? range.max_us - above_us : range.min_us + above_us;
}

// A pair of surfaces, each moved by two controls. The parameters' kinds 1..4 are the four ways
// the linkages can be turned.
enum class Pair : uint8_t { none, up_up, up_down, down_up, down_down };
constexpr uint8_t kPairKinds = 5;

enum class Side : uint8_t { left, right };
// The deflection of one of them, -1..1. `common` moves both alike (elevator), `differential` one up
// and one down (aileron, rudder), each -1..1; `gain` is MIXING_GAIN, 0..2. When the sum is more
// than a surface has, `common` gives way last.
core::Ratio mixPair(Pair kind, Side side, core::Ratio common, core::Ratio differential,
                    core::Ratio gain);

}  // namespace control
