// SPDX-License-Identifier: GPL-3.0-or-later
// Where AUTO begins in another flight: a disarm on the ground ends the progress of a mission.
#include "mission_flight.hpp"

#include "firmware/safety/restart.hpp"
#include "firmware/safety/restart_records.hpp"

namespace firmware {
using namespace mission;
namespace {

class NewFlight : public MissionFlight {
protected:
    // To item 2, and by hand to the ground.
    void flyAndLandByHand() {
        fly({takeoff(), waypoint(500), waypoint(900)});
        mutable_vehicle.estimate.height_m = 50;
        pass();
        ASSERT_EQ(missionCurrent(), 2);
        requestMode(Mode::manual, ModeReason::pilot);
        mutable_vehicle.estimate.flying = false;
        mutable_vehicle.estimate.height_m = 0;
        pass();
    }
    static void arm(bool armed) {
        mutable_vehicle.armed = armed;
        pass();
    }
    static void powerOff() {
        fakes::restartEeprom();
        mission_engine.leave();
        mutable_vehicle.armed = false;
        fakes::watchdog().last_run.ended = hal::ResetCause::power_on;
        missionBoot();
        requestMode(Mode::manual, ModeReason::boot);
        (void)statusTexts();
    }
};

TEST_F(NewFlight, begins_at_the_first_nav_after_a_disarm) {
    flyAndLandByHand();
    arm(false);
    (void)statusTexts();
    arm(true);
    EXPECT_TRUE(hasStatusText("AUTO begins at item 1"));
    enterAuto();
    EXPECT_EQ(missionCurrent(), 1);
}

TEST_F(NewFlight, begins_at_the_first_nav_after_the_battery_was_changed) {
    flyAndLandByHand();
    powerOff();
    arm(true);
    EXPECT_TRUE(hasStatusText("AUTO begins at item 1"));
    mutable_vehicle.estimate.flying = true;  // taken off by hand
    pass();
    enterAuto();
    EXPECT_EQ(missionCurrent(), 1);
}

TEST_F(NewFlight, begins_at_the_first_nav_where_auto_is_entered_before_arming) {
    flyAndLandByHand();
    powerOff();
    enterAuto();
    EXPECT_EQ(missionCurrent(), 1);
    arm(true);
    EXPECT_EQ(missionCurrent(), 1);
}

TEST_F(NewFlight, leaves_no_index_behind_for_a_restart_in_the_air) {
    flyAndLandByHand();
    arm(false);
    arm(true);
    pass(10);
    powerOff();
    mutable_vehicle.estimate.flying = mutable_vehicle.armed = true;
    pass();
    EXPECT_EQ(missionCurrent(), 0);
}

TEST_F(NewFlight, begins_where_the_ground_said_after_the_disarm) {
    flyAndLandByHand();
    EXPECT_TRUE(missionSetCurrent(2));
    arm(false);
    EXPECT_EQ(missionCurrent(), 0) << "what was chosen for the flight before";
    EXPECT_TRUE(missionSetCurrent(3));
    (void)statusTexts();
    arm(true);
    EXPECT_TRUE(hasStatusText("AUTO begins at item 3"));
    enterAuto();
    EXPECT_EQ(missionCurrent(), 3);
}

TEST_F(NewFlight, goes_on_after_a_disarm_in_the_air) {
    flyAndLandByHand();
    mutable_vehicle.estimate.flying = true;
    arm(false);
    arm(true);
    enterAuto();
    EXPECT_EQ(missionCurrent(), 2);
}

TEST_F(NewFlight, in_auto_begins_at_the_first_nav_too) {
    flyAndLandByHand();
    enterAuto();
    ASSERT_EQ(missionCurrent(), 2);
    arm(false);
    EXPECT_EQ(missionCurrent(), 1) << "not on to a waypoint from the ground";
    EXPECT_TRUE(missionSetCurrent(3));
    pass();
    arm(true);
    EXPECT_EQ(missionCurrent(), 3) << "but where the ground says";
}

// A run that goes on with a flight, as long as this lives.
struct ResumesFlight {
    ResumesFlight() {
        safety::nextFastRecord().in_the_air = true;
        safety::finishFastRecord();
        updateChecksum(safety::records.slow);
        begin(hal::ResetCause::watchdog);
    }
    ~ResumesFlight() { begin(hal::ResetCause::asked); }

private:
    static void begin(hal::ResetCause cause) {
        fakes::watchdog().last_run.ended = cause;
        safety::restartBegin();
    }
};

TEST_F(NewFlight, is_none_when_it_is_armed_again_after_a_restart_in_the_air) {
    flyAndLandByHand();
    const ResumesFlight resumes;
    missionBoot();
    requestMode(Mode::loiter, ModeReason::restart);
    arm(false);
    (void)statusTexts();
    arm(true);  // before it is known to fly
    EXPECT_EQ(missionCurrent(), 2);
    EXPECT_FALSE(hasStatusText("AUTO begins"));
}

TEST_F(NewFlight, begins_at_the_first_nav_also_when_the_last_one_went_on_after_a_restart) {
    const ResumesFlight resumes;
    flyAndLandByHand();
    arm(false);
    (void)statusTexts();
    arm(true);
    EXPECT_TRUE(hasStatusText("AUTO begins at item 1"));
    enterAuto();
    EXPECT_EQ(missionCurrent(), 1);
}

TEST_F(NewFlight, of_the_same_mission_follows_a_landing_in_auto_and_is_over_when_auto_is_left) {
    fly({placed(21, 900, 0, 0), takeoff(), waypoint(900)});
    mutable_vehicle.estimate.flying = false;
    mutable_vehicle.estimate.height_m = 0;
    arm(false);
    pass();
    ASSERT_EQ(missionCurrent(), 2);
    arm(true);
    EXPECT_EQ(missionCurrent(), 2) << "the TAKEOFF has waited for it";
    arm(false);
    requestMode(Mode::manual, ModeReason::pilot);
    enterAuto();
    EXPECT_EQ(missionCurrent(), 1);
}

TEST_F(NewFlight, of_a_mission_without_a_nav_says_nothing) {
    ASSERT_EQ(upload({command(181, 0, 1)}), MissionResult::accepted);
    mutable_vehicle.armed = false;
    pass();
    (void)statusTexts();
    arm(true);
    EXPECT_FALSE(hasStatusText("AUTO begins"));
}

}  // namespace
}  // namespace firmware
