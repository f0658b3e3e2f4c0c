// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/airplane/vector.hpp"

#include <gtest/gtest.h>

using namespace simulator;

TEST(Rotation, gives_back_the_angles_it_was_made_from) {
    for (double roll : {-2.0, 0.0, 0.3})
        for (double pitch : {-1.2, 0.0, 0.7})
            for (double yaw : {-3.0, 0.0, 1.5}) {
                const Rotation rotation(quaternion(roll, pitch, yaw));
                EXPECT_NEAR(rotation.roll_rad(), roll, 1e-12);
                EXPECT_NEAR(rotation.pitch_rad(), pitch, 1e-12);
                EXPECT_NEAR(rotation.yaw_rad(), yaw, 1e-12);
            }
}

TEST(Rotation, turns_the_nose_to_where_it_points) {
    const Vec3 nose = Rotation(quaternion(0, 0.5, M_PI / 2)).toEarth({1, 0, 0});
    EXPECT_NEAR(nose.x, 0, 1e-12);
    EXPECT_NEAR(nose.y, std::cos(0.5), 1e-12);
    EXPECT_NEAR(nose.z, -std::sin(0.5), 1e-12);
}

TEST(Rotation, to_the_body_is_the_inverse_of_to_the_earth) {
    const Rotation rotation(quaternion(0.4, -0.3, 2));
    const Vec3 there = rotation.toBody(rotation.toEarth({1, 2, 3}));
    EXPECT_NEAR(length(there - Vec3{1, 2, 3}), 0, 1e-12);
}

TEST(Quaternion, turns_by_body_rates) {
    Quaternion q = quaternion(0, 0, 1);
    for (int i = 0; i < 1000; ++i) q = normalized(q + turning(q, {0.5, 0, 0}) * 1e-3);
    EXPECT_NEAR(Rotation(q).roll_rad(), 0.5, 1e-4);
    EXPECT_NEAR(Rotation(q).yaw_rad(), 1, 1e-9);
}
