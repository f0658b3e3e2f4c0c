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

// -1..1 in steps of 2^-14
int16_t fixed(float value) { return static_cast<int16_t>(value * 16384.0f); }
// Rounded. Times four, the result lies in the upper half, which costs no shift.
int16_t share(int16_t whole, int16_t of_fixed) {
    const int32_t product = static_cast<int32_t>(whole) * of_fixed;
    return static_cast<int16_t>((product * 4 + 0x8000) >> 16);
}

}  // namespace

// Pulses are reckoned in integers, a float costs ten times as much.
uint16_t surfacePulse_us(const ServoRange& range, float deflection) {
    int16_t wanted = fixed(core::limit(deflection, -1.0f, 1.0f));
    if (range.reverse < 0) wanted = -wanted;
    const int16_t span_us =
        wanted > 0 ? range.max_us - range.trim_us : range.trim_us - range.min_us;
    const int16_t pulse_us = range.trim_us + share(span_us, wanted);
    return static_cast<uint16_t>(core::limit(pulse_us, range.min_us, range.max_us));
}

uint16_t throttlePulse_us(const ServoRange& range, float throttle) {
    const int16_t wanted = fixed(core::limit(throttle, 0.0f, 1.0f));
    const int16_t above_us = share(range.max_us - range.min_us, wanted);
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
