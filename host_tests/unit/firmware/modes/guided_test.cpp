// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/modes/guided.hpp"

#include <cmath>

#include "firmware/actuators/outputs.hpp"
#include "firmware/actuators/relay.hpp"
#include "firmware/guidance/guidance.hpp"
#include "firmware/mission/speed.hpp"
#include "firmware_bench.hpp"
#include "host_tests/support/fakes/vehicle.hpp"

namespace {

using firmware::mission::missionAct;
using firmware::mission::MissionItem;
using firmware::mission::MissionResult;
using firmware::state::Mode;
using firmware::state::mutable_vehicle;
using firmware::state::parameters;
using firmware::state::Path;
using firmware::state::vehicle;

constexpr geo::Position kHome = {470000000, 80000000};
constexpr geo::Position kThere = {470030000, 80050000};
constexpr uint8_t kGlobal = 0, kRelative = 3, kTerrain = 10;

MissionResult orderTo(MissionItem item) { return firmware::modes::guideTo(item); }
MissionResult orderHeight(MissionItem item) { return firmware::modes::guideToHeight(item); }

class Guided : public bench::Bench {
protected:
    void SetUp() override {
        Bench::SetUp();
        mutable_vehicle.home.position = mutable_vehicle.estimate.position = kHome;
        mutable_vehicle.home.altitude_cm = 40000;
        fly(Mode::fbwa);
    }
    static MissionItem to(const geo::Position& place, float z, uint8_t frame = kRelative) {
        return {16, frame, 0, 0, 0, 0, place.latitude_e7, place.longitude_e7, z};
    }
    static void expectUnchanged(const MissionItem& target, MissionResult answer) {
        const auto before = vehicle.demand;
        EXPECT_EQ(orderTo(target), answer);
        EXPECT_EQ(vehicle.mode, Mode::fbwa);
        EXPECT_EQ(memcmp(&before, &vehicle.demand, sizeof before), 0);
    }
};

TEST_F(Guided, chosen_without_a_target_circles_where_it_is) {
    ASSERT_TRUE(firmware::modes::requestMode(Mode::guided, firmware::modes::ModeReason::pilot));
    EXPECT_EQ(vehicle.demand.path, Path::circle);
    EXPECT_EQ(vehicle.demand.to, kHome);
    EXPECT_FLOAT_EQ(vehicle.demand.height_m, 80);
    EXPECT_TRUE(firmware::state::guidesItself());
    EXPECT_TRUE(firmware::state::autoThrottle());
}

TEST_F(Guided, is_not_entered_without_a_position) {
    mutable_vehicle.estimate.known = false;
    EXPECT_FALSE(firmware::modes::requestMode(Mode::guided, firmware::modes::ModeReason::ground));
    EXPECT_EQ(orderTo(to(kThere, 100)), MissionResult::error);
    EXPECT_EQ(vehicle.mode, Mode::fbwa);
}

TEST_F(Guided, flies_to_the_place_and_height_that_are_given) {
    EXPECT_EQ(orderTo(to(kThere, 100)), MissionResult::accepted);
    EXPECT_EQ(vehicle.mode, Mode::guided);
    EXPECT_EQ(vehicle.demand.path, Path::circle);
    EXPECT_EQ(vehicle.demand.to, kThere);
    EXPECT_FLOAT_EQ(vehicle.demand.height_m, 100);
    EXPECT_TRUE(vehicle.demand.new_path);
    EXPECT_EQ(orderTo(to(kHome, 520, kGlobal)), MissionResult::accepted);
    EXPECT_EQ(vehicle.demand.to, kHome);
    EXPECT_FLOAT_EQ(vehicle.demand.height_m, 120);
}

TEST_F(Guided, flies_along_a_course_at_the_height_and_speed_that_are_flown) {
    EXPECT_FALSE(firmware::modes::guideAlong(0)) << "in another mode";
    ASSERT_EQ(orderTo(to(kThere, 100)), MissionResult::accepted);
    const float airspeed_mps = vehicle.demand.airspeed_mps;
    for (const float course_deg : {0.0f, 45.0f, 135.0f, 270.0f}) {
        EXPECT_TRUE(firmware::modes::guideAlong(core::radians(course_deg)));
        const auto& demand = vehicle.demand;
        EXPECT_EQ(demand.path, Path::leg);
        EXPECT_EQ(demand.from, vehicle.estimate.position);
        EXPECT_NEAR(geo::bearing_cd(demand.from, demand.to) * 0.01, course_deg, 0.2);
        EXPECT_GT(geo::distance_m(demand.from, demand.to), 20000);
        EXPECT_FLOAT_EQ(demand.height_m, 100);
        EXPECT_FALSE(demand.sloped);
        EXPECT_FLOAT_EQ(demand.airspeed_mps, airspeed_mps);
    }
    ASSERT_EQ(orderTo(to(kThere, 90)), MissionResult::accepted);
    EXPECT_EQ(vehicle.demand.path, Path::circle);
    mutable_vehicle.estimate.known = false;
    EXPECT_FALSE(firmware::modes::guideAlong(0)) << "without a position";
}

TEST_F(Guided, keeps_its_target_when_the_mode_is_set_again) {
    ASSERT_EQ(orderTo(to(kThere, 100)), MissionResult::accepted);
    ASSERT_TRUE(firmware::modes::requestMode(Mode::guided, firmware::modes::ModeReason::ground));
    EXPECT_EQ(vehicle.demand.to, kThere);
}

TEST_F(Guided, circles_with_the_parameters_radius_unless_one_is_given) {
    parameters.loiter_radius_m = -75;
    ASSERT_EQ(orderTo(to(kThere, 100)), MissionResult::accepted);
    EXPECT_FLOAT_EQ(vehicle.demand.radius_m, 75);
    EXPECT_TRUE(vehicle.demand.counter_clockwise);
    MissionItem target = to(kThere, 100);
    target.param3 = 120;
    ASSERT_EQ(orderTo(target), MissionResult::accepted);
    EXPECT_FLOAT_EQ(vehicle.demand.radius_m, 120);
    EXPECT_FALSE(vehicle.demand.counter_clockwise);
    target.param4 = 1;
    ASSERT_EQ(orderTo(target), MissionResult::accepted);
    EXPECT_TRUE(vehicle.demand.counter_clockwise);
    target.param3 = NAN;
    ASSERT_EQ(orderTo(target), MissionResult::accepted);
    EXPECT_FLOAT_EQ(vehicle.demand.radius_m, 75);
}

TEST_F(Guided, leaves_unset_fields_unchanged) {
    ASSERT_EQ(orderTo(to(kThere, 100)), MissionResult::accepted);
    ASSERT_EQ(orderTo(to({INT32_MAX, INT32_MAX}, NAN, kGlobal)), MissionResult::accepted);
    EXPECT_EQ(vehicle.demand.to, kThere) << "its place was not given";
    EXPECT_FLOAT_EQ(vehicle.demand.height_m, 100) << "nor its height";
    ASSERT_EQ(orderTo(to({INT32_MAX, INT32_MAX}, 130)), MissionResult::accepted);
    EXPECT_EQ(vehicle.demand.to, kThere);
    EXPECT_FLOAT_EQ(vehicle.demand.height_m, 130);
    ASSERT_EQ(orderTo(to({0, 0}, 140)), MissionResult::accepted);
    EXPECT_EQ(vehicle.demand.to, kHome) << "0, 0 is here, as in a mission";
}

TEST_F(Guided, without_fields_in_another_mode_circles_here_at_this_height) {
    mutable_vehicle.demand.to = kThere;
    mutable_vehicle.demand.height_m = 10;
    ASSERT_EQ(orderTo(to({INT32_MAX, INT32_MAX}, NAN)), MissionResult::accepted);
    EXPECT_EQ(vehicle.demand.to, kHome);
    EXPECT_FLOAT_EQ(vehicle.demand.height_m, 80);
}

TEST_F(Guided, refuses_what_it_cannot_fly_to_and_flies_on_as_before) {
    expectUnchanged(to(kThere, 100, kTerrain), MissionResult::unsupported_frame);
    expectUnchanged(to(kThere, 100, 1), MissionResult::unsupported_frame);
    expectUnchanged(to({910000000, 0}, 100), static_cast<MissionResult>(10));
    expectUnchanged(to({INT32_MIN, INT32_MIN}, 100), static_cast<MissionResult>(10));
    expectUnchanged(to({470000000, 1810000000}, 100), static_cast<MissionResult>(11));
    expectUnchanged(to({470000000, INT32_MAX}, 100), static_cast<MissionResult>(11));
    expectUnchanged(to(kThere, INFINITY), static_cast<MissionResult>(12));
    expectUnchanged(to(kThere, 1e6f), static_cast<MissionResult>(12));
    MissionItem other = to(kThere, 100);
    other.param3 = -60;
    expectUnchanged(other, static_cast<MissionResult>(8));
    other = to(kThere, 100);
    other.command = 21;
    expectUnchanged(other, MissionResult::unsupported);
    mutable_vehicle.home.set = false;
    expectUnchanged(to(kThere, 100), MissionResult::error);
}

TEST_F(Guided, changes_the_height_alone_in_whatever_mode_holds_one) {
    EXPECT_EQ(orderHeight(to(kThere, 90)), MissionResult::error) << "the pilot flies";
    for (const Mode mode : {Mode::loiter, Mode::rtl, Mode::circle, Mode::guided}) {
        ASSERT_TRUE(firmware::modes::requestMode(mode, firmware::modes::ModeReason::ground));
        const geo::Position before = vehicle.demand.to;
        EXPECT_EQ(orderHeight(to(kThere, 490, kGlobal)), MissionResult::accepted);
        EXPECT_FLOAT_EQ(vehicle.demand.height_m, 90);
        EXPECT_EQ(vehicle.demand.to, before);
        EXPECT_EQ(vehicle.mode, mode);
    }
    EXPECT_EQ(orderHeight(to(kThere, 90, kTerrain)), MissionResult::unsupported_frame);
    mutable_vehicle.mode = Mode::automatic;
    EXPECT_EQ(orderHeight(to(kThere, 90)), MissionResult::error) << "the mission's heights count";
}

TEST_F(Guided, flies_at_the_commanded_speed_to_the_next_target_as_well) {
    ASSERT_EQ(orderTo(to(kThere, 100)), MissionResult::accepted);
    EXPECT_FLOAT_EQ(vehicle.demand.airspeed_mps, parameters.cruise_speed_cms * 0.01f);
    EXPECT_EQ(missionAct({178, 2, 0, 16, -1, 0, 0, 0, 0}), MissionResult::accepted);
    EXPECT_FLOAT_EQ(vehicle.demand.airspeed_mps, 16);
    ASSERT_EQ(orderTo(to(kHome, 100)), MissionResult::accepted);
    EXPECT_FLOAT_EQ(vehicle.demand.airspeed_mps, 16);
    for (const float speed_mps : {3.0f, 40.0f, -3.0f})
        EXPECT_EQ(missionAct({178, 2, 0, speed_mps, -1, 0, 0, 0, 0}),
                  static_cast<MissionResult>(7));
    EXPECT_FLOAT_EQ(vehicle.demand.airspeed_mps, 16);
}

TEST_F(Guided, an_action_commanded_from_the_ground_is_done_as_in_a_mission) {
    firmware::actuators::runOutputs();
    EXPECT_EQ(missionAct({183, 2, 6, 1700, 0, 0, 0, 0, 0}), MissionResult::accepted);
    firmware::actuators::runOutputs();
    EXPECT_EQ(firmware::actuators::outputPulse_us(6), 1700);
    EXPECT_EQ(missionAct({183, 2, 3, 1700, 0, 0, 0, 0, 0}), static_cast<MissionResult>(6));
    EXPECT_EQ(missionAct({181, 2, 0, 1, 0, 0, 0, 0, 0}), MissionResult::accepted);
    EXPECT_TRUE(firmware::actuators::relayGet());
    EXPECT_EQ(missionAct({16, 3, 0, 0, 0, 0, 1, 1, 50}), MissionResult::unsupported);
    EXPECT_EQ(missionAct({177, 2, 0, 1, 0, 0, 0, 0, 0}), static_cast<MissionResult>(6));
    EXPECT_EQ(missionAct({208, 2, 2, 0, 0, 0, 0, 0, 0}), MissionResult::unsupported);
}

TEST_F(Guided, is_left_for_home_by_a_long_failsafe_only_if_the_pilot_wants_that) {
    ASSERT_EQ(orderTo(to(kThere, 100)), MissionResult::accepted);
    settle(bench::kCentred);
    loseRadio(12000);
    EXPECT_TRUE(vehicle.failsafe_long);
    EXPECT_EQ(vehicle.mode, Mode::guided);
    EXPECT_EQ(vehicle.demand.to, kThere);
    settle(bench::kCentred);
    for (int i = 0; i < 3; ++i) firmware::safety::runFailsafe();
    parameters.long_action = 1;
    loseRadio(12000);
    EXPECT_EQ(vehicle.mode, Mode::rtl);
}

TEST_F(Guided, comes_down_on_a_slope_that_ends_at_the_circle_and_climbs_at_once) {
    const auto planned_m = [] {
        firmware::modes::runMode();
        firmware::guidance::runGuidance();
        return vehicle.progress.height_error_m + vehicle.estimate.height_m;
    };
    mutable_vehicle.attitude.cos_roll = mutable_vehicle.attitude.cos_pitch = core::Ratio(1);
    const geo::Position there = geo::moved(kHome, {1060, 0});
    ASSERT_EQ(orderTo(to(there, 30)), MissionResult::accepted);
    EXPECT_NEAR(planned_m(), 80, 0.1);
    mutable_vehicle.estimate.position = geo::moved(kHome, {500, 0});
    EXPECT_NEAR(planned_m(), 55, 0.5);
    EXPECT_EQ(orderHeight(to(there, 50)), MissionResult::accepted);
    EXPECT_NEAR(planned_m(), 50, 0.01) << "a height alone is flown at once";

    ASSERT_EQ(orderTo(to(there, 130)), MissionResult::accepted);
    EXPECT_NEAR(planned_m(), 130, 0.01);

    ASSERT_EQ(orderTo(to(kThere, 60)), MissionResult::accepted);
    EXPECT_NEAR(planned_m(), 80, 0.1);
    parameters.glide_slope_min_m = 25;
    ASSERT_EQ(orderTo(to(kThere, 60)), MissionResult::accepted);
    EXPECT_NEAR(planned_m(), 60, 0.01) << "not worth a slope";
}

}  // namespace
