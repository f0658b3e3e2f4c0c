// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/sensors/dead_gyros.hpp"

#include <gtest/gtest.h>

namespace {

class Gyros : public testing::Test {
protected:
    // Frames in which all but `dead` scatter by a step to and fro.
    uint8_t frames(int count, uint8_t dead) {
        uint8_t found = 0;
        for (int i = 0; i < count; ++i, ++frame_) {
            for (int axis = 0; axis < 3; ++axis)
                if ((dead & (1 << axis)) == 0) rates_[axis] = 70 * axis - 300 + frame_ % 2;
            found = gyros_.look(rates_);
        }
        return found;
    }
    firmware::sensors::DeadGyros gyros_;
    int32_t rates_[3] = {};
    int frame_ = 0;
};

TEST_F(Gyros, working_gyros_are_never_reported_dead) {
    for (int i = 0; i < 100; ++i) EXPECT_EQ(frames(7, 0), 0);
}

TEST_F(Gyros, a_constant_reading_is_dead_after_a_fifth_of_a_second_and_alive_at_the_next_change) {
    for (uint8_t dead : {firmware::sensors::kRollGyro, firmware::sensors::kPitchGyro,
                         firmware::sensors::kYawGyro}) {
        frames(5, 0);
        EXPECT_EQ(frames(19, dead), 0);
        EXPECT_EQ(frames(2, dead), dead);
        EXPECT_EQ(frames(300, dead), dead) << "for as long as it lasts";
        EXPECT_EQ(frames(2, 0), 0);
    }
}

TEST_F(Gyros, all_three_may_fail_together) {
    frames(5, 0);
    EXPECT_EQ(frames(30, 7), 7);
}

}  // namespace
