// SPDX-License-Identifier: GPL-3.0-or-later
// What the commands beyond the two documents do.
#include "core/maths.hpp"
#include "firmware/actuators/camera.hpp"
#include "firmware/guidance/guidance.hpp"
#include "firmware/mission/handlers.hpp"
#include "firmware/safety/fence.hpp"
#include "host_tests/support/fakes/vehicle.hpp"
#include "mission_flight.hpp"

namespace firmware {
using namespace guidance;
using namespace actuators;
using namespace mission;
using namespace safety;
namespace {

// ---- CONTINUE_CHANGE_ALT

TEST_F(Beyond, continue_flies_on_along_its_course_until_it_is_within_5_m_of_the_altitude) {
    course(70);
    fly({placed(30, 500, 500, 80), waypoint(900)});
    EXPECT_EQ(vehicle.demand.path, Path::leg);
    EXPECT_EQ(vehicle.demand.from, vehicle.estimate.position);
    EXPECT_NEAR(bearingOfPath(), 70, 0.1);
    EXPECT_FLOAT_EQ(vehicle.demand.height_m, 80);
    EXPECT_FALSE(vehicle.demand.sloped) << "it climbs at once";
    mutable_vehicle.progress.passed = true;
    mutable_vehicle.progress.distance_m = 0;
    mutable_vehicle.estimate.height_m = 74.9f;
    pass();
    EXPECT_EQ(missionCurrent(), 1);
    mutable_vehicle.estimate.height_m = 75.1f;
    moveTo(placed(16, 700, 300, 0));
    pass();
    EXPECT_EQ(missionCurrent(), 2);
    EXPECT_EQ(vehicle.demand.from, vehicle.estimate.position) << "the next leg begins here";
}

TEST_F(Beyond, continue_without_a_course_takes_the_heading) {
    course(200, 2.9f);
    mutable_vehicle.attitude.yaw_rad = core::Angle(core::radians(-45));
    fly({placed(30, 0, 0, 80), waypoint(900)});
    EXPECT_NEAR(bearingOfPath(), 315, 0.1);
}

TEST_F(Beyond, continue_that_is_to_climb_or_descend_ends_at_the_altitude_or_past_it) {
    fly({placed(30, 0, 0, 80, 1), placed(30, 0, 0, 60, 2), waypoint(900)});
    mutable_vehicle.estimate.height_m = 78;
    pass();
    EXPECT_EQ(missionCurrent(), 1);
    mutable_vehicle.estimate.height_m = 90;
    pass();
    EXPECT_EQ(missionCurrent(), 2);
    mutable_vehicle.estimate.height_m = 62;
    pass();
    EXPECT_EQ(missionCurrent(), 2);
    mutable_vehicle.estimate.height_m = 50;
    pass();
    EXPECT_EQ(missionCurrent(), 3);
}

TEST_F(Beyond, continue_has_no_place_that_a_distance_could_be_measured_to_or_a_circle_flown_round) {
    parameters.mission_trailing = 1;
    fly({command(114, 9000), command(181, 0, 1), placed(30, 500, 500, 80), command(112, 60)});
    seconds(2);
    EXPECT_FALSE(relayGet());
    moveTo(waypoint(640));
    mutable_vehicle.estimate.height_m = 80;
    pass();
    EXPECT_EQ(vehicle.demand.path, Path::circle) << "what trails the last NAV";
    EXPECT_EQ(vehicle.demand.to, vehicle.estimate.position);
}

TEST_F(Beyond, continue_goes_on_along_the_course_it_has_when_auto_comes_back) {
    fly({placed(30, 0, 0, 80), waypoint(900)});
    requestMode(Mode::loiter, ModeReason::pilot);
    course(120);
    enterAuto();
    EXPECT_NEAR(bearingOfPath(), 120, 0.1);
}

// ---- LOITER_TO_ALT

TEST_F(Beyond, loiter_to_alt_circles_until_the_altitude) {
    MissionItem to_height = placed(31, 500, 0, 80, 0, -80);
    fly({to_height, waypoint(900)});
    EXPECT_EQ(vehicle.demand.path, Path::circle);
    EXPECT_TRUE(vehicle.demand.counter_clockwise);
    mutable_vehicle.estimate.height_m = 80;
    pass();
    EXPECT_EQ(missionCurrent(), 1) << "not on the circle";
    mutable_vehicle.progress.captured = true;
    mutable_vehicle.estimate.height_m = 85.1f;
    pass();
    EXPECT_EQ(missionCurrent(), 1);
    mutable_vehicle.estimate.height_m = 84.9f;
    pass();
    EXPECT_EQ(missionCurrent(), 2);
    EXPECT_EQ(vehicle.demand.from.latitude_e7, to_height.x);
}

TEST_F(Beyond, loiter_to_alt_leaves_on_the_course_of_the_next_leg_where_that_is_asked_for) {
    fly({placed(31, 500, 0, 80, 1), command(112, 1), placed(16, 500, 1000, 80), waypoint(0)});
    mutable_vehicle.estimate.height_m = 80;
    mutable_vehicle.progress.captured = true;
    for (const float away : {0.0f, 79.0f, 101.0f, 270.0f}) {
        course(away);
        pass();
        EXPECT_EQ(missionCurrent(), 1) << away;
    }
    course(81);
    pass();
    EXPECT_EQ(missionCurrent(), 3);
}

TEST_F(Beyond, loiter_to_alt_finds_a_next_leg_that_is_far_down_the_mission) {
    Items items = {placed(31, 500, 0, 80, 1)};
    for (int i = 0; i < 60; ++i) items.push_back(command(181, 0, 1));
    items.push_back(placed(16, 500, 1000, 80));
    fly(items);
    mutable_vehicle.estimate.height_m = 80;
    mutable_vehicle.progress.captured = true;
    course(0);
    seconds(2);
    EXPECT_EQ(missionCurrent(), 1);
    course(90);
    seconds(2);
    EXPECT_EQ(missionCurrent(), 62);
}

TEST_F(Beyond, loiter_to_alt_waits_for_no_course_where_no_place_is_next) {
    for (const MissionItem& next : {placed(30, 0, 0, 100), command(181, 0, 1)}) {
        requestMode(Mode::loiter, ModeReason::pilot);
        fly({placed(31, 500, 0, 80, 1), next});
        mutable_vehicle.estimate.height_m = 80;
        mutable_vehicle.progress.captured = true;
        for (const float degrees : {0.0f, 90.0f, 180.0f, 270.0f}) {
            course(degrees);
            pass();
        }
        EXPECT_NE(missionCurrent(), 1) << next.command;
    }
}

TEST_F(Beyond, loiter_to_alt_looks_again_for_its_next_leg_in_a_new_mission) {
    fly({placed(31, 500, 0, 80, 1), placed(16, 500, 1000, 80)});
    mutable_vehicle.progress.captured = true;
    mutable_vehicle.estimate.height_m = 80;
    course(0);
    pass();
    ASSERT_EQ(upload({placed(31, 500, 0, 80, 1), placed(16, 500, -1000, 80)}),
              MissionResult::accepted);
    pass(3);
    mutable_vehicle.progress.captured = true;
    course(90);
    pass();
    EXPECT_EQ(missionCurrent(), 1);
    course(270);
    pass();
    EXPECT_EQ(missionCurrent(), 2);
}

// ---- the rest

TEST_F(Beyond, inverted_flight_lasts_until_0_or_a_change_of_mode) {
    fly({waypoint(500), command(210, 1), waypoint(900), command(210, 0), waypoint(1500)});
    pass();
    EXPECT_FALSE(vehicle.inverted);
    reach();
    pass();
    EXPECT_TRUE(vehicle.inverted);
    reach();
    pass();
    EXPECT_FALSE(vehicle.inverted);
    missionRestart();
    pass(2);
    reach();
    pass();
    EXPECT_TRUE(vehicle.inverted);
    requestMode(Mode::loiter, ModeReason::pilot);
    pass();
    EXPECT_FALSE(vehicle.inverted);
    enterAuto();
    pass();
    EXPECT_FALSE(vehicle.inverted) << "what has run is not run again";
}

TEST_F(Beyond, a_restart_turns_the_airplane_upright) {
    fly({waypoint(500), command(210, 1), waypoint(900)});
    reach();
    pass();
    EXPECT_TRUE(vehicle.inverted);
    missionRestart();
    pass();
    EXPECT_FALSE(vehicle.inverted);
}

TEST_F(Beyond, fence_enable_reports_why_the_fence_stays_off) {
    fly({command(207, 1), waypoint(500)});
    EXPECT_TRUE(hasStatusText("No fence that is fit"));
    EXPECT_EQ(missionCurrent(), 2) << "and the mission goes on";
}

// What QGroundControl puts into plans and this board has no use for.
TEST_F(Beyond, items_without_an_effect_are_counted_at_upload_and_stored) {
    const std::vector<uint16_t> idle = {201, 205, 93,  115, 191,  195,  197,
                                        212, 214, 530, 600, 2001, 2500, 2501};
    for (const uint16_t id : idle) {
        (void)statusTexts();
        ASSERT_EQ(upload({waypoint(500), command(id), command(id), waypoint(900)}),
                  MissionResult::accepted)
            << id;
        pass(3);
        EXPECT_TRUE(hasStatusText("Mission: 2 items have no effect")) << id;
        MissionItem stored;
        ASSERT_EQ(missionItem(2, stored), core::Status::ok);
        EXPECT_EQ(stored.command, id);
    }
    ASSERT_EQ(upload({waypoint(500), command(189), waypoint(900)}), MissionResult::accepted);
    pass(3);
    EXPECT_FALSE(hasStatusText("no effect"));
}

// A load that is to be set down, and a jump to a tag, are no part of a flight that goes on without.
TEST_F(Beyond, what_would_change_the_flight_is_refused_by_its_item) {
    for (const uint16_t id : {94, 601}) {
        (void)statusTexts();
        EXPECT_EQ(upload({waypoint(500), command(id), waypoint(900)}), MissionResult::unsupported)
            << id;
        EXPECT_TRUE(hasStatusText("Item 2 refused")) << id;
    }
}

TEST_F(Beyond, an_image_is_a_picture_and_a_series_by_time_is_refused) {
    constexpr auto kThirdWrong = static_cast<MissionResult>(8);
    EXPECT_EQ(upload({waypoint(500), command(2000, 0, 2, 0), waypoint(900)}), kThirdWrong);
    EXPECT_EQ(upload({waypoint(500), command(2000, 0, 2, 5), waypoint(900)}), kThirdWrong);
    parameters.output_function[2] = kCameraFunction;
    const uint16_t before = actuators::cameraTriggerCount();
    fly({command(2000, 0, 0, 1), waypoint(500)});
    EXPECT_EQ(actuators::cameraTriggerCount(), before + 1);
}

TEST_F(Beyond, only_what_an_output_can_do_is_its_function) {
    for (const uint8_t slot : {216, 217, 218, 219}) {
        EXPECT_TRUE(parameterSlotTakes(slot, 0));
        EXPECT_TRUE(parameterSlotTakes(slot, kCameraFunction));
        EXPECT_TRUE(parameterSlotTakes(slot, kLeftFlaperonFunction));
        EXPECT_TRUE(parameterSlotTakes(slot, kRightFlaperonFunction));
        for (const float none : {4, 23, 26}) EXPECT_FALSE(parameterSlotTakes(slot, none));
    }
}

}  // namespace
}  // namespace firmware
