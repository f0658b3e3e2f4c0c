// SPDX-License-Identifier: GPL-3.0-or-later
#include "navigation/landing.hpp"

#include <math.h>

namespace navigation {
namespace {

constexpr float kSteepestFlare = 2.5f;  // of what an evenly falling sink leaves at a height
// What is too high comes down faster than the slope, if that is shallow, but does not dive at the
// point. Of the slope's sink, m/s, and of a steep slope's.
constexpr float kSteepestSink = 2.0f, kSteepest_mps = 1.4f, kSteepestOfSteep = 1.1f;
// Below where the ground should be the height is wrong, and the airplane is to come down.
constexpr float kSinkBelow_hz = 0.4f;
constexpr float kMaxBelow_m = 0.7f;
// And behind the point, where it would float on while its speed is lost.
constexpr float kSinkBehind_hz = 0.02f;
constexpr float kMaxBehind_m = 20;
constexpr float kFlareLead_s = 1.0f;  // until the path answers the pitch
// Of the slope's. What a gust adds is the approach's to end: a flare would go on with it from
// there, without power, a hundred metres short of the point on a shallow slope.
constexpr float kMaxLeadSink = 1.5f;
// Of its height an airplane above the slope dives no more than this: what an updraft has given
// would be taken away with a sink that no flare ends in time.
constexpr float kDive = 0.15f;
// A flare that a gust has begun too far from the point sinks less, down to this share of the sink
// at touch-down, if that suffices to come down at the point. Not near the ground, which may be
// higher than it seems.
constexpr float kLeastSink = 0.4f, kLessSinkAbove_m = 0.4f;
// A flare this far below the point, so far above the field, is none: the airplane would stall.
constexpr float kNoGround_m = 3, kFieldIsLower_m = 10;
// Past the point the flare begins higher, but not where it would end in a stall.
constexpr float kHigherPast = 4;

// The last of a shallow slope is flown steeper, from this height on: along the slope a gust takes a
// hundred metres from the landing.
constexpr float kShallowest = 0.06f, kSteepens_m = 6.0f;

// The slope as if there were no flare.
struct Slope {
    float steepness, sink_mps;
    float flare_m;  // where the flare begins
};

Slope slopeOf(const LandingSettings& settings, const Approach& approach) {
    const float length_m = core::limit(approach.length_m, 1.0f, 1e6f);
    const float steepness = core::limit(approach.from_height_m / length_m, kShallowest, 0.5f);
    const float sink_mps = steepness * core::limit(approach.along_mps, 1.0f, 100.0f);
    return {steepness, sink_mps, fmaxf(sink_mps * settings.flare_time_s, settings.flare_height_m)};
}

// The mean of the sink now and at the touchdown is what takes the height away by the point.
HeightDemand flare(const LandingSettings& settings, const Approach& approach, const Slope& slope) {
    const float left_m = core::limit(approach.length_m - approach.along_m, 1.0f, 1e6f);
    const float height_m = core::limit(approach.height_m, 0.0f, 100.0f);
    const float below_m = core::limit(-approach.height_m, 0.0f, kMaxBelow_m);
    const float last_mps = settings.touchdown_sink_mps + kSinkBelow_hz * below_m;
    const float even_mps = height_m * approach.along_mps / left_m;
    const float sink_mps = 2 * even_mps - last_mps;
    if (sink_mps < last_mps && height_m > kLessSinkAbove_m)
        return {approach.height_m, -core::limit(even_mps, kLeastSink * last_mps, last_mps)};
    const float more_mps = fmaxf(slope.sink_mps - last_mps, 0);
    const float most_mps = last_mps + kSteepestFlare * more_mps * height_m / slope.flare_m;
    const float steeper_mps = core::limit(kSteepestSink * slope.sink_mps, last_mps, kSteepest_mps);
    const float steepest_mps = fmaxf(kSteepestOfSteep * slope.sink_mps, steeper_mps);
    return {approach.height_m,
            -core::limit<float>(fminf(sink_mps, most_mps), last_mps, steepest_mps)};
}

}  // namespace

HeightDemand Landing::run(LandingSettings settings, Approach approach) {
    const bool no_ground = approach.height_m < -kNoGround_m;
    if (flaring_ && no_ground && approach.above_field_m > kFieldIsLower_m) {
        by_field_ = true;
        flaring_ = false;
        return {approach.height_m, -settings.touchdown_sink_mps};
    }
    const float behind_m = approach.along_m - approach.length_m;
    const bool past = !core::isNegative(behind_m);
    settings.touchdown_sink_mps += kSinkBehind_hz * core::limit(behind_m, 0.0f, kMaxBehind_m);
    approach.length_m += settings.late_s * core::limit(approach.along_mps, 0.0f, 50.0f);
    const Slope slope = slopeOf(settings, approach);
    // on a slope that sinks less the flare would dive below it
    settings.touchdown_sink_mps = core::limit(settings.touchdown_sink_mps, 0.0f, slope.sink_mps);
    const float lead_mps = core::limit(approach.sink_mps, 0.0f, kMaxLeadSink * slope.sink_mps);
    const float begins_m = slope.flare_m * (past ? kHigherPast : 1) + lead_mps * kFlareLead_s;
    if (approach.height_m <= begins_m) flaring_ = true;
    if (flaring_) return flare(settings, approach, slope);

    const float evenness = 2 * slope.sink_mps / (slope.sink_mps + settings.touchdown_sink_mps);
    const float aim_m =
        approach.length_m - slope.flare_m / slope.steepness * fmaxf(evenness - 1, 0);
    if (aim_m < 1) return {0, -slope.sink_mps};
    HeightDemand demand =
        heightOnSlope(approach.from_height_m, 0, aim_m, approach.along_m, approach.along_mps);
    const float steep_m = slope.steepness * (aim_m - approach.along_m);
    const float late_m = core::limit(steep_m, 0.0f, kSteepens_m);
    if (late_m >= demand.height_m)
        demand = {late_m, steep_m < kSteepens_m ? -slope.sink_mps : 0.0f};
    demand.height_m = fmaxf(demand.height_m, approach.height_m * (1 - kDive));
    return demand;
}

}  // namespace navigation
