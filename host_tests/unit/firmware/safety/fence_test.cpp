// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/safety/fence.hpp"

#include "fence_bench.hpp"
#include "firmware/modes/guided.hpp"
#include "hal/eeprom.hpp"

namespace firmware {
namespace {

class Fence : public FenceBench {};

TEST_F(Fence, a_mission_switches_it) {
    raise();
    ASSERT_TRUE(fenceEnable(0));
    fly({command(207, 1), waypoint(500), command(207, 0), waypoint(900)});
    EXPECT_TRUE(fenceOn());
    tenths(2);
    EXPECT_EQ(fenceReport().breach, Breach::none);
    reach();
    EXPECT_FALSE(fenceOn());
}

TEST_F(Fence, a_mission_takes_its_floor_away) {
    parameters.fence_min_m = 40;
    parameters.fence_max_m = 100;
    raise();
    tenths(2);  // above the floor
    fly({command(207, 2), waypoint(500)});
    mutable_vehicle.estimate.height_m = 20;
    tenths(2);
    EXPECT_EQ(fenceReport().breach, Breach::none);
    ASSERT_TRUE(fenceEnable(1));
    mutable_vehicle.estimate.height_m = 50;
    tenths(2);
    mutable_vehicle.estimate.height_m = 20;
    tenths(2);
    EXPECT_EQ(fenceReport().breach, Breach::minalt);
}

TEST_F(Fence, an_airplane_that_leaves_it_is_flown_to_the_return_point) {
    raise();
    requestMode(Mode::fbwa, ModeReason::pilot);
    goTo(beside(kSide_e7 - 1, 0));
    EXPECT_EQ(vehicle.mode, Mode::fbwa);

    leave();

    EXPECT_EQ(vehicle.mode, Mode::guided);
    EXPECT_EQ(vehicle.demand.path, Path::circle);
    EXPECT_EQ(vehicle.demand.to, beside(100, 200));
    EXPECT_FLOAT_EQ(vehicle.demand.height_m, 70);
    EXPECT_EQ(fenceReport().breach, +Breach::boundary);
    EXPECT_EQ(fenceReport().breaches, 1);
    EXPECT_TRUE(hasStatusText("Fence breach: outside"));
}

TEST_F(Fence, the_sticks_are_ignored_until_the_pilot_takes_over) {
    raise();
    leave();
    mutable_vehicle.radio.roll_cd = 4500;
    tenths(1);
    EXPECT_EQ(vehicle.pilot_roll_rad.raw, 0);

    // outside, and it stays his
    ASSERT_TRUE(requestMode(Mode::fbwa, ModeReason::pilot));
    tenths(20);
    EXPECT_EQ(vehicle.mode, Mode::fbwa);
    requestMode(Mode::loiter, ModeReason::pilot);
    tenths(1);
    EXPECT_NE(vehicle.pilot_roll_rad.raw, 0);

    comeBack();
    EXPECT_TRUE(hasStatusText("Fence: inside again"));
    leave();
    EXPECT_EQ(vehicle.mode, Mode::guided);
    EXPECT_EQ(fenceReport().breaches, 2);
}

TEST_F(Fence, turns_back_once_and_the_ground_station_may_guide_on) {
    raise();
    leave();
    ASSERT_EQ(vehicle.mode, Mode::guided);
    MissionItem target = {};
    target.command = MavCmd::nav_waypoint;
    target.x = beside(300, 300).latitude_e7;
    target.y = beside(300, 300).longitude_e7;
    target.z = 90;
    ASSERT_EQ(firmware::modes::guideTo(target), MissionResult::accepted);
    tenths(5);
    EXPECT_EQ(vehicle.demand.to, beside(300, 300));
}

TEST_F(Fence, switched_off_gives_back_the_mode_it_took) {
    raise();
    requestMode(Mode::fbwa, ModeReason::pilot);
    leave();
    comeBack();
    EXPECT_EQ(vehicle.mode, Mode::guided);
    EXPECT_TRUE(vehicle.fence_holds);
    EXPECT_TRUE(fenceEnable(0));
    tenths(1);
    EXPECT_EQ(vehicle.mode, Mode::fbwa);
    EXPECT_FALSE(vehicle.fence_holds);
}

TEST_F(Fence, switched_off_leaves_a_mode_that_was_chosen_since) {
    raise();
    leave();
    requestMode(Mode::stabilize, ModeReason::pilot);
    tenths(1);
    fenceEnable(0);
    tenths(1);
    EXPECT_EQ(vehicle.mode, Mode::stabilize);
}

TEST_F(Fence, only_reports_when_its_action_is_report) {
    raise();
    parameters.fence_action = 2;
    leave();
    EXPECT_EQ(vehicle.mode, Mode::loiter);
    EXPECT_EQ(fenceReport().breach, +Breach::boundary);
    EXPECT_TRUE(hasStatusText("Fence breach: outside"));
}

TEST_F(Fence, is_not_watched_without_an_action) {
    raise();
    parameters.fence_action = 0;
    leave();
    EXPECT_EQ(vehicle.mode, Mode::loiter);
    EXPECT_EQ(fenceReport().breach, +Breach::none);
    EXPECT_FALSE(fenceOn());
}

TEST_F(Fence, leaves_the_throttle_to_the_pilot_when_its_action_says_so) {
    raise();
    parameters.fence_action = 3;
    leave();
    mutable_vehicle.throttle_demand = core::Ratio(0.9f);
    mutable_vehicle.radio.throttle_pct = 20;
    tenths(1);
    EXPECT_NEAR(vehicle.throttle_demand.toFloat(), 0.2f, 1e-3f);
}

TEST_F(Fence, has_the_throttle_too_when_its_action_does_not_say_so) {
    raise();
    leave();
    EXPECT_TRUE(vehicle.fence_holds);
    EXPECT_FALSE(vehicle.fence_throttle);
    requestMode(Mode::fbwa, ModeReason::pilot);
    parameters.fence_action = 3;
    tenths(1);
    EXPECT_FALSE(vehicle.fence_throttle) << "it does not hold the airplane";
}

TEST_F(Fence, returns_at_the_height_of_ALT_HOLD_RTL_or_at_the_present_one) {
    raise();
    parameters.rtl_height_cm = -1;
    mutable_vehicle.estimate.height_m = 83;
    leave();
    EXPECT_FLOAT_EQ(vehicle.demand.height_m, 83);
    requestMode(Mode::fbwa, ModeReason::pilot);
    comeBack();
    parameters.rtl_height_cm = 0;
    leave();
    EXPECT_FLOAT_EQ(vehicle.demand.height_m, 0);
}

TEST_F(Fence, counts_255_breaches_and_no_more) {
    raise();
    parameters.fence_action = 2;
    for (int i = 0; i < 257; ++i) {
        leave();
        comeBack();
    }
    EXPECT_EQ(fenceReport().breaches, 255);
}

// Of circles 1e-7 degrees northward are 11 mm.
TEST_F(Fence, an_airplane_that_flies_into_a_zone_is_flown_to_the_return_point) {
    const Items triangle = {
        point(MavCmd::nav_fence_polygon_vertex_exclusion, beside(10000, -9000), 3),
        point(MavCmd::nav_fence_polygon_vertex_exclusion, beside(10000, 9000), 3),
        point(MavCmd::nav_fence_polygon_vertex_exclusion, beside(19000, 0), 3)};
    const Items circle = {point(MavCmd::nav_fence_circle_exclusion, beside(15000, 0), 55.5f)};
    for (const Items& zone : {triangle, circle}) {
        Items items = square();
        items.insert(items.end(), zone.begin(), zone.end());
        raise(items);
        requestMode(Mode::fbwa, ModeReason::pilot);
        goTo(beside(9900, 0));
        EXPECT_EQ(vehicle.mode, Mode::fbwa) << "before it";
        goTo(beside(10100, 0));
        EXPECT_EQ(vehicle.mode, Mode::guided) << "in it";
        EXPECT_EQ(vehicle.demand.to, beside(100, 200));
        EXPECT_EQ(fenceReport().breach, +Breach::boundary);
        EXPECT_TRUE(hasStatusText("Fence breach: outside"));
        comeBack();
        EXPECT_EQ(fenceReport().breach, +Breach::none);
        ASSERT_TRUE(fenceEnable(0));
        tenths(1);
    }
}

TEST_F(Fence, an_airplane_that_leaves_a_circle_is_flown_to_the_return_point) {
    raise({point(MavCmd::nav_fence_circle_inclusion, kHome, 200),
           point(MavCmd::nav_fence_return_point, beside(100, 200))});
    goTo(beside(17900, 0));
    EXPECT_EQ(fenceReport().breach, +Breach::none);
    goTo(beside(18100, 0));
    EXPECT_EQ(vehicle.mode, Mode::guided);
    EXPECT_EQ(vehicle.demand.to, beside(100, 200));
}

// Twenty circles take seven checks.
TEST_F(Fence, the_largest_one_is_gone_round_in_less_than_two_seconds) {
    Items circles(19, point(MavCmd::nav_fence_circle_inclusion, kHome, 300));
    circles.push_back(point(MavCmd::nav_fence_circle_inclusion, kHome, 200));
    ASSERT_EQ(store(MavMissionType::fence, circles), MissionResult::accepted);
    tenths(20);
    ASSERT_TRUE(fenceEnable(1));
    mutable_vehicle.estimate.position = beside(18100, 0);
    int checks = 0;  // of which there are five a second
    while (fenceReport().breach == Breach::none && checks < 20) {
        runFence();
        ++checks;
    }
    EXPECT_LE(checks, 7);
    EXPECT_GE(checks, 2);
}

TEST_F(Fence, without_a_return_point_sends_home) {
    Items corners = square();
    corners.erase(corners.begin());
    raise(corners);
    leave();
    EXPECT_EQ(vehicle.mode, Mode::rtl);
    EXPECT_EQ(vehicle.demand.to, kHome);
}

struct Limits {
    float height_m;
    uint8_t breach;
};
TEST_F(Fence, limits_the_height_from_above_and_once_climbed_from_below) {
    parameters.fence_min_m = 30;
    parameters.fence_max_m = 120;
    mutable_vehicle.estimate.height_m = 10;
    raise();
    EXPECT_EQ(fenceReport().breach, +Breach::none);  // still climbing out
    for (const Limits& each : {Limits{50, Breach::none},
                               {121, Breach::maxalt},
                               {119, Breach::none},
                               {29, Breach::minalt},
                               {31, Breach::none}}) {
        mutable_vehicle.estimate.height_m = each.height_m;
        tenths(1);
        EXPECT_EQ(fenceReport().breach, each.breach) << each.height_m;
    }
    EXPECT_FLOAT_EQ(vehicle.demand.height_m, 75);  // midway
    parameters.fence_return_m = 60;
    mutable_vehicle.estimate.height_m = 130;
    tenths(1);
    EXPECT_FLOAT_EQ(vehicle.demand.height_m, 60);
    mutable_vehicle.estimate.height_m = 60;
    tenths(1);

    ASSERT_TRUE(fenceEnable(2));
    mutable_vehicle.estimate.height_m = 5;
    tenths(1);
    EXPECT_EQ(fenceReport().breach, +Breach::none);
}

TEST_F(Fence, limits_the_height_beyond_its_bounds_and_not_at_them) {
    parameters.fence_action = 2;
    parameters.fence_min_m = 30;
    parameters.fence_max_m = 120;
    mutable_vehicle.estimate.height_m = 10;
    raise();
    for (const Limits& each : {Limits{30, Breach::none},
                               {29, Breach::none},  // at the floor it was not above it
                               {120, Breach::none},
                               {30, Breach::none},
                               {29, Breach::minalt}}) {
        mutable_vehicle.estimate.height_m = each.height_m;
        tenths(1);
        EXPECT_EQ(fenceReport().breach, each.breach) << each.height_m;
    }
}

TEST_F(Fence, forgets_on_the_ground_that_the_airplane_has_been_above_the_floor) {
    parameters.fence_min_m = 30;
    parameters.fence_max_m = 120;
    raise();
    mutable_vehicle.estimate.height_m = 50;
    tenths(1);
    mutable_vehicle.estimate.flying = false;
    tenths(1);
    mutable_vehicle.estimate.flying = true;
    mutable_vehicle.estimate.height_m = 10;
    tenths(1);
    EXPECT_EQ(fenceReport().breach, +Breach::none) << "it takes off again";
}

TEST_F(Fence, has_no_height_limits_when_minimum_and_maximum_are_equal) {
    parameters.fence_min_m = parameters.fence_max_m = 100;
    raise();
    mutable_vehicle.estimate.height_m = 3000;
    tenths(2);
    EXPECT_EQ(fenceReport().breach, +Breach::none);
}

TEST_F(Fence, does_nothing_to_an_airplane_on_the_ground) {
    raise();
    mutable_vehicle.estimate.flying = false;
    leave();
    EXPECT_EQ(vehicle.mode, Mode::loiter);
    EXPECT_EQ(fenceReport().breach, +Breach::none);
}

TEST_F(Fence, with_its_return_point_outside_is_not_valid) {
    ASSERT_EQ(store(MavMissionType::fence, square(beside(kSide_e7 + 9, 0))),
              MissionResult::accepted);
    tenths(5);
    EXPECT_EQ(fenceLine(), Line::unfit);
    EXPECT_TRUE(hasStatusText("Fence: return point is outside"));
    EXPECT_FALSE(fenceEnable(1));
    EXPECT_FALSE(fenceBad());
    parameters.fence_auto_enable = 1;
    EXPECT_TRUE(fenceBad());
}

TEST_F(Fence, stands_against_arming_when_it_is_on_or_its_switch_is_and_it_is_not_fit) {
    raise();
    EXPECT_FALSE(fenceBad());
    ASSERT_EQ(store(MavMissionType::fence, square(beside(kSide_e7 + 9, 0))),
              MissionResult::accepted);
    tenths(5);
    ASSERT_EQ(fenceLine(), Line::unfit);
    EXPECT_TRUE(fenceBad()) << "it is on";
    ASSERT_TRUE(fenceEnable(0));
    EXPECT_FALSE(fenceBad());
    parameters.fence_channel = 7;
    moveSwitch(1900);
    EXPECT_TRUE(fenceBad()) << "its switch is";
}

TEST_F(Fence, without_its_floor_is_on_or_off_as_before) {
    parameters.fence_min_m = 30;
    parameters.fence_max_m = 120;
    raise();
    ASSERT_TRUE(fenceEnable(2));
    EXPECT_TRUE(fenceOn());
    for (const float height_m : {50.0f, 20.0f}) {
        mutable_vehicle.estimate.height_m = height_m;
        tenths(1);
        EXPECT_EQ(fenceReport().breach, +Breach::none) << height_m;
    }
    fenceEnable(0);
    ASSERT_TRUE(fenceEnable(2));
    EXPECT_FALSE(fenceOn());
}

TEST_F(Fence, has_not_turned_back_before_its_return_point_is_read) {
    raise();
    fakes::setEepromSlow(true);
    const uint8_t other = 1;
    ASSERT_EQ(hal::eepromWrite(100, &other, 1), core::Status::ok);
    EXPECT_FALSE(fenceTurnBack());
    EXPECT_NE(vehicle.mode, Mode::guided);
    fakes::advance_ms(100);
    EXPECT_TRUE(fenceTurnBack());
    EXPECT_EQ(vehicle.mode, Mode::guided);
}

TEST_F(Fence, follows_its_channel_when_that_moves) {
    raise();
    parameters.fence_channel = 7;
    moveSwitch(1760);
    EXPECT_TRUE(fenceOn());
    fenceEnable(0);
    tenths(5);
    EXPECT_FALSE(fenceOn());  // by command, and the switch has not moved
    moveSwitch(1100);
    moveSwitch(1900);
    EXPECT_TRUE(fenceOn());
    moveSwitch(1100);
    EXPECT_FALSE(fenceOn());
}

TEST_F(Fence, stays_on_when_the_receiver_is_lost_and_when_its_channel_is_taken_away) {
    raise();
    fenceEnable(0);
    parameters.fence_channel = 7;
    moveSwitch(1900);
    ASSERT_TRUE(fenceOn());
    mutable_vehicle.radio.lost = true;
    tenths(2);
    EXPECT_TRUE(fenceOn());
    mutable_vehicle.radio.lost = false;
    parameters.fence_channel = 0;
    tenths(2);
    EXPECT_TRUE(fenceOn());
}

TEST_F(Fence, leaves_a_flight_alone_whose_take_off_or_landing_is_none_of_AUTO) {
    const auto flown = [](Mode mode, Path path) {
        mutable_vehicle.mode = mode;
        mutable_vehicle.demand.path = path;
        tenths(1);
    };
    raise();
    flown(Mode::automatic, Path::land);
    EXPECT_TRUE(fenceOn()) << "FENCE_AUTOENABLE is 0";
    fenceEnable(0);
    flown(Mode::automatic, Path::takeoff);
    flown(Mode::automatic, Path::leg);
    EXPECT_FALSE(fenceOn());
    parameters.fence_auto_enable = 1;
    flown(Mode::takeoff, Path::takeoff);
    flown(Mode::automatic, Path::leg);
    EXPECT_FALSE(fenceOn());
    fenceEnable(1);
    flown(Mode::loiter, Path::land);
    EXPECT_TRUE(fenceOn());
}

TEST_F(Fence, switches_itself_on_after_the_take_off_and_off_before_the_landing) {
    raise();
    fenceEnable(0);
    parameters.fence_auto_enable = 1;
    mutable_vehicle.mode = Mode::automatic;
    mutable_vehicle.demand.path = Path::takeoff;
    tenths(3);
    EXPECT_FALSE(fenceOn());
    mutable_vehicle.demand.path = Path::leg;
    tenths(1);
    EXPECT_TRUE(fenceOn());
    mutable_vehicle.demand.path = Path::land;
    tenths(1);
    EXPECT_FALSE(fenceOn());
}

TEST_F(Fence, a_new_fence_is_used_while_the_airplane_is_flown_back_by_the_old_one) {
    raise();
    requestMode(Mode::fbwa, ModeReason::pilot);
    leave();
    ASSERT_EQ(vehicle.mode, Mode::guided);
    Items wider = square();
    for (MissionItem& item : wider)
        if (item.x > kHome.latitude_e7 + 1000) item.x += 50000;
    ASSERT_EQ(store(MavMissionType::fence, wider), MissionResult::accepted);
    tenths(5);
    EXPECT_EQ(fenceReport().breach, +Breach::none);
    EXPECT_EQ(vehicle.mode, Mode::guided);
}

TEST_F(Fence, with_nineteen_corners_is_watched) {
    Items items = {point(MavCmd::nav_fence_return_point, kHome)};
    for (int i = 0; i < 19; ++i)
        items.push_back(point(MavCmd::nav_fence_polygon_vertex_inclusion,
                              beside(static_cast<int32_t>(40000 * std::cos(i * M_PI / 9.5)),
                                     static_cast<int32_t>(40000 * std::sin(i * M_PI / 9.5))),
                              19));
    raise(items);
    goTo(beside(0, 39000));
    EXPECT_EQ(fenceReport().breach, +Breach::none);
    goTo(beside(0, 40001));
    EXPECT_EQ(fenceReport().breach, +Breach::boundary);
}

}  // namespace
}  // namespace firmware
