// SPDX-License-Identifier: GPL-3.0-or-later
#include "control/swing.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

// How often it is noticed in ten seconds of a swing to and fro.
int noticed(double hz, double rate_rads, double surface, uint8_t most = 4) {
    control::Swing swing;
    int times = 0;
    for (int frame = 0; frame < 1000; ++frame) {
        const double phase = 2 * M_PI * hz * frame / 100;
        times += swing.watch(core::BodyRate(static_cast<float>(rate_rads * std::sin(phase))),
                             core::Ratio(static_cast<float>(-surface * std::cos(phase))),
                             {most, 90, 60});
    }
    return times;
}

TEST(Swing, is_noticed_each_time_it_has_gone_to_and_fro_so_often) {
    EXPECT_EQ(noticed(2, 5, 0.6), 10) << "of 40 swings";
    EXPECT_EQ(noticed(2, 5, 0.6, 6), 6);
}

TEST(Swing, whose_surface_hardly_moves_is_gusts) { EXPECT_EQ(noticed(2, 5, 0.15), 0); }
TEST(Swing, that_turns_the_airplane_little_is_noise) { EXPECT_EQ(noticed(2, 0.2, 0.9), 0); }
// A loop of a heavy airplane with slow servos; gusts that are as slow move its surface half as far.
TEST(Swing, of_a_second_and_a_half_is_noticed_where_the_surface_moves_over_half_of_its_travel) {
    EXPECT_GT(noticed(0.65, 1, 0.5), 0);
    EXPECT_EQ(noticed(0.65, 1, 0.3), 0);
}
TEST(Swing, that_takes_seconds_is_flying) { EXPECT_EQ(noticed(0.5, 1, 0.9), 0); }

}  // namespace
