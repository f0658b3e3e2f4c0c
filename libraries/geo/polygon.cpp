// SPDX-License-Identifier: GPL-3.0-or-later
#include "geo/polygon.hpp"

namespace geo {

// Two products are compared and none is divided. They hold: a latitude spans 1.8e9, and where the
// edge's ends lie on either side of the place, neither is farther from it than the two are apart,
// less than 3.6e9.
bool crossesEdge(const Position& origin, const Position& from, const Position& to,
                 const Position& place) {
    const bool starts_above = from.latitude_e7 > place.latitude_e7;
    if (starts_above == (to.latitude_e7 > place.latitude_e7)) return false;
    const int32_t place_east_e7 = eastward_e7(origin.longitude_e7, place.longitude_e7);
    const int32_t from_east_e7 = eastward_e7(origin.longitude_e7, from.longitude_e7);
    const int32_t to_east_e7 = eastward_e7(origin.longitude_e7, to.longitude_e7);
    const bool starts_east = from_east_e7 > place_east_e7;
    if (starts_east == (to_east_e7 > place_east_e7)) return starts_east;
    const int64_t a =
        (int64_t{from_east_e7} - place_east_e7) * (int64_t{to.latitude_e7} - place.latitude_e7);
    const int64_t b =
        (int64_t{to_east_e7} - place_east_e7) * (int64_t{from.latitude_e7} - place.latitude_e7);
    return starts_above ? a < b : a > b;
}

}  // namespace geo
