// SPDX-License-Identifier: GPL-3.0-or-later
// Known geodesics, and where the earth's coordinates have their edges. Also runs on the chip.
#include <gtest/gtest.h>

#include <cmath>

#include "geo/position.hpp"
#include "geodesics.hpp"

namespace {

using geo::Offset;
using geo::Position;

TEST(Position, distances_and_bearings_are_those_of_known_geodesics) {
    for (const KnownGeodesic& known : kGeodesics) {
        const float allowed_m = known.distance_m < 250 ? 0.05f : 0.0002f * known.distance_m;
        EXPECT_NEAR(geo::distance_m(known.from, known.to), known.distance_m, allowed_m)
            << known.from.latitude_e7;
        if (known.distance_m < 20) continue;
        const float bearing_deg = geo::bearing_cd(known.from, known.to) / 100.0f;
        EXPECT_LT(std::abs(std::remainder(bearing_deg - known.azimuth_deg, 360.0f)), 0.05f)
            << known.from.latitude_e7;
    }
}

TEST(Position, offsets_are_those_of_known_geodesics_and_lead_back) {
    for (const KnownGeodesic& known : kGeodesics) {
        const float azimuth_rad = known.azimuth_deg * 3.14159265f / 180;
        const float allowed_m = known.distance_m < 100 ? 0.05f : 0.0005f * known.distance_m;
        const Offset offset = geo::offset(known.from, known.to);
        EXPECT_NEAR(offset.north_m, known.distance_m * std::cos(azimuth_rad), allowed_m);
        EXPECT_NEAR(offset.east_m, known.distance_m * std::sin(azimuth_rad), allowed_m);

        const Position arrived = geo::moved(known.from, offset);
        EXPECT_LT(geo::distance_m(arrived, known.to), allowed_m) << known.from.latitude_e7;
    }
}

TEST(Position, zero_distance_is_zero_and_has_bearing_zero) {
    const Position here = {473977000, 85456000};

    EXPECT_EQ(geo::distance_m(here, here), 0.0f);
    EXPECT_EQ(geo::bearing_cd(here, here), 0);
    EXPECT_EQ(geo::moved(here, {0, 0}), here);
}

TEST(Position, the_smallest_step_is_seen) {
    const Position here = {-473977000, 1799999999};

    EXPECT_NEAR(geo::distance_m(here, {here.latitude_e7 + 1, here.longitude_e7}), 0.0111f, 0.0001f);
    EXPECT_NEAR(geo::offset(here, {here.latitude_e7, -1799999999}).east_m, 0.0151f, 0.0003f);
    EXPECT_NEAR(geo::offset({0, 1800000000}, {0, -1800000000}).east_m, 0, 1e-6);
}

TEST(Position, moving_across_the_antimeridian_wraps_both_ways) {
    EXPECT_EQ(geo::moved({0, 1799999000}, {0, 22.26f}).longitude_e7, -1799999000);
    EXPECT_EQ(geo::moved({0, -1799999000}, {0, -22.26f}).longitude_e7, 1799999000);
}

TEST(Position, near_the_poles_everything_stays_finite) {
    for (int32_t latitude : {-900000000, -899999999, 870000000, 899999999, 900000000}) {
        const Position here = {latitude, 100000000}, there = {latitude / 90 * 89, -1700000000};
        EXPECT_TRUE(std::isfinite(geo::distance_m(here, there)));
        EXPECT_TRUE(std::isfinite(geo::track(here, there, there).cross_m));
        const Position moved = geo::moved(here, {3000, 3000});
        EXPECT_LE(std::abs(long{moved.latitude_e7}), 900000000);
        EXPECT_LE(std::abs(long{moved.longitude_e7}), 1800000000);
    }
}

TEST(Position, the_answer_does_not_depend_on_where_the_last_one_was_asked) {
    const Position from = {473977000, 85456000}, to = {474077000, 85756000};
    (void)geo::distance_m({472100000, 0}, {472200000, 0});  // leaves a neighbouring band behind
    const float after_neighbour = geo::distance_m(from, to);
    (void)geo::distance_m({-700000000, 0}, {-700100000, 0});

    EXPECT_NEAR(geo::distance_m(from, to), after_neighbour, 0.02f);
}

TEST(Track, cross_is_positive_to_the_right_and_along_grows_to_the_end) {
    const Position start = {473977000, 85456000};
    const Position end = geo::moved(start, {500, 866});
    const Position place = geo::moved(start, {200 - 20, 346.4f + 11.5f});

    const geo::Track track = geo::track(start, end, place);

    EXPECT_NEAR(track.along_m, 399.95f, 0.5f);
    EXPECT_NEAR(track.cross_m, 23.07f, 0.5f);
    EXPECT_FALSE(geo::passed(start, end, place));
    EXPECT_TRUE(geo::passed(start, end, geo::moved(end, {1, 1.732f})));
}

}  // namespace
