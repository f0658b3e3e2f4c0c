// SPDX-License-Identifier: GPL-3.0-or-later
#include "geo/declination.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "simulator/world.hpp"
#include "toolchain/declination/table.hpp"

namespace {

using declination::Model;

const Model& model() {
    static const Model wmm = [] {
        std::ifstream file(WMM_COEFFICIENTS);
        return Model(file);
    }();
    return wmm;
}

geo::Position place(double latitude_deg, double longitude_deg) {
    return {static_cast<int32_t>(std::lround(latitude_deg * 1e7)),
            static_cast<int32_t>(std::lround(longitude_deg * 1e7))};
}

// How far from the table's declination the model's is, as an angle.
double error_deg(double latitude_deg, double longitude_deg) {
    const double is_deg = geo::declination_cd(place(latitude_deg, longitude_deg)) * 0.01;
    const double true_deg =
        model().at(latitude_deg, longitude_deg, 0, declination::kTableYear).declination_deg();
    return std::abs(std::remainder(is_deg - true_deg, 360));
}

// The southern magnetic pole of 2025, by the model's authors: 63.85 S, 135.08 E.
double fromPole_deg(double latitude_deg, double longitude_deg) {
    constexpr double kRadians = 3.14159265358979 / 180;
    const double a = -63.85 * kRadians, b = latitude_deg * kRadians;
    const double cosine = std::sin(a) * std::sin(b) +
                          std::cos(a) * std::cos(b) * std::cos((longitude_deg - 135.08) * kRadians);
    return std::acos(std::clamp(cosine, -1.0, 1.0)) / kRadians;
}

template <class Visit>
void everywhere(Visit visit, double from_equator_deg = 60) {
    for (double latitude = -from_equator_deg; latitude <= from_equator_deg; latitude += 0.5)
        for (double longitude = -180; longitude <= 180; longitude += 0.75)
            visit(latitude, longitude);
}

double worstWithin70_deg(bool (*counts)(double latitude_deg, double longitude_deg)) {
    double worst_deg = 0;
    const auto visit = [&](double latitude, double longitude) {
        if (counts(latitude, longitude))
            worst_deg = std::max(worst_deg, error_deg(latitude, longitude));
    };
    everywhere(visit, 70);
    return worst_deg;
}

// WMM2025_TestValues.txt, published with the model by NOAA NCEI: every third of its rows.
TEST(MagneticModel, gives_the_test_values_published_with_it) {
    struct Row {
        double year, height_km, latitude_deg, longitude_deg, declination_deg;
    };
    constexpr Row kRows[] = {
        {2025.0, 28, 89, -121, -99.77}, {2025.0, 65, 43, 93, 0.50},
        {2025.0, 3, -50, -103, 27.96},  {2025.0, 18, 0, 21, 1.29},
        {2025.5, 69, 38, -144, 12.93},  {2025.5, 8, -66, 17, -33.14},
        {2025.5, 44, 33, -118, 11.10},  {2026.0, 46, -24, -122, 14.01},
        {2026.0, 47, -72, -22, -6.32},  {2026.0, 82, -64, 87, -81.74},
        {2026.5, 12, -82, -68, 29.79},  {2026.5, 64, 10, 78, -1.53},
        {2026.5, 14, -33, -114, 18.12},
    };
    for (const Row& row : kRows)
        EXPECT_NEAR(model()
                        .at(row.latitude_deg, row.longitude_deg, row.height_km, row.year)
                        .declination_deg(),
                    row.declination_deg, 0.006)
            << row.latitude_deg << ' ' << row.longitude_deg;
}

TEST(MagneticModel, refuses_a_file_that_is_no_model) {
    for (const char* text :
         {"", "2025.0 WMM\n", "2025.0 WMM\n 1 0 1 2 3 4\n", "2025.0\n13 0 1 2 3 4"}) {
        std::istringstream file(text);
        EXPECT_THROW(Model{file}, std::runtime_error) << text;
    }
}

TEST(DeclinationTable, is_what_its_generator_writes) {
    std::ifstream file(DECLINATION_TABLE);
    std::ostringstream text;
    text << file.rdbuf();
    EXPECT_EQ(text.str(), declination::tableHeader(model()));
}

TEST(DeclinationTable, is_within_a_degree_away_from_the_magnetic_pole) {
    double worst_deg = 0;
    everywhere([&](double latitude, double longitude) {
        if (fromPole_deg(latitude, longitude) < 30) return;
        worst_deg = std::max(worst_deg, error_deg(latitude, longitude));
    });
    EXPECT_LT(worst_deg, 1.0);
    EXPECT_GT(worst_deg, 0.2);
}

// Where the horizontal field is strong enough for a compass: 6000 nT, the edge of what the model's
// authors call the caution zone.
TEST(DeclinationTable, is_accurate_wherever_a_compass_is_usable) {
    double worst_deg = 0;
    everywhere([&](double latitude, double longitude) {
        const auto field = model().at(latitude, longitude, 0, declination::kTableYear);
        if (field.horizontal_nt() < 6000) return;
        worst_deg = std::max(worst_deg, error_deg(latitude, longitude));
    });
    EXPECT_LT(worst_deg, 10.0);
}

TEST(DeclinationTable, goes_to_70_degrees_as_exactly_but_near_the_poles) {
    const auto far_from_pole = [](double latitude, double longitude) {
        return fromPole_deg(latitude, longitude) >= 30;
    };
    EXPECT_LT(worstWithin70_deg(far_from_pole), 1.2);
    // As weak as the level field may be where drawn airplanes fly.
    const auto compass_is_good = [](double latitude, double longitude) {
        return model().at(latitude, longitude, 0, declination::kTableYear).horizontal_nt() >= 8000;
    };
    EXPECT_LT(worstWithin70_deg(compass_is_good), 5);
}

TEST(DeclinationTable, has_no_seam_and_no_step) {
    everywhere(
        [&](double latitude, double longitude) {
            if (fromPole_deg(latitude, longitude) < 30) return;
            const int here_cd = geo::declination_cd(place(latitude, longitude));
            const double east = longitude + 0.01 > 180 ? longitude - 359.99 : longitude + 0.01;
            ASSERT_NEAR(geo::declination_cd(place(latitude, east)), here_cd, 15);
            const double north = std::min(latitude + 0.01, 69.99);
            ASSERT_NEAR(geo::declination_cd(place(north, longitude)), here_cd, 15);
        },
        70);
}

TEST(DeclinationTable, goes_on_with_its_last_row_beyond_70_degrees) {
    for (const double longitude : {-180.0, -71.3, 0.0, 12.5, 180.0}) {
        EXPECT_NEAR(geo::declination_cd(place(90, longitude)),
                    geo::declination_cd(place(69.999, longitude)), 2);
        EXPECT_EQ(geo::declination_cd(place(-90, longitude)),
                  geo::declination_cd(place(-70, longitude)));
    }
}

TEST(MagneticModel, is_what_the_simulator_flies_in) {
    constexpr double kYear = 2027.0, kRadians = 3.14159265358979 / 180;
    const simulator::WorldOptions world;
    const auto field =
        model().at(world.latitude_deg, world.longitude_deg, world.altitude_m / 1000, kYear);
    const double level_mg = field.horizontal_nt() / 100, down_mg = field.down_nt / 100;

    EXPECT_NEAR(world.declination_deg, field.declination_deg(), 0.05);
    EXPECT_NEAR(world.inclination_deg, std::atan2(down_mg, level_mg) / kRadians, 0.05);
    EXPECT_NEAR(world.magnetic_field_mg, std::hypot(level_mg, down_mg), 1);
}

TEST(DeclinationTable, gives_the_declination_of_known_towns) {
    struct Row {
        const char* town;
        double latitude_deg, longitude_deg, declination_deg;
    };
    // by the model itself, mid-2027
    constexpr Row kRows[] = {{"Zurich", 47.4, 8.5, 3.8},        {"Boulder", 40.0, -105.3, 7.6},
                             {"Canberra", -35.3, 149.1, 12.6},  {"Cape Town", -33.9, 18.4, -26.0},
                             {"Reykjavik", 60.0, -21.9, -10.0}, {"Suva", -18.1, 178.4, 12.6}};
    for (const Row& row : kRows)
        EXPECT_NEAR(geo::declination_cd(place(row.latitude_deg, row.longitude_deg)) * 0.01,
                    row.declination_deg, 1.0)
            << row.town;
}

TEST(FieldPointsDown, is_true_wherever_it_says_so_and_says_so_far_from_the_dip_equator) {
    constexpr double kRadians = 3.14159265358979 / 180;
    int known = 0, all = 0;
    everywhere([&](double latitude_deg, double longitude_deg) {
        const auto field = model().at(latitude_deg, longitude_deg, 0, declination::kTableYear);
        const double dip_deg = std::atan2(field.down_nt, field.horizontal_nt()) / kRadians;
        const int down = geo::fieldPointsDown(place(latitude_deg, longitude_deg));
        ++all;
        known += down != 0;
        if (down != 0) {
            EXPECT_GT(dip_deg * down, 25) << latitude_deg << " " << longitude_deg;
        } else {
            EXPECT_LT(std::abs(dip_deg), 50) << latitude_deg << " " << longitude_deg;
        }
    });
    EXPECT_GT(known, all / 2);
    EXPECT_EQ(geo::fieldPointsDown(place(89, 8)), 1);
    EXPECT_EQ(geo::fieldPointsDown(place(-89, 179)), -1);
}

}  // namespace
