// SPDX-License-Identifier: GPL-3.0-or-later
#include "control/mixing.hpp"

#include "core/maths.hpp"
#include "core/rom.hpp"

namespace control {
namespace {

// clang-format off
constexpr int8_t kSigns[kPairKinds][2] ROM = {  // left, right
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

core::Ratio mixPair(Pair kind, Side side, core::Ratio common, core::Ratio differential,
                    core::Ratio gain) {
    const int16_t both = limited(times(common, gain), kFullTravel);
    const int16_t room = kFullTravel - (both < 0 ? -both : both);
    const int16_t apart = limited(times(differential, gain), room);
    const int16_t sum = side == Side::left ? both + apart : both - apart;
    const int8_t sign =
        core::romRead(kSigns[static_cast<uint8_t>(kind)][static_cast<uint8_t>(side)]);
    return core::Ratio::fromRaw(sign * sum);
}

}  // namespace control
