// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/height.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "flight.hpp"

namespace {

using estimation::Height;
using estimation::HeightSettings;

// 100 Hz of accelerations and, out of step with them, 80 Hz of barometer.
struct Bench {
    Height height;
    double bias_mss = 0, time_s = 0;
    bool barometer = true;
    double glitch_m = 0;
    template <class Path>
    void fly(double for_s, Path path) {
        for (double end_s = time_s + for_s; time_s < end_s;) {
            time_s += 0.01;
            const double up = (path(time_s) - 2 * path(time_s - 0.01) + path(time_s - 0.02)) / 1e-4;
            height.propagate(static_cast<float>(up + bias_mss), 0.01f);
            const int frame = static_cast<int>(std::lround(time_s * 100));
            if (barometer && frame % 5 != 0) {
                height.useBarometer(static_cast<float>(path(time_s) + glitch_m), 0.0125f,
                                    HeightSettings());
            }
        }
    }
};

TEST(Height, an_accelerometers_bias_leaves_no_trace) {
    Bench bench;
    bench.height.start(0);
    bench.bias_mss = 0.3;
    bench.fly(20, [](double) { return 0.0; });

    EXPECT_NEAR(bench.height.height_m(), 0, 0.02);
    EXPECT_NEAR(bench.height.climb_mps(), 0, 0.02);
}

TEST(Height, follows_a_climb_without_lag) {
    Bench bench;
    bench.height.start(0);
    auto path = [](double t) { return t < 5 ? 0 : 20 * (1 - std::cos((t - 5) * 0.3)); };
    bench.fly(30, path);

    EXPECT_NEAR(bench.height.height_m(), path(bench.time_s), 0.2);
    EXPECT_NEAR(bench.height.climb_mps(), 6 * std::sin((bench.time_s - 5) * 0.3), 0.2);
}

TEST(Height, a_single_outlier_is_ignored) {
    Height height;
    height.start(100);
    for (int i = 0; i < 200; ++i) {
        height.propagate(0, 0.01f);
        height.useBarometer(i == 150 ? 180.0f : 100.0f, 0.0125f, HeightSettings());
        EXPECT_EQ(height.lastReadingFarOff(), i == 150);
    }

    EXPECT_NEAR(height.height_m(), 100, 0.01);
}

TEST(Height, a_step_that_lasts_two_seconds_is_followed) {
    Bench bench;
    bench.height.start(0);
    bench.glitch_m = 40;
    bench.fly(1.9, [](double) { return 0.0; });
    EXPECT_NEAR(bench.height.height_m(), 0, 0.01);
    EXPECT_TRUE(bench.height.lastReadingFarOff());

    bench.fly(0.6, [](double) { return 0.0; });
    EXPECT_NEAR(bench.height.height_m(), 40, 0.01);
}

TEST(Height, without_a_barometer_it_turns_unhealthy_and_does_not_run_away) {
    Bench bench;
    bench.height.start(50);
    bench.fly(5, [](double) { return 50.0; });
    bench.barometer = false;
    bench.bias_mss = 0.3;
    bench.fly(60, [](double) { return 50.0; });

    EXPECT_FALSE(bench.height.healthy());
    EXPECT_NEAR(bench.height.height_m(), 50, 2);
    EXPECT_NEAR(bench.height.climb_mps(), 0, 0.1);
    bench.barometer = true;
    bench.fly(1, [](double) { return 50.0; });
    EXPECT_TRUE(bench.height.healthy());
}

TEST(Height, holds_a_tenth_of_a_metre_and_of_a_metre_a_second_in_a_whole_flight) {
    double height_square = 0, climb_square = 0;
    int n = 0;
    flight::Errors errors;
    errors.baro_drift_pa = 0;  // no filter can know it
    flight::Flight flight(flight::wholeFlight(), errors, 3);
    Height height;
    height.start(0);
    for (int sample = 1;; ++sample) {
        const flight::V3 before = flight.truth().velocity;
        if (!flight.step()) break;
        const double up = -(flight.truth().velocity.z - before.z) / flight::kDt_s;
        height.propagate(static_cast<float>(up + 0.05), 0.005f);
        if (sample % 5 == 0) {
            height.useBarometer(static_cast<float>(flight.baroHeight_m()), 0.025f,
                                HeightSettings());
        }
        if (sample < 4000) continue;
        height_square += std::pow(height.height_m() + flight.truth().position.z, 2);
        climb_square += std::pow(height.climb_mps() + flight.truth().velocity.z, 2);
        ++n;
    }

    EXPECT_LT(std::sqrt(height_square / n), 0.1);
    EXPECT_LT(std::sqrt(climb_square / n), 0.1);
}

}  // namespace
