// SPDX-License-Identifier: GPL-3.0-or-later
// Landings that RTL goes to, and going around.
#include "core/maths.hpp"
#include "firmware/guidance/guidance.hpp"
#include "firmware/mission/handlers.hpp"
#include "host_tests/support/fakes/vehicle.hpp"
#include "mission_flight.hpp"

namespace firmware {
using namespace guidance;
using namespace mission;
namespace {

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
        requestMode(Mode::rtl, ModeReason::pilot);
        flyRtl();
        EXPECT_EQ(vehicle.mode, Mode::automatic);
        EXPECT_EQ(missionCurrent(), north == 0 ? 6 : 3);
        EXPECT_EQ(vehicle.demand.from, vehicle.estimate.position);
        requestMode(Mode::loiter, ModeReason::pilot);
    }
    parameters.rtl_landing = 1;
    requestMode(Mode::rtl, ModeReason::pilot);
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
    requestMode(Mode::rtl, ModeReason::pilot);
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
    requestMode(Mode::loiter, ModeReason::pilot);
    moveTo(waypoint(1400));
    EXPECT_TRUE(missionLand());
    pass(3);
    EXPECT_EQ(missionCurrent(), 3);
}

TEST_F(Landings, without_a_landing_start_rtl_stays_rtl_and_reports_it) {
    ASSERT_EQ(upload({waypoint(500), placed(21, 0, 0, 0)}), MissionResult::accepted);
    parameters.rtl_landing = 2;
    requestMode(Mode::rtl, ModeReason::pilot);
    (void)statusTexts();
    flyRtl();
    EXPECT_EQ(vehicle.mode, Mode::rtl);
    EXPECT_TRUE(hasStatusText("RTL: the mission has no DO_LAND_START"));
    flyRtl();
    EXPECT_FALSE(hasStatusText("DO_LAND_START")) << "once";
    EXPECT_FALSE(missionLand());
}

TEST_F(Landings, another_mode_ends_the_search) {
    ASSERT_EQ(upload(landings()), MissionResult::accepted);
    EXPECT_TRUE(missionLand());
    requestMode(Mode::fbwa, ModeReason::pilot);
    seconds(3);
    EXPECT_EQ(vehicle.mode, Mode::fbwa);
}

TEST_F(Landings, do_land_start_does_nothing_when_the_mission_reaches_it) {
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

TEST_F(Landings, raising_the_throttle_aborts_a_landing_but_a_stick_left_there_does_not) {
    mutable_vehicle.radio.throttle_pct = 100;
    fly(landings());
    reach();
    reach();
    seconds(2);
    ASSERT_EQ(vehicle.demand.path, Path::land);
    mutable_vehicle.radio.throttle_pct = 60;
    seconds(1);
    EXPECT_EQ(vehicle.demand.path, Path::land) << "a nudge";
    (void)statusTexts();
    mutable_vehicle.estimate.height_m = 8;
    mutable_vehicle.radio.throttle_pct = 95;
    seconds(1);
    EXPECT_EQ(vehicle.demand.path, Path::leg);
    EXPECT_FLOAT_EQ(vehicle.demand.height_m, 30);
    EXPECT_TRUE(hasStatusText("Landing broken off by the throttle"));
}

TEST_F(Landings, a_receiver_that_returns_with_full_throttle_aborts_no_landing) {
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

TEST_F(Landings, nothing_is_aborted_that_is_no_landing_or_is_over) {
    fly(landings());
    EXPECT_FALSE(missionGoAround(50)) << "a waypoint";
    reach();
    reach();
    mutable_vehicle.estimate.flying = false;
    EXPECT_FALSE(missionGoAround(50)) << "down";
    mutable_vehicle.estimate.flying = true;
    requestMode(Mode::loiter, ModeReason::pilot);
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

}  // namespace
}  // namespace firmware
