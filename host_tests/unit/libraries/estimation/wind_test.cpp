// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/wind.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "flight.hpp"

namespace {

using estimation::Pointing;
using estimation::Wind;

struct Air {
    double north = 4, east = -3, speed = 13;
    core::Vector3 ground(double yaw) const {
        return flight::single({north + speed * std::cos(yaw), east + speed * std::sin(yaw), 0});
    }
};
Pointing pointing(double yaw) {
    return {static_cast<float>(std::cos(yaw)), static_cast<float>(std::sin(yaw))};
}

TEST(Wind, is_ground_velocity_minus_air_velocity_within_half_a_minute) {
    Wind wind;
    const Air air;
    for (int i = 0; i < 150; ++i) wind.update(air.ground(1), pointing(1), 13, 0.2f);

    EXPECT_TRUE(wind.known());
    EXPECT_NEAR(wind.wind_mps().x, 4, 0.1);
    EXPECT_NEAR(wind.wind_mps().y, -3, 0.1);
}

TEST(Wind, is_estimated_in_turns_without_an_airspeed_sensor) {
    Wind wind;
    const Air air;
    for (int i = 0; i < 300; ++i) {
        const double yaw = i * 0.2 * 0.3;
        wind.update(air.ground(yaw), pointing(yaw), 0, 0.2f);
    }

    EXPECT_NEAR(wind.wind_mps().x, 4, 0.2);
    EXPECT_NEAR(wind.wind_mps().y, -3, 0.2);
    EXPECT_NEAR(wind.airspeed_mps(air.ground(2)), 13, 0.3);
}

// A sensor that shows a tenth too little: the wind takes that up along the nose, until it turns.
TEST(Wind, shows_after_a_turn_what_an_airspeed_lacks) {
    Wind wind;
    Air air;
    constexpr float kShown_mps = 13 * 0.9f;
    EXPECT_EQ(wind.airspeedMissing_mps(air.ground(1), pointing(1), kShown_mps), 0) << "not known";
    for (int i = 0; i < 500; ++i) wind.update(air.ground(1), pointing(1), kShown_mps, 0.2f);
    EXPECT_NEAR(wind.airspeedMissing_mps(air.ground(1), pointing(1), kShown_mps), 0, 0.05);
    const double turned = 1 + M_PI / 2;
    EXPECT_NEAR(wind.airspeedMissing_mps(air.ground(turned), pointing(turned), kShown_mps), 1.3,
                0.05);
    EXPECT_NEAR(wind.airspeedMissing_mps(air.ground(1 + M_PI), pointing(1 + M_PI), kShown_mps), 2.6,
                0.05);
}

// Until the next turn it flies by that; half of the wind would be half of the airspeed.
TEST(Wind, is_known_for_the_most_part_after_the_first_turn_without_an_airspeed_sensor) {
    Wind wind;
    Air air;
    for (const double yaw : {0.0, 1.5}) wind.update(air.ground(yaw), pointing(yaw), 0, 0.2f);
    EXPECT_TRUE(wind.known());
    EXPECT_NEAR(wind.wind_mps().x, 4 * 0.6, 0.1);
    EXPECT_NEAR(wind.wind_mps().y, -3 * 0.6, 0.1);

    wind.update(air.ground(0), pointing(0), 0, 0.2f);
    EXPECT_NEAR(wind.wind_mps().x, 4 * (0.6 + 0.4 * 0.3), 0.1);
}

TEST(Wind, is_unknown_in_straight_flight_without_an_airspeed_sensor) {
    Wind wind;
    const Air air;
    for (int i = 0; i < 300; ++i) wind.update(air.ground(1), pointing(1), 0, 0.2f);

    EXPECT_FALSE(wind.known());
    EXPECT_EQ(wind.wind_mps().x, 0);
}

TEST(Wind, gusts_do_not_move_it_much) {
    Wind wind;
    flight::Errors errors;
    errors.wind_north_mps = 3;
    errors.wind_east_mps = -4;
    flight::Flight flight(flight::wholeFlight(), errors, 5);
    double worst = 0;
    for (int sample = 1; flight.step(); ++sample) {
        const flight::Truth& t = flight.truth();
        if (sample % 40 != 0 || t.airspeed < 8) continue;
        const Pointing nose = {static_cast<float>(std::cos(t.yaw) * std::cos(t.pitch)),
                               static_cast<float>(std::sin(t.yaw) * std::cos(t.pitch))};
        wind.update(flight::single(flight.gps().velocity), nose,
                    static_cast<float>(flight.airspeed_mps()), 0.2f);
        if (t.time_s < 60) continue;
        worst = std::max<double>(worst, std::hypot(wind.wind_mps().x - 3, wind.wind_mps().y + 4));
    }

    EXPECT_LT(worst, 2.0);
}

}  // namespace
