// SPDX-License-Identifier: GPL-3.0-or-later
// What the commands beyond the two documents do.
#include "core/maths.hpp"
#include "firmware/actuators/camera.hpp"
#include "firmware/guidance/guidance.hpp"
#include "firmware/mission/handlers.hpp"
#include "firmware/safety/fence.hpp"
#include "flight.hpp"
#include "host_tests/support/fakes/vehicle.hpp"

namespace firmware {
using namespace guidance;
using namespace actuators;
using namespace mission;
using namespace safety;
namespace {

class Beyond : public MissionFlight {
protected:
    void SetUp() override {
        MissionFlight::SetUp();
        cameraStart();
        course(0);
    }
    static void course(float degrees, float speed_mps = 15) {
        auto& estimate = mutable_vehicle.estimate;
        estimate.ground_speed_mps = speed_mps;
        estimate.velocity_mps = {speed_mps * cosf(core::radians(degrees)),
                                 speed_mps * sinf(core::radians(degrees)), 0};
        estimate.course_cd = core::wrap360_cd(core::rounded(degrees * 100));
    }
    static void moveTo(const MissionItem& item) {
        mutable_vehicle.estimate.position = {item.x, item.y};
    }
    static float bearingOfPath() {
        return static_cast<float>(geo::bearing_cd(vehicle.demand.from, vehicle.demand.to)) / 100;
    }
};

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
    setMode(Mode::loiter, ModeReason::pilot);
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
        setMode(Mode::loiter, ModeReason::pilot);
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

// ---- landings

class Landings : public Beyond {
protected:
    // Two of them, 2 km north and 1 km east of home.
    static Items landings() {
        return {waypoint(500),          placed(189, 2000, 0, 60), placed(16, 1500, 0, 40),
                placed(21, 1000, 0, 0), placed(189, 0, 1000, 60), placed(16, 0, 500, 40),
                placed(21, 0, 0, 0)};
    }
    static void flyRtl() {
        mutable_vehicle.demand.new_path = false;
        runMode();
        pass(3);
    }
};

TEST_F(Landings, rtl_goes_to_the_nearer_one_at_once_or_when_it_is_home_or_not) {
    ASSERT_EQ(upload(landings()), MissionResult::accepted);
    for (const int north : {0, 1500}) {
        moveTo(waypoint(north));
        parameters.rtl_landing = 2;
        setMode(Mode::rtl, ModeReason::pilot);
        flyRtl();
        EXPECT_EQ(vehicle.mode, Mode::automatic);
        EXPECT_EQ(missionCurrent(), north == 0 ? 6 : 3);
        EXPECT_EQ(vehicle.demand.from, vehicle.estimate.position);
        setMode(Mode::loiter, ModeReason::pilot);
    }
    parameters.rtl_landing = 1;
    setMode(Mode::rtl, ModeReason::pilot);
    flyRtl();
    EXPECT_EQ(vehicle.mode, Mode::rtl);
    mutable_vehicle.progress.captured = true;
    mutable_vehicle.estimate.height_m = 80;
    flyRtl();
    EXPECT_EQ(vehicle.mode, Mode::rtl) << "not up at 100 m";
    mutable_vehicle.estimate.height_m = 95;
    flyRtl();
    EXPECT_EQ(vehicle.mode, Mode::automatic);

    parameters.rtl_landing = 0;
    setMode(Mode::rtl, ModeReason::pilot);
    mutable_vehicle.progress.captured = true;
    flyRtl();
    EXPECT_EQ(vehicle.mode, Mode::rtl);
}

TEST_F(Landings, a_start_at_0_0_lies_where_the_next_nav_does) {
    Items items = landings();
    for (MissionItem& item : items)
        if (item.command == 189) item.x = item.y = 0;
    ASSERT_EQ(upload(items), MissionResult::accepted);
    moveTo(placed(16, 0, 900, 0));
    EXPECT_TRUE(missionLand());
    pass(3);
    EXPECT_EQ(missionCurrent(), 6);
    setMode(Mode::loiter, ModeReason::pilot);
    moveTo(waypoint(1400));
    EXPECT_TRUE(missionLand());
    pass(3);
    EXPECT_EQ(missionCurrent(), 3);
}

TEST_F(Landings, without_a_start_rtl_stays_rtl_and_says_so) {
    ASSERT_EQ(upload({waypoint(500), placed(21, 0, 0, 0)}), MissionResult::accepted);
    parameters.rtl_landing = 2;
    setMode(Mode::rtl, ModeReason::pilot);
    (void)told();
    flyRtl();
    EXPECT_EQ(vehicle.mode, Mode::rtl);
    EXPECT_TRUE(tells("RTL: the mission has no DO_LAND_START"));
    flyRtl();
    EXPECT_FALSE(tells("DO_LAND_START")) << "once";
    EXPECT_FALSE(missionLand());
}

TEST_F(Landings, another_mode_ends_the_search) {
    ASSERT_EQ(upload(landings()), MissionResult::accepted);
    EXPECT_TRUE(missionLand());
    setMode(Mode::fbwa, ModeReason::pilot);
    seconds(3);
    EXPECT_EQ(vehicle.mode, Mode::fbwa);
}

TEST_F(Landings, the_marker_does_nothing_where_the_mission_comes_by) {
    fly(landings());
    reach();
    EXPECT_EQ(missionCurrent(), 3);
    EXPECT_EQ(vehicle.demand.from.latitude_e7, waypoint(500).x);
}

TEST_F(Landings, going_around_climbs_straight_on_then_begins_at_the_nearest_start) {
    fly(landings());
    reach();
    reach();
    ASSERT_EQ(vehicle.demand.path, Path::land);
    const geo::Position from = vehicle.demand.from, to = vehicle.demand.to;
    mutable_vehicle.estimate.height_m = 8;
    EXPECT_TRUE(missionGoAround(0));
    EXPECT_EQ(vehicle.demand.path, Path::leg);
    EXPECT_EQ(vehicle.demand.from, from);
    EXPECT_EQ(vehicle.demand.to, to);
    EXPECT_FLOAT_EQ(vehicle.demand.height_m, 30);
    EXPECT_FALSE(vehicle.demand.sloped);
    moveTo(waypoint(900));
    mutable_vehicle.estimate.height_m = 28;
    seconds(2);
    EXPECT_EQ(missionCurrent(), 4);
    mutable_vehicle.estimate.height_m = 29.5f;
    seconds(1);
    EXPECT_EQ(missionCurrent(), 3);
    EXPECT_EQ(vehicle.demand.path, Path::leg);
    EXPECT_EQ(vehicle.demand.from, vehicle.estimate.position);
}

TEST_F(Landings, going_around_goes_up_to_the_height_it_is_given) {
    fly({waypoint(1500), placed(21, 1000, 0, 0)});
    reach();
    EXPECT_TRUE(missionGoAround(55));
    EXPECT_FLOAT_EQ(vehicle.demand.height_m, 55);
    EXPECT_FALSE(missionGoAround(55)) << "it is on its way";
}

TEST_F(Landings, going_around_without_a_start_lands_again_from_the_nav_before) {
    fly({waypoint(500), placed(16, 1500, 0, 40), placed(21, 1000, 0, 0), waypoint(3000)});
    reach();
    reach();
    ASSERT_EQ(missionCurrent(), 3);
    EXPECT_TRUE(missionGoAround(NAN));
    mutable_vehicle.estimate.height_m = 30;
    seconds(1);
    EXPECT_EQ(missionCurrent(), 2);
}

TEST_F(Landings, all_throttle_breaks_one_off_but_not_a_stick_that_was_left_there) {
    mutable_vehicle.radio.throttle_pct = 100;
    fly(landings());
    reach();
    reach();
    seconds(2);
    ASSERT_EQ(vehicle.demand.path, Path::land);
    mutable_vehicle.radio.throttle_pct = 60;
    seconds(1);
    EXPECT_EQ(vehicle.demand.path, Path::land) << "a nudge";
    (void)told();
    mutable_vehicle.estimate.height_m = 8;
    mutable_vehicle.radio.throttle_pct = 95;
    seconds(1);
    EXPECT_EQ(vehicle.demand.path, Path::leg);
    EXPECT_FLOAT_EQ(vehicle.demand.height_m, 30);
    EXPECT_TRUE(tells("Landing broken off by the throttle"));
}

TEST_F(Landings, a_radio_that_comes_back_with_all_throttle_breaks_none_off) {
    mutable_vehicle.radio.throttle_pct = 100;
    fly(landings());
    reach();
    reach();
    seconds(1);
    mutable_vehicle.radio.lost = true;
    mutable_vehicle.radio.throttle_pct = 0;
    seconds(1);
    mutable_vehicle.radio.lost = false;
    mutable_vehicle.radio.throttle_pct = 100;
    seconds(1);
    EXPECT_EQ(vehicle.demand.path, Path::land);
}

TEST_F(Landings, nothing_is_broken_off_that_is_no_landing_or_is_over) {
    fly(landings());
    EXPECT_FALSE(missionGoAround(50)) << "a waypoint";
    reach();
    reach();
    mutable_vehicle.estimate.flying = false;
    EXPECT_FALSE(missionGoAround(50)) << "down";
    mutable_vehicle.estimate.flying = true;
    setMode(Mode::loiter, ModeReason::pilot);
    EXPECT_FALSE(missionGoAround(50)) << "not AUTO";
}

TEST_F(Landings, the_start_of_a_landing_that_is_flown_is_a_go_around_first) {
    fly(landings());
    reach();
    reach();
    mutable_vehicle.estimate.height_m = 3;
    EXPECT_TRUE(missionLand());
    EXPECT_EQ(vehicle.demand.path, Path::leg);
    EXPECT_FLOAT_EQ(vehicle.demand.height_m, 30);
}

// ---- the camera

class Camera : public Beyond {
protected:
    void SetUp() override {
        Beyond::SetUp();
        parameters.output_function[2] = kCameraFunction;
        runOutputs();
    }
    static int shutter_us() { return outputPulse_us(7); }
    static void flyOn(int metres) { mutable_vehicle.estimate.position.latitude_e7 += metres * 90; }
};

TEST_F(Camera, digicam_control_holds_the_shutter_for_its_duration) {
    EXPECT_EQ(shutter_us(), 1100);
    fly({command(203), waypoint(500)});
    EXPECT_EQ(picturesTaken(), 1);
    EXPECT_EQ(shutter_us(), 1300);
    pass(9);
    EXPECT_EQ(shutter_us(), 1300);
    pass();
    EXPECT_EQ(shutter_us(), 1100);
}

TEST_F(Camera, works_the_relay_where_it_is_connected_to_that) {
    parameters.camera_on_relay = 1;
    parameters.camera_duration_ds = 3;
    fly({command(203), waypoint(500)});
    EXPECT_TRUE(relayGet());
    EXPECT_EQ(shutter_us(), 1100);
    pass(2);
    EXPECT_TRUE(relayGet());
    pass();
    EXPECT_FALSE(relayGet());
}

TEST_F(Camera, is_told_to_be_missing_where_no_output_is_its) {
    parameters.output_function[2] = 0;
    fly({command(203), waypoint(500)});
    EXPECT_TRUE(tells("Camera: no output has its function"));
    EXPECT_EQ(picturesTaken(), 0);
}

TEST_F(Camera, is_told_to_be_busy_rather_than_that_a_picture_is_lost) {
    fly({command(203), command(203), waypoint(500)});
    EXPECT_TRUE(tells("Camera: still busy"));
    EXPECT_EQ(picturesTaken(), 1);
}

TEST_F(Camera, takes_a_picture_each_so_many_metres_until_0) {
    parameters.camera_duration_ds = 0;
    mutable_vehicle.estimate.ground_speed_mps = 10;
    fly({command(206, 25), waypoint(5000), command(206, 0), waypoint(9000)});
    EXPECT_EQ(picturesTaken(), 0) << "the first is due 25 m on";
    for (int i = 0; i < 250; ++i) {
        flyOn(1);
        pass();
    }
    EXPECT_NEAR(picturesTaken(), 10, 1);
    const int before = picturesTaken();
    reach();
    for (int i = 0; i < 100; ++i) {
        flyOn(1);
        pass();
    }
    EXPECT_EQ(picturesTaken(), before);
}

TEST_F(Camera, the_exact_distance_of_a_picture_counts) {
    parameters.camera_duration_ds = 0;
    mutable_vehicle.estimate.ground_speed_mps = 0;
    fly({command(206, 12.5f), waypoint(5000)});
    flyOn(12);
    pass();
    EXPECT_EQ(picturesTaken(), 0);
    flyOn(1);
    pass();
    EXPECT_EQ(picturesTaken(), 1);
}

TEST_F(Camera, waits_for_the_shutter_to_be_let_go) {
    parameters.camera_duration_ds = 10;
    fly({command(206, 5), waypoint(5000)});
    for (int i = 0; i < 36; ++i) {
        flyOn(10);
        pass();
    }
    EXPECT_EQ(picturesTaken(), 3);
}

TEST_F(Camera, stops_when_disarmed_and_when_the_mission_restarts) {
    for (const bool disarmed : {true, false}) {
        setMode(Mode::loiter, ModeReason::pilot);
        fly({waypoint(500), command(206, 25), waypoint(5000)});
        reach();
        if (disarmed) {
            mutable_vehicle.armed = false;
            pass();
            mutable_vehicle.armed = true;
        } else {
            missionRestart();
        }
        const int before = picturesTaken();
        flyOn(100);
        pass(3);
        EXPECT_EQ(picturesTaken(), before) << disarmed;
    }
}

TEST_F(Camera, an_output_of_another_function_goes_on_following_the_receiver) {
    parameters.output_function[2] = 0;
    mutable_vehicle.radio.pulse_us[6] = 1712;
    runOutputs();
    EXPECT_EQ(shutter_us(), 1712);
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
    setMode(Mode::loiter, ModeReason::pilot);
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

TEST_F(Beyond, fence_enable_tells_what_keeps_the_fence_off) {
    fly({command(207, 1), waypoint(500)});
    EXPECT_TRUE(tells("No fence that is fit"));
    EXPECT_EQ(missionCurrent(), 2) << "and the mission goes on";
}

TEST_F(Beyond, a_mount_is_told_to_be_missing_when_the_mission_comes) {
    for (const uint16_t id : {201, 205}) {
        (void)told();
        ASSERT_EQ(upload({waypoint(500), command(id), command(id), waypoint(900)}),
                  MissionResult::accepted);
        pass(3);
        EXPECT_TRUE(tells("Mission: no mount for item 2")) << id;
    }
    ASSERT_EQ(upload({waypoint(500), waypoint(900)}), MissionResult::accepted);
    pass(3);
    EXPECT_FALSE(tells("no mount"));
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
