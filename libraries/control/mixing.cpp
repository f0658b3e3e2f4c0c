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

int16_t limited(int16_t value, int16_t most) { return core::limit<int16_t>(value, -most, most); }

// Of a control that may be past its end, where the product would not fit.
int16_t times(core::Ratio control, core::Ratio gain) {
    return core::times14(limited(control.raw, kFullTravel), gain.raw);
}

}  // namespace

PairDeflection mixPair(Pair kind, core::Ratio common, core::Ratio differential, core::Ratio gain) {
    const Signs signs = core::romRead(kPairs[static_cast<uint8_t>(kind)]);
    const int16_t both = limited(times(common, gain), kFullTravel);
    const int16_t room = kFullTravel - (both < 0 ? -both : both);
    const int16_t apart = limited(times(differential, gain), room);
    return {core::Ratio::fromRaw(signs.left * (both + apart)),
            core::Ratio::fromRaw(signs.right * (both - apart))};
}

}  // namespace control
