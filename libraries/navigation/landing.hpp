// SPDX-License-Identifier: GPL-3.0-or-later
// The last leg: a straight glide slope, bent in the flare into a parabola whose sink falls evenly
// to the one of the touchdown, which is at the landing point. Where the slope is less than 6 %, the
// airplane stays 6 m high until 6 % take it to the point. The parabola is longer than the
// stretch of slope it replaces, so the slope aims short of the point by the difference. The lower
// it is, the less it sinks for the point's sake: the height may be wrong.
#pragma once
#include <stdint.h>

#include "navigation/slope.hpp"

namespace navigation {

struct LandingSettings {
    float flare_height_m;      // LAND_FLARE_ALT: the flare begins no lower than this ...
    float flare_time_s;        // LAND_FLARE_SEC: ... nor later than this before the ground
    float touchdown_sink_mps;  // never sinks slower than this in the flare, or than on the slope
    float late_s;              // the parabola ends so much behind the point
};

struct Approach {
    float from_height_m;  // where the leg begins, above the landing point
    float length_m;
    float along_m;
    float along_mps;
    float height_m;           // now, above the landing point
    float sink_mps;           // now
    float above_field_m = 0;  // now; the field is where the airplane was armed
};

class Landing {
public:
    void start() { *this = Landing(); }
    HeightDemand run(LandingSettings settings, Approach approach);
    bool flaring() const { return flaring_; }
    // No ground was where the point should be, and the field lies lower: heights are to be given
    // above that from now on, until start(), and it flares again.
    bool byField() const { return by_field_; }

private:
    bool flaring_ = false;
    bool by_field_ = false;
};

}  // namespace navigation
