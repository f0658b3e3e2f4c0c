// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/airplane/wind.hpp"

#include <gtest/gtest.h>

#include "simulator/devices/errors.hpp"
#include "statistics.hpp"

using namespace simulator;

namespace {

constexpr double kStep_s = 0.0025, kSpeed_mps = 12.5, kSpan_m = 1.4;

struct Axes {
    Statistics forward, right, down, roll;
};

// Many independent gusts soon after the start, and again `later_s` on.
std::pair<Axes, Axes> ensemble(double height_m, double later_s, uint64_t size) {
    const double deviation = SensorErrors{}.gust_mps;
    Axes first, second;
    const auto add = [](Axes& axes, const Gust& gust) {
        axes.forward.add(gust.velocity_mps.x);
        axes.right.add(gust.velocity_mps.y);
        axes.down.add(gust.velocity_mps.z);
        axes.roll.add(gust.rates_rads.x);
    };
    for (uint64_t seed = 1; seed <= size; ++seed) {
        Dryden dryden(deviation, kSpan_m, seed);
        const auto run = [&](double time_s) -> const Gust& {
            const Gust* gust = nullptr;
            for (int i = 0; i < time_s / kStep_s; ++i)
                gust = &dryden.advance(kStep_s, kSpeed_mps, height_m);
            return *gust;
        };
        add(first, run(0.1));
        add(second, run(later_s));
    }
    return {first, second};
}

}  // namespace

TEST(MeanWind, blows_from_where_it_is_said_to_and_grows_with_height) {
    const Vec3 high = meanWind_mps(5, 90, 10);
    EXPECT_NEAR(high.x, 0, 1e-9);
    EXPECT_NEAR(high.y, -5, 1e-9);
    EXPECT_NEAR(length(meanWind_mps(5, 90, 100)), 5, 1e-9);
    EXPECT_NEAR(length(meanWind_mps(5, 0, 2)) / 5, std::log(2 / 0.03) / std::log(10 / 0.03), 1e-9);
    EXPECT_NEAR(length(meanWind_mps(5, 0, 0)), 0, 1e-9);
}

TEST(Dryden, is_still_when_gusts_are_off) {
    Dryden dryden(0, kSpan_m, 1);
    for (int i = 0; i < 100; ++i) dryden.advance(kStep_s, kSpeed_mps, 50);
    EXPECT_EQ(length(dryden.advance(kStep_s, kSpeed_mps, 50).velocity_mps), 0);
}

TEST(Dryden, has_the_strength_of_the_table_and_the_standards_proportions) {
    constexpr double kHeight_m = 100;
    const double ratio = 0.177 + 0.000823 * kHeight_m / 0.3048;
    const auto [axes, later] = ensemble(kHeight_m, kStep_s, 1500);
    const double gust = SensorErrors{}.gust_mps;
    EXPECT_NEAR(axes.forward.deviation(), gust, 0.05);
    EXPECT_NEAR(axes.right.deviation(), gust, 0.05);
    EXPECT_NEAR(axes.down.deviation(), gust * std::pow(ratio, 0.4), 0.04);
    EXPECT_NEAR(axes.forward.mean(), 0, 0.07);
    EXPECT_GT(axes.roll.deviation(), 0.05);
    EXPECT_LT(axes.roll.deviation(), 0.25);
}

TEST(Dryden, forgets_a_gust_over_the_standards_length) {
    constexpr double kHeight_m = 30;
    const double feet = kHeight_m / 0.3048;
    const double length_m = feet / std::pow(0.177 + 0.000823 * feet, 1.2) * 0.3048;
    const auto [before, after] = ensemble(kHeight_m, length_m / kSpeed_mps, 700);
    EXPECT_NEAR(correlation(before.forward, after.forward), std::exp(-1), 0.08);
    // Of the second-order form: exp(-x)(1 - x / 2) with x = 1.
    EXPECT_NEAR(correlation(before.right, after.right), std::exp(-1) / 2, 0.08);
}

TEST(Thermals, rise_and_sink_as_strongly_and_not_at_the_ground) {
    const Thermals thermals(2, 5);
    Statistics air;
    for (double north_m = 0; north_m < 6000; north_m += 20)
        for (double east_m = 0; east_m < 6000; east_m += 20)
            air.add(thermals.rise_mps(north_m, east_m, 100));
    EXPECT_NEAR(air.mean(), 0, 0.05);
    EXPECT_NEAR(air.deviation(), 1, 0.05);  // half of the strength, of two sines
    EXPECT_EQ(thermals.rise_mps(100, 200, 0), 0);
    EXPECT_EQ(Thermals(0, 5).rise_mps(100, 200, 100), 0);
}
