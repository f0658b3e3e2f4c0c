// SPDX-License-Identifier: GPL-3.0-or-later
#include "control/mixing.hpp"

#include "core/maths.hpp"
#include "core/rom.hpp"

namespace control {
namespace {

struct Signs {
    int8_t left, right;
};
// clang-format off
constexpr Signs kPairs[kPairKinds] ROM = {
    {  0,  0 },  // none
    {  1,  1 },  // up_up
    {  1, -1 },  // up_down
    { -1,  1 },  // down_up
    { -1, -1 },  // down_down
};
// clang-format on

constexpr int16_t kFull = core::Ratio::kOne;

}  // namespace

uint16_t surfacePulse_us(const ServoRange& range, core::Ratio deflection) {
    int16_t wanted = core::limit<int16_t>(deflection.raw, -kFull, kFull);
    if (range.reverse < 0) wanted = -wanted;
    const int16_t span_us =
        wanted > 0 ? range.max_us - range.trim_us : range.trim_us - range.min_us;
    const int16_t pulse_us = range.trim_us + core::times14(span_us, wanted);
    return static_cast<uint16_t>(core::limit(pulse_us, range.min_us, range.max_us));
}

uint16_t throttlePulse_us(const ServoRange& range, core::Ratio throttle) {
    const int16_t wanted = core::limit<int16_t>(throttle.raw, 0, kFull);
    const int16_t above_us = core::times14(range.max_us - range.min_us, wanted);
    return range.reverse < 0 ? range.max_us - above_us : range.min_us + above_us;
}

PairDeflection mixPair(Pair kind, float common, float differential, float gain) {
    const Signs signs = core::romRead(kPairs[static_cast<uint8_t>(kind)]);
    const float both = core::limit(common * gain, -1.0f, 1.0f);
    const float room = 1.0f - (both < 0 ? -both : both);
    const float apart = core::limit(differential * gain, -room, room);
    return {signs.left * (both + apart), signs.right * (both - apart)};
}

}  // namespace control
