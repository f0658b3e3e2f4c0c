// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/airplane/atmosphere.hpp"

#include <gtest/gtest.h>

#include "simulator/airplane/earth.hpp"

using namespace simulator;

TEST(Atmosphere, is_the_standards) {  // ISO 2533, table 1
    struct Row {
        double altitude_m, pressure_pa, temperature_k, density_kgm3;
    };
    for (Row row : {Row{0, 101325, 288.15, 1.225},
                    {500, 95461, 284.90, 1.16727},
                    {2000, 79501, 275.15, 1.00655},
                    {11000, 22632, 216.65, 0.36392}}) {
        const Atmosphere air = atmosphere(row.altitude_m);
        EXPECT_NEAR(air.pressure_pa, row.pressure_pa, 20);  // the table's height is geopotential
        EXPECT_NEAR(air.temperature_k, row.temperature_k, 0.01);
        EXPECT_NEAR(air.density_kgm3, row.density_kgm3, 0.0005);
    }
}

TEST(Earth, moves_as_far_as_it_says) {
    for (double latitude_deg : {-60.0, 0.0, 47.4})
        for (auto [north_m, east_m] : {std::pair{1000.0, 0.0}, {0.0, 1000.0}, {-3000.0, 4000.0}}) {
            const Place from{latitude_deg, 8.5};
            const Place to = moved(from, 0, north_m, east_m);
            const Vec3 way = ecefPosition_m(to.latitude_deg, to.longitude_deg, 0) -
                             ecefPosition_m(from.latitude_deg, from.longitude_deg, 0);
            EXPECT_NEAR(length(way), std::hypot(north_m, east_m), 0.05);
            EXPECT_EQ(to.latitude_deg > from.latitude_deg, north_m > 0);
            EXPECT_EQ(to.longitude_deg > from.longitude_deg, east_m > 0);
        }
}

TEST(Earth, goes_right_across_the_antimeridian) {
    EXPECT_NEAR(moved({0, 179.9999}, 0, 0, 100).longitude_deg, -179.9992, 1e-5);
}

TEST(Earth, turns_local_velocity_into_the_change_of_the_ecef_position) {
    const double speed = 10, dt = 1e-2;
    const Place from{47, 8}, to = moved(from, 0, 3 * dt * speed, -4 * dt * speed);
    const Vec3 way = ecefPosition_m(to.latitude_deg, to.longitude_deg, 0.5 * dt * speed) -
                     ecefPosition_m(47, 8, 0);
    const Vec3 velocity = ecefVelocity_mps(47, 8, 3 * speed, -4 * speed, -0.5 * speed);
    EXPECT_NEAR(length(way * (1 / dt) - velocity), 0, 1e-3);
}

TEST(Earth, has_a_magnetic_field_of_the_given_direction) {
    const Vec3 field = northEastDown_mg({2.5, 63, 480});
    EXPECT_NEAR(length(field), 480, 1e-9);
    EXPECT_NEAR(std::atan2(field.y, field.x) * 180 / M_PI, 2.5, 1e-9);
    EXPECT_NEAR(std::asin(field.z / 480) * 180 / M_PI, 63, 1e-9);
}
