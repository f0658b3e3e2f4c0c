// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "firmware/sensors/compass_learning.hpp"
#include "firmware/sensors/sensors.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware/state/vehicle.hpp"
#include "host_tests/support/fakes/vehicle.hpp"

namespace {

using firmware::state::mutable_vehicle;
using firmware::state::parameters;

struct Declination : testing::Test {
    void SetUp() override {
        parameters.compass_auto_declination = 1;
        parameters.compass_declination_rad = 0.25f;
        mutable_vehicle.gps.fix = firmware::state::GpsFix::three_d;
        mutable_vehicle.gps.position = {400150000,
                                        -1052700000};  // Boulder, 7.6 degrees east in 2027
    }
};

TEST_F(Declination, comes_from_the_table_where_the_airplane_is) {
    firmware::sensors::runDeclination();
    EXPECT_NEAR(core::degrees(parameters.compass_declination_rad), 7.6f, 0.5f);
}

TEST_F(Declination, comes_with_which_way_the_field_points) {
    parameters.compass_auto_declination = 0;
    firmware::sensors::runDeclination();
    EXPECT_EQ(firmware::state::vehicle.compass.points_down, 1);
    mutable_vehicle.gps.position.latitude_e7 = -330000000;
    firmware::sensors::runDeclination();
    EXPECT_EQ(firmware::state::vehicle.compass.points_down, -1);
}

TEST_F(Declination, stays_as_it_was_set_without_a_fix) {
    mutable_vehicle.gps.fix = firmware::state::GpsFix::two_d;
    firmware::sensors::runDeclination();
    EXPECT_EQ(parameters.compass_declination_rad, 0.25f);
}

TEST_F(Declination, stays_as_it_was_set_when_the_table_is_not_wanted) {
    parameters.compass_auto_declination = 0;
    firmware::sensors::runDeclination();
    EXPECT_EQ(parameters.compass_declination_rad, 0.25f);
}

// What two circles teach when the compass is off by 60 mG to the right.
float learntInFlight_mg(bool healthy) {
    parameters.compass_learn = 1;
    for (float& offset_mg : parameters.compass_offset_mg) offset_mg = 0;
    mutable_vehicle.armed = mutable_vehicle.estimate.flying = true;
    mutable_vehicle.compass.healthy = healthy;
    for (int degree = 0; degree < 720; ++degree) {
        const float heading_rad = core::radians(static_cast<float>(degree));
        firmware::sensors::learnCompass(
            {250 * std::cos(heading_rad), 60 - 250 * std::sin(heading_rad), 350});
    }
    return parameters.compass_offset_mg[1];
}

TEST(CompassLearning, takes_nothing_from_a_compass_that_is_known_to_fail) {
    EXPECT_LT(learntInFlight_mg(true), -10);
    EXPECT_EQ(learntInFlight_mg(false), 0);
}

}  // namespace
