// SPDX-License-Identifier: GPL-3.0-or-later
// A place on the earth in whole 1e-7 degrees (about 11 mm), and differences of places in metres.
// No float ever holds an absolute latitude or longitude.
#pragma once
#include <stdint.h>

namespace geo {

struct Position {
    int32_t latitude_e7;
    int32_t longitude_e7;
};
constexpr bool operator==(const Position& a, const Position& b) {
    return a.latitude_e7 == b.latitude_e7 && a.longitude_e7 == b.longitude_e7;
}
constexpr bool operator!=(const Position& a, const Position& b) { return !(a == b); }

struct Offset {  // on the local tangent plane
    float north_m;
    float east_m;
};

// From `from` to `to`, in true directions at `from`, on the ellipsoid; right across the
// antimeridian. Within 0.02 % or 5 cm up to 5 km, 85 S to 85 N; beyond 85 degrees only finite.
Offset offset(const Position& from, const Position& to);
Position moved(const Position& from, const Offset& by);

// The short way round, west negative.
int32_t eastward_e7(int32_t from_e7, int32_t to_e7);

float length_m(const Offset& offset);
float distance_m(const Position& from, const Position& to);

// Clockwise from true north, radians in -pi..pi; 0 for a zero offset.
float bearing_rad(const Offset& offset);
int32_t bearing_cd(const Position& from, const Position& to);  // 0..35999

struct Track {
    float along_m;  // of `place` along the leg, from its start
    float cross_m;  // positive to the right of the leg
};
// On a leg of zero length: along 0, cross the distance.
Track track(const Position& leg_start, const Position& leg_end, const Position& place);

// True when `place` lies beyond the line through leg_end across the leg. A leg of zero length
// counts as passed.
bool passed(const Position& leg_start, const Position& leg_end, const Position& place);

}  // namespace geo
