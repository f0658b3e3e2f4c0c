// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/sensors/compass_mounting.hpp"

#include <gtest/gtest.h>

#include "drivers/orientation.hpp"
#include "firmware/notify/text_queue.hpp"
#include "firmware/sensors/sensors.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware/state/vehicle.hpp"
#include "host_tests/support/fakes/clock.hpp"
#include "host_tests/support/fakes/fakes.hpp"
#include "host_tests/support/fakes/vehicle.hpp"

namespace {

using namespace firmware::sensors;
using firmware::state::mutable_vehicle;
using firmware::state::parameters;

constexpr float kHorizontal_mg = 200, kDown_mg = 430, kDeclination_deg = 12;

core::Vector3 toBody(float heading_deg, float pitch_deg) {
    const float magnetic = core::radians(heading_deg - kDeclination_deg);
    const float pitch = core::radians(pitch_deg);
    const float ahead = kHorizontal_mg * cosf(magnetic), right = -kHorizontal_mg * sinf(magnetic);
    return {ahead * cosf(pitch) - kDown_mg * sinf(pitch), right,
            kDown_mg * cosf(pitch) + ahead * sinf(pitch)};
}

// Of a module that is mounted so what the board reads while it takes it for mounted as set.
core::Vector3 readAs(const core::Vector3& body_mg, uint8_t mounted, uint8_t set) {
    core::Vector3 sensed_mg = {};
    const core::Vector3 axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (int i = 0; i < 3; ++i)  // the inverse of a rotation is its transpose
        (&sensed_mg.x)[i] = core::dot(drivers::fromMounting(axes[i], mounted), body_mg);
    return drivers::fromMounting(sensed_mg, set);
}

std::string nextText() {
    char text[firmware::notify::kTextSize + 1] = {};
    firmware::notify::Severity severity;
    if (firmware::notify::readText(0, severity, text)) firmware::notify::textTaken(0);
    return text;
}

struct CompassMounting : testing::Test {
    void SetUp() override {
        parameters.compass_use = 1;
        parameters.compass_external = 1;
        parameters.compass_declination_rad = core::radians(kDeclination_deg);
        mutable_vehicle.gps.fix = firmware::state::GpsFix::three_d;
        mutable_vehicle.gps.ground_speed_mps = 12;
        mutable_vehicle.estimate.flying = true;
        mutable_vehicle.compass.accepted = true;
    }
    void fly(float heading_deg, float drift_deg, int looks) {
        auto& vehicle = mutable_vehicle;
        vehicle.gps.course_cd =
            static_cast<uint16_t>(core::wrap360_cd(core::rounded((heading_deg + drift_deg) * 100)));
        const float course = core::radians(heading_deg + drift_deg);
        vehicle.gps.velocity_mps =
            core::Vector3{cosf(course), sinf(course), 0} * vehicle.gps.ground_speed_mps;
        vehicle.attitude.sin_pitch = core::Ratio(sinf(core::radians(pitch_deg)));
        vehicle.compass.field_mg = readAs(toBody(heading_deg, pitch_deg), mounted,
                                          static_cast<uint8_t>(parameters.compass_orientation)) +
                                   own_mg;
        for (int i = 0; i < looks; ++i) watchCompassMounting();
    }
    // The run after the last look evaluates them.
    void thereAndBack(float heading_deg) {
        fly(heading_deg, 0, 7);
        fly(heading_deg + 180, 0, 8);
    }

    uint8_t mounted = 0;
    float pitch_deg = 4;
    core::Vector3 own_mg = {0, 0, 0};  // of the airplane, until it is learnt
};

TEST_F(CompassMounting, that_is_set_right_is_not_turned) {
    for (const uint8_t orientation : {0, 2, 5, 8, 10, 12, 14, 24}) {
        parameters.compass_orientation = static_cast<int8_t>(mounted = orientation);
        for (int heading = 0; heading < 180; heading += 10) thereAndBack(heading);
        EXPECT_FALSE(compassTurned()) << int{orientation};
    }
}

TEST_F(CompassMounting, that_is_turned_is_found_on_any_course_with_what_to_set) {
    for (const uint8_t side : {0, 8})
        for (uint8_t set = 0; set < 8; ++set)
            for (uint8_t quarters = 1; quarters < 4; ++quarters)
                for (int heading = -40; heading < 360; heading += 53) {
                    fakes::reset();
                    SetUp();
                    parameters.compass_orientation = static_cast<int8_t>(side + set);
                    mounted = static_cast<uint8_t>(side + (set + 2 * quarters) % 8);
                    thereAndBack(static_cast<float>(heading));
                    ASSERT_TRUE(compassTurned())
                        << side + set << " is " << int{mounted} << " at " << heading;
                    ASSERT_EQ(compassOrientation(), mounted) << side + set;
                    parameters.compass_orientation = static_cast<int8_t>(mounted);
                    EXPECT_FALSE(compassTurned()) << "set now";
                }
}

TEST_F(CompassMounting, is_reported_once) {
    mounted = 2;
    thereAndBack(30);
    thereAndBack(120);
    EXPECT_EQ(nextText(), "Compass turned: COMPASS_ORIENT should be 2");
    EXPECT_EQ(nextText(), "");
}

TEST_F(CompassMounting, needs_both_directions_and_more_than_a_few_looks) {
    mounted = 4;
    fly(10, 0, 100);
    EXPECT_FALSE(compassTurned()) << "a wind from behind that is stronger than the airplane";
    fly(190, 0, 7);
    EXPECT_FALSE(compassTurned());
    fly(190, 0, 1);
    EXPECT_TRUE(compassTurned()) << "by seven looks, in the run after them";
}

TEST_F(CompassMounting, a_strong_wind_across_the_way_does_not_turn) {
    for (int lap = 0; lap < 10; ++lap) {  // the nose 80 degrees into the wind from the east
        fly(80, -80, 7);
        fly(100, 80, 7);
    }
    EXPECT_FALSE(compassTurned());
}

// Up to 45 degrees by that field and as many by the wind, which a single look takes for a quarter
// of a turn more or less.
TEST_F(CompassMounting, is_found_beside_a_field_of_the_airplane_in_a_wind_across_the_way) {
    for (const uint8_t quarters : {0, 1, 2, 3})
        for (const float wind_deg : {-40.0f, 40.0f})
            for (int heading = 0; heading < 360; heading += 30) {
                fakes::reset();
                SetUp();
                own_mg = {-140, 140, 60};
                mounted = static_cast<uint8_t>(2 * quarters);
                const float course = static_cast<float>(heading);
                fly(course + wind_deg, -wind_deg, 7);
                fly(course + 180 - wind_deg, wind_deg, 8);
                ASSERT_EQ(compassTurned(), quarters != 0) << course << ' ' << wind_deg;
                if (quarters != 0) {
                    ASSERT_EQ(compassOrientation(), mounted);
                }
            }
}

TEST_F(CompassMounting, is_not_guessed_where_the_field_is_weak) {
    mounted = 4;
    for (int lap = 0; lap < 3; ++lap) {  // 35 mG are left of the 200
        fly(80, -80, 7);
        fly(100, 80, 7);
    }
    EXPECT_FALSE(compassTurned());
}

TEST_F(CompassMounting, is_not_looked_at_slowly_nor_in_a_turn) {
    mounted = 2;
    mutable_vehicle.gps.ground_speed_mps = 5;
    thereAndBack(0);
    mutable_vehicle.gps.ground_speed_mps = 12;
    mutable_vehicle.attitude.sin_roll = core::Ratio(0.3f);
    thereAndBack(0);
    EXPECT_FALSE(compassTurned());
    mutable_vehicle.attitude.sin_roll = {};
    thereAndBack(0);
    EXPECT_TRUE(compassTurned());
}

// A sensor at its end reads 1,900 mG an axis: fourteen of them are more than the sums hold.
TEST_F(CompassMounting, is_not_looked_at_by_readings_that_are_not_accepted) {
    mounted = 4;
    mutable_vehicle.compass.accepted = false;
    thereAndBack(0);
    thereAndBack(0);
    EXPECT_FALSE(compassTurned());
}

TEST_F(CompassMounting, of_the_board_itself_asks_for_an_outside_one) {
    parameters.compass_external = 0;
    mounted = 4;
    thereAndBack(0);
    ASSERT_TRUE(compassTurned());
    EXPECT_EQ(compassOrientation(), 4);
}

TEST_F(CompassMounting, of_a_compass_that_is_not_used_does_not_matter) {
    mounted = 4;
    thereAndBack(0);
    parameters.compass_use = 0;
    EXPECT_FALSE(compassTurned());
}

TEST_F(CompassMounting, is_looked_at_in_flight_by_every_second_run_of_the_declination) {
    mounted = 6;
    const auto run = [](float seconds) {
        for (float s = 0; s < seconds; ++s) {
            fakes::advance_ms(1000);
            runDeclination();
        }
    };
    parameters.compass_auto_declination = 0;
    mutable_vehicle.estimate.flying = false;
    fly(0, 0, 0);
    run(30);
    fly(180, 0, 0);
    run(30);
    EXPECT_FALSE(compassTurned()) << "on the ground";
    mutable_vehicle.estimate.flying = true;
    run(17);
    fly(0, 0, 0);
    run(17);
    EXPECT_TRUE(compassTurned());
    EXPECT_EQ(compassOrientation(), 6);
}

}  // namespace
