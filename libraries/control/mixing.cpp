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

}  // namespace

PairDeflection mixPair(Pair kind, float common, float differential, float gain) {
    const Signs signs = core::romRead(kPairs[static_cast<uint8_t>(kind)]);
    const float both = core::limit(common * gain, -1.0f, 1.0f);
    const float room = 1.0f - (both < 0 ? -both : both);
    const float apart = core::limit(differential * gain, -room, room);
    return {signs.left * (both + apart), signs.right * (both - apart)};
}

}  // namespace control
