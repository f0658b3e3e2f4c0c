// SPDX-License-Identifier: GPL-3.0-or-later
#include "navigation/landing.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "control/speed_height.hpp"
#include "flight_model.hpp"
#include "navigation/slope.hpp"

namespace {

constexpr navigation::LandingSettings kLanding{1.5f, 1.5f, 0.4f, 0.4f};

TEST(Landing, the_slope_aims_short_of_the_point_by_what_the_flare_adds) {
    navigation::Landing landing;
    landing.start();
    // The flare begins at 1.63 m with 1.08 m/s and ends with 0.4: 1.46 times the 16.5 m of slope,
    // to 4.4 m, or 0.4 s, behind the point.
    const auto demand = landing.run(kLanding, {30, 300, 100, 11, 20, 1});

    EXPECT_NEAR(demand.height_m, 30 * (1 - 100 / 296.8), 0.01);
    EXPECT_NEAR(demand.climb_mps, -11 * 30 / 296.8, 0.01);
    EXPECT_FALSE(landing.flaring());
}

TEST(Landing, flares_at_the_height_or_the_time_whichever_comes_first) {
    navigation::Landing low, early;
    low.start();
    early.start();
    low.run(kLanding, {10, 500, 400, 10, 1.75f, 0.2f});
    EXPECT_FALSE(low.flaring());
    low.run(kLanding, {10, 500, 410, 10, 1.55f, 0.2f});
    EXPECT_TRUE(low.flaring());
    early.run(kLanding, {60, 300, 270, 12, 3.5f, 2.4f});
    EXPECT_TRUE(early.flaring()) << "1.5 s at 2.4 m/s";
}

TEST(Landing, does_not_flare_earlier_for_a_gust_that_pushes_it_down) {
    navigation::Landing landing;
    landing.start();
    landing.run(kLanding, {10, 500, 400, 10, 2.5f, 1.5f});
    EXPECT_FALSE(landing.flaring()) << "it would come down a hundred metres before the point";
    landing.run(kLanding, {10, 500, 400, 10, 1.7f, 1.5f});
    EXPECT_TRUE(landing.flaring());
}

TEST(Landing, never_dives_below_a_slope_that_sinks_less_than_a_touchdown) {
    navigation::Landing landing;
    landing.start();
    constexpr float kAlong_mps = 9, kSink_mps = kAlong_mps * 0.06f;
    for (float height_m : {1.6f, 1.2f, 0.6f, 0.1f}) {
        const float along_m = 350 - height_m / 0.06f;
        const auto demand = landing.run({1.5f, 1.5f, 0.65f, 0.0f},
                                        {21, 350, along_m, kAlong_mps, height_m, kSink_mps});
        EXPECT_GE(demand.climb_mps, -kSink_mps * 1.2f) << height_m;
        EXPECT_LT(demand.climb_mps, 0) << height_m;
    }
}

// Along 2 % a gust of a second and a half takes a hundred metres from the landing.
TEST(Landing, stays_six_metres_high_on_a_shallow_slope_until_a_steeper_one_takes_it_down) {
    navigation::Landing landing;
    landing.start();
    const auto at = [&](float left_m, float height_m = 6) {
        return landing.run({1.5f, 1.5f, 0.4f, 0.0f}, {20, 1000, 1000 - left_m, 12, height_m, 0.3f});
    };
    EXPECT_NEAR(at(500).height_m, 10, 0.5);
    EXPECT_NEAR(at(500).climb_mps, -0.24, 0.02);
    EXPECT_FLOAT_EQ(at(200).height_m, 6);
    EXPECT_FLOAT_EQ(at(200).climb_mps, 0);
    EXPECT_NEAR(at(80).climb_mps, -0.72, 0.01);
    EXPECT_LT(at(80, 4).height_m, at(85, 4).height_m);
    EXPECT_FALSE(landing.flaring());
}

TEST(Landing, past_the_point_flares_a_little_higher_but_not_where_it_would_stall) {
    navigation::Landing landing;
    landing.start();
    const auto demand = landing.run(kLanding, {30, 300, 301, 11, 45, 1});
    EXPECT_FALSE(landing.flaring()) << "45 m without power end in a stall";
    EXPECT_LT(demand.climb_mps, -1.0f) << "it comes down all the same";
    EXPECT_LT(demand.height_m, 45);

    landing.run(kLanding, {30, 300, 301, 11, 7, 1});
    EXPECT_TRUE(landing.flaring());
}

// It would float on, with less and less speed.
TEST(Landing, sinks_the_faster_the_farther_behind_the_point_it_is_still_in_the_air) {
    const auto sink_mps = [](float behind_m) {
        navigation::Landing landing;
        landing.start();
        landing.run(kLanding, {30, 300, 290, 11, 0.8f, 1});
        return -landing.run(kLanding, {30, 300, 300 + behind_m, 11, 0.01f, 0.2f}).climb_mps;
    };
    EXPECT_NEAR(sink_mps(0), kLanding.touchdown_sink_mps, 0.01);
    EXPECT_NEAR(sink_mps(10), kLanding.touchdown_sink_mps + 0.2, 0.01);
    EXPECT_NEAR(sink_mps(50), kLanding.touchdown_sink_mps + 0.4, 0.03);
}

TEST(Landing, flares_again_by_the_height_above_the_field_where_no_ground_was) {
    navigation::Landing landing;
    landing.start();
    landing.run(kLanding, {30, 300, 290, 11, 1, 1, 50});
    ASSERT_TRUE(landing.flaring());
    landing.run(kLanding, {30, 300, 300, 11, -2.5f, 1, 46.5f});
    EXPECT_TRUE(landing.flaring()) << "the barometer may be wrong by so much";

    landing.run(kLanding, {30, 300, 310, 11, -3.5f, 1, 45.5f});
    EXPECT_FALSE(landing.flaring());
    EXPECT_TRUE(landing.byField());
    const auto demand = landing.run(kLanding, {30, 300, 320, 11, 45, 1, 45});
    EXPECT_FALSE(landing.flaring());
    EXPECT_LT(demand.climb_mps, -1);
    landing.run(kLanding, {30, 300, 500, 11, 1, 1, 1});
    EXPECT_TRUE(landing.flaring());

    landing.start();
    EXPECT_FALSE(landing.byField()) << "the next landing is at its point";
}

TEST(Landing, flares_on_below_the_field_and_below_a_point_that_is_as_high_as_the_field) {
    for (const float above_field_m : {-20.0f, 5.0f}) {
        navigation::Landing landing;
        landing.start();
        landing.run(kLanding, {30, 300, 290, 11, 1, 1, above_field_m + 8});
        landing.run(kLanding, {30, 300, 310, 11, -7, 1, above_field_m});
        EXPECT_TRUE(landing.flaring()) << above_field_m;
    }
}

navigation::Landing flaring() {
    navigation::Landing landing;
    landing.start();
    landing.run(kLanding, {30, 300, 270, 11, 1.6f, 1.0f});
    EXPECT_TRUE(landing.flaring());
    return landing;
}

TEST(Landing, the_lower_it_is_the_less_it_sinks_though_the_point_is_near) {
    auto landing = flaring();
    float before_mps = 1.4f;
    for (float height_m : {1.5f, 1.0f, 0.6f, 0.3f}) {
        const float sink_mps = -landing.run(kLanding, {30, 300, 303, 10, height_m, 1}).climb_mps;
        EXPECT_LE(sink_mps, before_mps) << height_m;
        EXPECT_GT(sink_mps, 0.45f) << height_m;
        before_mps = sink_mps;
    }
    EXPECT_LT(before_mps, 0.8f);
    EXPECT_FLOAT_EQ(landing.run(kLanding, {30, 300, 280, 10, 0.01f, 1}).climb_mps, -0.4f);
}

// A gust that sinks it begins the flare too early.
TEST(Landing, far_from_the_point_it_sinks_no_more_than_brings_it_there) {
    const auto sink_mps = [](float left_m, float height_m) {
        auto landing = flaring();
        return -landing.run(kLanding, {30, 300, 300 - left_m, 10, height_m, 0.4f}).climb_mps;
    };
    EXPECT_GT(sink_mps(20, 1.4f), 0.4f);
    EXPECT_NEAR(sink_mps(60, 1.8f), 0.3f, 0.03f);
    EXPECT_FLOAT_EQ(sink_mps(150, 1.8f), 0.16f) << "it does not fly on for ever";
    EXPECT_FLOAT_EQ(sink_mps(60, 0.3f), 0.4f) << "the ground may be here";
}

TEST(Landing, does_not_dive_at_the_point_however_high_it_is) {
    const struct {
        float from_m, sink_mps;
    } kSlopes[] = {{15, 1.2f}, {30, 1.4f}, {60, 2.2f}};  // over 300 m, at 10 m/s
    for (const auto& slope : kSlopes) {
        auto landing = flaring();
        EXPECT_NEAR(landing.run(kLanding, {slope.from_m, 300, 303, 10, 9, 1}).climb_mps,
                    -slope.sink_mps, 0.06f)
            << slope.from_m;
    }
}

TEST(Landing, where_the_ground_should_have_been_it_comes_down_a_little_faster) {
    auto landing = flaring();
    const auto sink_mps = [&](float height_m) {
        return -landing.run(kLanding, {30, 300, 290, 10, height_m, 0.4f}).climb_mps;
    };
    EXPECT_FLOAT_EQ(sink_mps(0), 0.4f);
    EXPECT_FLOAT_EQ(sink_mps(-0.5f), 0.6f);
    EXPECT_FLOAT_EQ(sink_mps(-20), 0.68f) << "no more than that";
}

TEST(Landing, above_the_slope_it_does_not_dive_back_to_it) {
    navigation::Landing landing;
    landing.start();
    const float on_slope_m = landing.run(kLanding, {30, 300, 250, 11, 4.5f, 1}).height_m;
    ASSERT_NEAR(on_slope_m, 4.7f, 0.1f);
    EXPECT_FLOAT_EQ(landing.run(kLanding, {30, 300, 250, 11, 8, 1}).height_m, 6.8f);
    EXPECT_FLOAT_EQ(landing.run(kLanding, {30, 300, 250, 11, 3, 1}).height_m, on_slope_m);
}

TEST(Landing, touches_down_softly_near_the_point) {
    for (double headwind : {0.0, 4.0}) {
        flight_model::Airplane plane({-headwind, 0, 0, 1});
        plane.height = 30;
        plane.velocity_n = 12 - headwind;
        control::SpeedHeightSettings settings{3.5f, 1.2f, 2.5f, 2,    2,    0.7f, 0.3f,
                                              7,    2,    10,   0.5f, 0.5f, 0.4f};
        const control::SpeedHeightLimits limits{-0.3f, 0.3f, 0, 0.75f, 0.4f, 1, 9, 22};
        control::SpeedHeight core;
        navigation::Landing landing;
        landing.start();
        const auto measured = [&] {
            return control::SpeedHeightMeasured{static_cast<float>(plane.height),
                                                static_cast<float>(plane.climb),
                                                static_cast<float>(plane.airspeed),
                                                static_cast<float>(plane.forward_mss),
                                                1,
                                                true};
        };
        core.start(measured(), 0.03f, 0.3f);
        for (int i = 0; i < 2000 && plane.height > 0; ++i) {
            const auto height = landing.run(
                kLanding,
                {30, 350, static_cast<float>(plane.north), static_cast<float>(plane.velocity_n),
                 static_cast<float>(plane.height), static_cast<float>(-plane.climb)});
            auto bounds = limits;
            if (landing.flaring()) bounds.pitch_min_rad = bounds.throttle_max = 0;
            const auto out =
                core.run(settings, bounds, {height.height_m, height.climb_mps, 10.5f}, measured(),
                         landing.flaring() ? control::Phase::flare : control::Phase::cruise, 0.05f);
            plane.pitch_demand = out.pitch_rad;
            plane.throttle = out.throttle;
            for (int k = 0; k < 10; ++k) plane.step(0.005);
        }

        EXPECT_NEAR(plane.north, 350, 5) << headwind;
        EXPECT_LT(-plane.climb, 0.9) << headwind;
        EXPECT_GT(plane.airspeed, 7.5) << headwind;
    }
}

}  // namespace
