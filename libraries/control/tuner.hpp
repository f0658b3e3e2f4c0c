// SPDX-License-Identifier: GPL-3.0-or-later
// Learns from the turns of one axis, from rest to rest, how strong its surface is: over such a turn
// the surface that was used, against the one that the feed-forward expects for the rates that
// came, is a ratio in which the axis's inertia has no part (what it takes at the beginning it gives
// back at the end), nor gusts, which turn the airplane to either side. The gains of a loop want to
// be multiplied by that ratio.
#pragma once
#include "control/axis.hpp"
#include "control/swing.hpp"

namespace control {

class AxisTuner {
public:
    enum class Finding : uint8_t {
        nothing,
        measured,  // factor() holds
        shakes,    // the airplane swings about where it is to be: the gains are too high
    };

    constexpr AxisTuner() {}

    // Every frame, after axisDeflection with the same arguments. The swing is watched between
    // turns.
    Finding watch(const AxisGains& gains, const AxisState& state, const AirFlow& air,
                  core::BodyRate demand_rads, core::BodyRate rate_rads, Swing& swing);
    // What lasted so far counts no more.
    void drop() { frames_ = 0; }

    // For the gains; within 0.8 .. 1.25, so that one bad turn changes little.
    float factor() const;
    static constexpr float kLeast = 0.8f, kMax = 1.25f;

private:
    bool swingsOn(int16_t rate);

    int32_t used_ = 0, expected_ = 0;  // of the surface, summed up
    core::Ratio rest_ = {};            // the surface before the turn
    core::BodyRate fastest_rads_ = {};
    uint16_t frames_ = 0;  // of the turn under way; 0: none
    int8_t side_ = 0;      // which way it turned last in the turn under way
    uint8_t swings_ = 0;   // in that
};

}  // namespace control
