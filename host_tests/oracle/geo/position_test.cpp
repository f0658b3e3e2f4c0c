// SPDX-License-Identifier: GPL-3.0-or-later
#include "geo/position.hpp"

#include <gtest/gtest.h>

#include <GeographicLib/Geodesic.hpp>
#include <algorithm>
#include <cmath>
#include <random>

#include "core/maths.hpp"
#include "geodesics.hpp"

namespace {

using geo::Offset;
using geo::Position;

struct Geodesic {
    double distance_m, azimuth_deg;
};

Geodesic geodesic(const Position& from, const Position& to) {
    Geodesic g;
    double back;
    GeographicLib::Geodesic::WGS84().Inverse(from.latitude_e7 * 1e-7, from.longitude_e7 * 1e-7,
                                             to.latitude_e7 * 1e-7, to.longitude_e7 * 1e-7,
                                             g.distance_m, g.azimuth_deg, back);
    return g;
}

int32_t e7(double degrees) { return static_cast<int32_t>(std::lround(degrees * 1e7)); }

Position direct(const Position& from, double azimuth_deg, double distance_m) {
    double latitude, longitude;
    GeographicLib::Geodesic::WGS84().Direct(from.latitude_e7 * 1e-7, from.longitude_e7 * 1e-7,
                                            azimuth_deg, distance_m, latitude, longitude);
    return {e7(latitude), e7(longitude)};
}

double azimuthError_deg(double a, double b) { return std::abs(std::remainder(a - b, 360.0)); }

// Pairs of places all over the earth, half of them hard on the antimeridian.
template <class Check>
void forManyPairs(double nearest_m, double farthest_m, Check check) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> latitude(-84.9, 84.9), longitude(-180, 180),
        azimuth(-180, 180), log_distance(std::log(nearest_m), std::log(farthest_m));
    for (int i = 0; i < 20000; ++i) {
        double east =
            i % 2 == 0 ? longitude(random) : std::remainder(180.0 + longitude(random) / 1e4, 360.0);
        const Position from = {e7(latitude(random)), e7(east)};
        const Position to = direct(from, azimuth(random), std::exp(log_distance(random)));
        check(from, to);
        if (::testing::Test::HasFailure()) return;
    }
}

TEST(Position, distances_agree_with_the_geodesic_up_to_5_km) {
    forManyPairs(0.1, 5000, [](const Position& from, const Position& to) {
        const double truth_m = geodesic(from, to).distance_m;
        EXPECT_NEAR(geo::distance_m(from, to), truth_m, std::max(0.05, 0.0002 * truth_m))
            << from.latitude_e7 << " " << from.longitude_e7;
    });
}

TEST(Position, distances_agree_with_the_geodesic_up_to_10_km) {
    forManyPairs(5000, 10000, [](const Position& from, const Position& to) {
        const double truth_m = geodesic(from, to).distance_m;
        EXPECT_NEAR(geo::distance_m(from, to), truth_m, 0.002 * truth_m)
            << from.latitude_e7 << " " << from.longitude_e7;
    });
}

TEST(Position, a_step_that_a_float_of_degrees_does_not_see_is_seen) {
    const Position here = {473977000, 1794559880};
    const Position there = {here.latitude_e7, here.longitude_e7 + 60};

    EXPECT_EQ(static_cast<float>(here.longitude_e7 * 1e-7),
              static_cast<float>(there.longitude_e7 * 1e-7));
    EXPECT_NEAR(geo::distance_m(here, there), geodesic(here, there).distance_m, 0.001);
}

TEST(Position, bearings_agree_with_the_geodesic_beyond_20_m) {
    forManyPairs(20, 5000, [](const Position& from, const Position& to) {
        const double truth_deg = geodesic(from, to).azimuth_deg;
        EXPECT_LT(azimuthError_deg(geo::bearing_cd(from, to) / 100.0, truth_deg), 0.05)
            << from.latitude_e7 << " " << from.longitude_e7;
    });
}

TEST(Position, offsets_as_vectors_agree_with_the_geodesic) {
    forManyPairs(0.1, 5000, [](const Position& from, const Position& to) {
        const Geodesic truth = geodesic(from, to);
        const double azimuth_rad = truth.azimuth_deg * M_PI / 180;
        const Offset offset = geo::offset(from, to);
        const double error_m = std::hypot(offset.north_m - truth.distance_m * std::cos(azimuth_rad),
                                          offset.east_m - truth.distance_m * std::sin(azimuth_rad));
        EXPECT_LT(error_m, std::max(0.05, 0.0005 * truth.distance_m)) << from.latitude_e7;
    });
}

TEST(Position, moving_by_an_offset_arrives_where_the_offset_was_measured) {
    forManyPairs(0.1, 5000, [](const Position& from, const Position& to) {
        const Position arrived = geo::moved(from, geo::offset(from, to));
        EXPECT_LT(geodesic(arrived, to).distance_m,
                  std::max(0.05, 0.0002 * geodesic(from, to).distance_m))
            << from.latitude_e7;
    });
}

TEST(Position, the_geodesics_that_the_chip_is_measured_against_are_right) {
    for (const KnownGeodesic& known : kGeodesics) {
        const Geodesic truth = geodesic(known.from, known.to);
        EXPECT_NEAR(known.distance_m, truth.distance_m, 0.001);
        EXPECT_LT(azimuthError_deg(known.azimuth_deg, truth.azimuth_deg), 0.001);
    }
}

TEST(Track, cross_is_positive_to_the_right) {
    const Position start = {473977000, 85456000};
    const Position end = direct(start, 30, 1000);
    const Position place = direct(direct(start, 30, 400), 120, 25);

    const geo::Track track = geo::track(start, end, place);

    EXPECT_NEAR(track.along_m, 400, 0.1);
    EXPECT_NEAR(track.cross_m, 25, 0.05);
}

// A place so far along the geodesic of the leg and so far off it, at a right angle.
Position besideLeg(const Position& start, double azimuth_deg, double along_m, double cross_m) {
    double latitude, longitude, there_deg;
    GeographicLib::Geodesic::WGS84().Direct(start.latitude_e7 * 1e-7, start.longitude_e7 * 1e-7,
                                            azimuth_deg, along_m, latitude, longitude, there_deg);
    return direct({e7(latitude), e7(longitude)}, there_deg + 90, cross_m);
}

TEST(Track, along_and_across_agree_with_the_geodesic) {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> share(-0.2, 1.2), cross(-500, 500);
    forManyPairs(100, 5000, [&](const Position& start, const Position& end) {
        const Geodesic leg = geodesic(start, end);
        const double along_m = share(random) * leg.distance_m, cross_m = cross(random);
        const Position place = besideLeg(start, leg.azimuth_deg, along_m, cross_m);

        const geo::Track track = geo::track(start, end, place);

        const double max_m = std::max(0.05, 0.002 * std::hypot(along_m, cross_m));
        EXPECT_NEAR(track.along_m, along_m, max_m) << start.latitude_e7;
        EXPECT_NEAR(track.cross_m, cross_m, max_m) << start.latitude_e7;
    });
}

TEST(Track, of_a_leg_without_length_is_the_distance) {
    const Position start = {473977000, 85456000};

    const geo::Track track = geo::track(start, start, direct(start, 200, 50));

    EXPECT_EQ(track.along_m, 0);
    EXPECT_NEAR(track.cross_m, 50, 0.05);
}

TEST(Passed, turns_true_where_the_line_across_the_end_is_crossed) {
    const Position start = {-339000000, 1510000000};
    const Position end = direct(start, 250, 800);

    EXPECT_FALSE(geo::passed(start, end, direct(start, 250, 799)));
    EXPECT_FALSE(geo::passed(start, end, direct(direct(start, 250, 798), 340, 300)));
    EXPECT_TRUE(geo::passed(start, end, direct(start, 250, 801)));
    EXPECT_TRUE(geo::passed(start, end, direct(direct(start, 250, 802), 160, 300)));
}

TEST(Passed, agrees_with_the_geodesic_to_half_a_per_cent_of_what_is_off_the_leg) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> beyond(-50, 50), cross(-500, 500);
    forManyPairs(100, 5000, [&](const Position& start, const Position& end) {
        const Geodesic leg = geodesic(start, end);
        const double beyond_m = beyond(random), cross_m = cross(random);
        if (std::abs(beyond_m) < 0.1 + 0.005 * std::abs(cross_m)) return;
        const Position place =
            besideLeg(start, leg.azimuth_deg, leg.distance_m + beyond_m, cross_m);

        EXPECT_EQ(geo::passed(start, end, place), beyond_m > 0)
            << start.latitude_e7 << " " << beyond_m << " " << cross_m;
    });
}

TEST(Passed, is_true_of_a_leg_without_length) {
    const Position here = {473977000, 85456000};

    EXPECT_TRUE(geo::passed(here, here, direct(here, 10, 100)));
}

}  // namespace
