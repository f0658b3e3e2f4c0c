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

TEST_F(Gyros, a_constant_reading_is_dead_when_the_others_have_changed_sixty_times) {
    for (uint8_t dead : {firmware::sensors::kRollGyro, firmware::sensors::kPitchGyro,
                         firmware::sensors::kYawGyro}) {
        frames(5, 0);
        EXPECT_EQ(frames(30, dead), 0) << "two gyros";
        EXPECT_EQ(frames(1, dead), dead);
        EXPECT_EQ(frames(300, dead), dead) << "for as long as it lasts";
        EXPECT_EQ(frames(2, 0), 0) << "alive at the next change";
    }
}

TEST_F(Gyros, a_quiet_gyro_may_repeat_its_reading_while_the_others_are_quiet_too) {
    constexpr int kChanges_hz = 5;
    for (int i = 0; i < 1000; ++i) {
        rates_[1] = i * kChanges_hz / 100 % 2;
        ASSERT_EQ(gyros_.look(rates_), 0) << "frame " << i;
    }
    for (int i = 0; i < 300; ++i) {
        rates_[1] = i * kChanges_hz / 100 % 2;
        gyros_.look(rates_);
    }
    EXPECT_EQ(gyros_.look(rates_), firmware::sensors::kRollGyro | firmware::sensors::kYawGyro);
}

TEST_F(Gyros, of_a_jolt_only_the_moment_counts) {
    frames(5, 0);
    for (int i = 1; i <= 20; ++i) {
        rates_[0] += 3001;
        rates_[1] += 3001;
        ASSERT_EQ(gyros_.look(rates_), 0) << "frame " << i;
    }
}

TEST_F(Gyros, all_three_that_stand_still_are_left_to_the_sensors_health) {
    frames(5, 0);
    EXPECT_EQ(frames(300, 7), 0);
}

}  // namespace
