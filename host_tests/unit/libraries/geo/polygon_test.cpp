// SPDX-License-Identifier: GPL-3.0-or-later
#include "geo/polygon.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <random>
#include <vector>

namespace {

using geo::Position;
using Polygon = std::vector<Position>;

constexpr int64_t kTurn_e7 = 3600000000;

bool inside(const Polygon& polygon, const Position& place) {
    bool odd = false;
    for (size_t i = 0; i < polygon.size(); ++i)
        odd ^= geo::crossesEdge(polygon[0], polygon[i], polygon[(i + 1) % polygon.size()], place);
    return odd;
}

Position wrapped(double latitude_e7, double longitude_e7) {
    int64_t east_e7 = std::llround(longitude_e7);
    while (east_e7 > kTurn_e7 / 2) east_e7 -= kTurn_e7;
    while (east_e7 < -kTurn_e7 / 2) east_e7 += kTurn_e7;
    return {static_cast<int32_t>(std::lround(latitude_e7)), static_cast<int32_t>(east_e7)};
}

// How often the polygon goes round the place, by angles in double: nothing in common with counting
// crossings. Longitudes are taken from `centre` on, about which the polygon lies. None for a place
// on an edge, from which the edge's ends are seen half a turn apart, to either side.
std::optional<int> windings(const Polygon& polygon, const Position& place, double centre_e7) {
    const auto east = [&](const Position& p) {
        return std::remainder(p.longitude_e7 - centre_e7, double(kTurn_e7));
    };
    double sum = 0;
    for (size_t i = 0; i < polygon.size(); ++i) {
        const Position &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double ax = east(a) - east(place), ay = double(a.latitude_e7) - place.latitude_e7;
        const double bx = east(b) - east(place), by = double(b.latitude_e7) - place.latitude_e7;
        const double sine = ax * by - bx * ay, cosine = ax * bx + ay * by;
        if (sine == 0 && cosine <= 0) return std::nullopt;
        sum += std::atan2(sine, cosine);
    }
    return static_cast<int>(std::lround(sum / (2 * M_PI)));
}

// A polygon about the centre whose corners lie at growing angles: as jagged as a fence may be.
Polygon star(std::mt19937& random, const Position& centre, double size_e7) {
    std::uniform_real_distribution<double> part(0.2, 1);
    const int corners = std::uniform_int_distribution<int>(3, 19)(random);
    Polygon polygon;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * M_PI * i / corners, away_e7 = part(random) * size_e7;
        polygon.push_back(wrapped(centre.latitude_e7 + away_e7 * std::sin(angle),
                                  centre.longitude_e7 + away_e7 * std::cos(angle)));
    }
    return polygon;
}

TEST(Polygon, agrees_with_the_angles_seen_from_the_place) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> offset(-1.2, 1.2);
    int in = 0, tried = 0;
    for (const Position centre : {Position{473977000, 85456000}, Position{-353632610, 1799999000},
                                  Position{100, -1799999999}, Position{-880000000, 0}})
        for (const double size_e7 : {200.0, 30000.0, 2000000.0, 15000000.0})
            for (int n = 0; n < 100; ++n) {
                const Polygon polygon = star(random, centre, size_e7);
                for (int m = 0; m < 20; ++m) {
                    const Position place = wrapped(centre.latitude_e7 + offset(random) * size_e7,
                                                   centre.longitude_e7 + offset(random) * size_e7);
                    const std::optional<int> expected =
                        windings(polygon, place, centre.longitude_e7);
                    if (!expected) continue;
                    ASSERT_EQ(inside(polygon, place), *expected % 2 != 0)
                        << place.latitude_e7 << ' ' << place.longitude_e7;
                    in += *expected != 0;
                    ++tried;
                }
            }
    EXPECT_GT(in, tried / 10);
    EXPECT_LT(in, tried / 2);
}

TEST(Polygon, knows_its_edge_to_the_last_digit) {
    // a slope of a whole number, so that every place on it is one
    const Polygon triangle = {{0, 0}, {1000000, 3000000}, {1000000, 0}};
    for (int32_t north = 1; north < 1000000; north += 9973) {
        EXPECT_TRUE(inside(triangle, {north, 3 * north - 1})) << north;
        EXPECT_FALSE(inside(triangle, {north, 3 * north + 1})) << north;
    }
}

TEST(Polygon, a_place_is_in_one_of_two_that_share_an_edge) {
    const Position a = {0, 0}, b = {700, 1300}, c = {900, -400}, d = {-300, 800};
    for (int32_t north = -400; north < 1000; north += 7)
        for (int32_t east = -500; east < 1400; east += 7) {
            const bool whole = inside({a, c, b, d}, {north, east});
            EXPECT_EQ(inside({a, b, c}, {north, east}) + inside({a, b, d}, {north, east}), whole)
                << north << ' ' << east;
        }
}

TEST(Polygon, lies_across_the_antimeridian) {
    const Polygon square = {
        {-1000, 1799990000}, {-1000, -1799990000}, {1000, -1799990000}, {1000, 1799990000}};
    EXPECT_TRUE(inside(square, {0, 1799995000}));
    EXPECT_TRUE(inside(square, {0, 1800000000}));
    EXPECT_TRUE(inside(square, {0, -1800000000}));
    EXPECT_TRUE(inside(square, {0, -1799995000}));
    EXPECT_FALSE(inside(square, {0, 1799989999}));
    EXPECT_FALSE(inside(square, {0, -1799989999}));
}

TEST(Polygon, does_not_contain_its_antipodes) {
    const Polygon square = {{-1000, -10000}, {-1000, 10000}, {1000, 10000}, {1000, -10000}};
    for (const int32_t east : {1799999999, 1800000000, -1800000000, -1799999999, 1799985000,
                               -1799985000, 900000000, -900000000})
        EXPECT_FALSE(inside(square, {0, east})) << east;
}

TEST(Polygon, of_half_the_earth_does_not_overflow) {
    const Polygon half = {{-900000000, -890000000},
                          {-900000000, 890000000},
                          {900000000, 890000000},
                          {900000000, -890000000}};
    EXPECT_TRUE(inside(half, {0, 0}));
    EXPECT_TRUE(inside(half, {899999999, 889999999}));
    EXPECT_FALSE(inside(half, {0, 1700000000}));
    EXPECT_FALSE(inside(half, {0, -1700000000}));
}

}  // namespace
