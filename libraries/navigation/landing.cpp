// SPDX-License-Identifier: GPL-3.0-or-later
#include "navigation/landing.hpp"

namespace navigation {
namespace {

constexpr float kSteepestFlare = 1.3f;  // of the sink it began with: no diving at the point
constexpr float kFlareLead_s = 0.3f;    // until the path answers the pitch
// As the sink is to grow less the path answers late all the way: so much earlier it meets the
// ground, on three airplanes in calm air.
constexpr float kShort_s = 0.4f;

float larger(float a, float b) { return a > b ? a : b; }

}  // namespace

HeightDemand Landing::run(const LandingSettings& settings, Approach approach) {
    const bool past = approach.along_m >= approach.length_m;
    approach.length_m += kShort_s * core::limit(approach.along_mps, 0.0f, 50.0f);
    if (flaring_) return flare(settings, approach);

    const float length_m = core::limit(approach.length_m, 1.0f, 1e6f);
    const float speed_mps = core::limit(approach.along_mps, 1.0f, 100.0f);
    // the slope as if there were no flare tells where that begins
    const float steepness = core::limit(approach.from_height_m / length_m, 0.02f, 0.5f);
    const float sink_mps = steepness * speed_mps;
    const float flare_m = larger(sink_mps * settings.flare_time_s, settings.flare_height_m);
    const float evenness = 2 * sink_mps / (sink_mps + settings.touchdown_sink_mps);
    const float aim_m = length_m - flare_m / steepness * larger(evenness - 1, 0);

    if (past || approach.height_m <= flare_m + approach.sink_mps * kFlareLead_s) {
        flaring_ = true;
        flare_sink_mps_ =
            core::limit(approach.sink_mps, settings.touchdown_sink_mps,
                        kSteepestFlare * larger(sink_mps, settings.touchdown_sink_mps));
        return flare(settings, approach);
    }
    if (aim_m < 1) return {0, -sink_mps};
    return heightOnSlope(approach.from_height_m, 0, aim_m, approach.along_m, approach.along_mps);
}

// The mean of the sink now and at the touchdown is what takes the height away by the point.
HeightDemand Landing::flare(const LandingSettings& settings, const Approach& approach) const {
    const float left_m = core::limit(approach.length_m - approach.along_m, 1.0f, 1e6f);
    const float height_m = core::limit(approach.height_m, 0.0f, 100.0f);
    const float last_mps = settings.touchdown_sink_mps;
    const float sink_mps = 2 * height_m * approach.along_mps / left_m - last_mps;
    const float steepest_mps = larger(kSteepestFlare * flare_sink_mps_, last_mps);
    return {approach.height_m, -core::limit(sink_mps, last_mps, steepest_mps)};
}

}  // namespace navigation
