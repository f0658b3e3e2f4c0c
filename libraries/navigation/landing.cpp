// SPDX-License-Identifier: GPL-3.0-or-later
#include "navigation/landing.hpp"

namespace navigation {
namespace {

constexpr float kSteepestFlare = 1.3f;  // of the sink it began with: no diving at the point

}  // namespace

HeightDemand Landing::run(const LandingSettings& settings, const Approach& approach) {
    if (flaring_) return flare(settings, approach);

    const float length_m = core::limit(approach.length_m, 1.0f, 1e6f);
    const float speed_mps = core::limit(approach.along_mps, 1.0f, 100.0f);
    // the slope as if there were no flare, to know how high the flare begins
    const float steepness = core::limit(approach.from_height_m / length_m, 0.02f, 0.5f);
    const float by_time_m = steepness * speed_mps * settings.flare_time_s;
    const float flare_m = by_time_m > settings.flare_height_m ? by_time_m : settings.flare_height_m;
    const float aim_m = length_m - flare_m / steepness;  // where the slope meets the ground

    if (approach.height_m <= flare_m || approach.along_m >= length_m) {
        flaring_ = true;
        flare_sink_mps_ = core::limit(approach.sink_mps, settings.touchdown_sink_mps,
                                      kSteepestFlare * steepness * speed_mps);
        return flare(settings, approach);
    }
    if (aim_m < 1) return {0, -steepness * speed_mps};
    return heightOnSlope(approach.from_height_m, 0, aim_m, approach.along_m, approach.along_mps);
}

// On the parabola the sink is twice the mean sink that is left to the point.
HeightDemand Landing::flare(const LandingSettings& settings, const Approach& approach) const {
    const float left_m = core::limit(approach.length_m - approach.along_m, 1.0f, 1e6f);
    const float height_m = core::limit(approach.height_m, 0.0f, 100.0f);
    float sink_mps = 2 * height_m * approach.along_mps / left_m;
    const float steepest_mps = kSteepestFlare * flare_sink_mps_;
    sink_mps = core::limit(
        sink_mps, settings.touchdown_sink_mps,
        steepest_mps > settings.touchdown_sink_mps ? steepest_mps : settings.touchdown_sink_mps);
    return {approach.height_m, -sink_mps};
}

}  // namespace navigation
