// SPDX-License-Identifier: GPL-3.0-or-later
#include "control/swing.hpp"

namespace control {
namespace {

constexpr core::BodyRate kSwing_rads(0.254f);
constexpr core::Ratio kFar(0.4f), kFarSlowly(0.8f);

}  // namespace

bool Swing::watch(core::BodyRate rate_rads, core::Ratio surface, Limits limits) {
    if (since_ < limits.runs) ++since_;
    if (surface.raw < low_) low_ = surface.raw;
    if (surface.raw > high_) high_ = surface.raw;
    if (since_ == limits.runs) swings_ = 0;
    const int8_t side =
        rate_rads.raw > kSwing_rads.raw ? 1 : (rate_rads.raw < -kSwing_rads.raw ? -1 : 0);
    if (side == 0 || side == side_) return false;
    const bool slow = since_ > limits.quick_runs;
    const bool far = int32_t{high_} - low_ > (slow ? kFarSlowly.raw : kFar.raw);
    side_ = side;
    since_ = 0;
    low_ = high_ = surface.raw;
    if (!far || ++swings_ < limits.most) return false;
    swings_ = 0;
    return true;
}

}  // namespace control
