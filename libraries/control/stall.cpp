// SPDX-License-Identifier: GPL-3.0-or-later
#include "control/stall.hpp"

#include "core/maths.hpp"

namespace control {
namespace {

constexpr uint8_t steps(float seconds) { return static_cast<uint8_t>(seconds * 20 + 0.5f); }

// The servo and the airplane's inertia need 0.2 s until the nose follows; gusts last no longer.
constexpr uint8_t kSeen = steps(0.35f);
constexpr uint8_t kShortestBreak = steps(0.4f), kLongestBreak = steps(1.5f);
constexpr uint8_t kLongestPullOut = steps(6);  // whatever the speed: it may be measured wrongly
constexpr core::Ratio kFarUp(0.55f);
constexpr core::Angle kShort_rad(core::radians(6)), kThere_rad(core::radians(3));

// The nose is not going to be where it is demanded within 1.6 s, though the loop wants it there
// within a few tenths: an angle's step is 10.2 times as fine as a rate's.
bool noseStays(const StallSigns& signs) {
    constexpr int32_t kAngleInTime = 16;
    return signs.short_rad.raw > kShort_rad.raw &&
           kAngleInTime * signs.rate_rads.raw < signs.short_rad.raw;
}

bool isFarUp(const StallSigns& signs) {
    return !Stall::calm(signs.elevator) && (signs.slow || signs.elevator.raw > kFarUp.raw);
}

}  // namespace

void Stall::begin(Phase phase) {
    phase_ = phase;
    steps_ = seen_ = 0;
}

void Stall::breakIt(const StallSigns& signs) {
    if (steps_ >= (signs.slow ? kLongestBreak : kShortestBreak)) begin(Phase::pulling_out);
}

void Stall::watch(const StallSigns& signs) {
    const bool held_up = signs.falls && signs.elevator.raw > kHolds.raw;
    if (held_up || (isFarUp(signs) && signs.sinks && noseStays(signs)))
        ++seen_;
    else
        runCalm();
    if (seen_ >= kSeen) return begin(Phase::breaking);
    const bool there = signs.short_rad.raw < kThere_rad.raw && !signs.slow;
    if (phase_ == Phase::pulling_out && (there || steps_ >= kLongestPullOut)) begin(Phase::flying);
}

void Stall::run(const StallSigns& signs) {
    if (steps_ < UINT8_MAX) ++steps_;
    if (phase_ == Phase::breaking)
        breakIt(signs);
    else
        watch(signs);
}

}  // namespace control
