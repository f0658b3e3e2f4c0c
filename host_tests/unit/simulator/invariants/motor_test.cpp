// SPDX-License-Identifier: GPL-3.0-or-later
#include "host_tests/unit/simulator/invariants/flown.hpp"

namespace simulator::invariants {

using mavlink::MavCmd;

TEST(MotorIdleWhenDisarmed, a_pulse_while_disarmed_violates_it) {
    Flown flown;
    flown.run(5);
    flown.now.servo_us[2] = 1300;
    flown.run(0.1);
    flown.now.servo_us[2] = 1100;
    flown.run(2);
    EXPECT_EQ(flown.violated(), "motor_idle_disarmed ");
}

TEST(MotorIdleWhenDisarmed, armed_for_a_moment_between_two_heartbeats_is_allowed) {
    Flown flown;
    flown.run(5.1);
    flown.command(MavCmd::component_arm_disarm, 1);
    flown.now.servo_us[2] = 1300;
    flown.run(0.1);
    flown.now.servo_us[2] = 1100;
    flown.run(2);
    EXPECT_EQ(flown.violated(), "");
}

TEST(MotorIdleWhenDisarmed, the_idle_pulse_is_the_one_at_the_start) {
    Flown low;
    low.now.servo_us[2] = 1000;
    low.run(5);
    low.now.servo_us[2] = 1010;
    low.run(2);
    EXPECT_EQ(low.violated(), "motor_idle_disarmed ");
    Flown high;  // that no controller takes for off
    high.now.servo_us[2] = 1150;
    high.run(5);
    EXPECT_EQ(high.violated(), "motor_idle_disarmed ");
}

TEST(MotorIdleWhenDisarmed, a_closed_end_set_while_disarmed_counts_from_the_next_arming) {
    Flown never;
    never.run(5);
    never.parameter("RC3_MIN", 1200);
    never.now.servo_us[2] = 1200;
    never.run(3);
    EXPECT_EQ(never.violated(), "motor_idle_disarmed ");
    Flown armed;
    armed.run(5);
    armed.parameter("RC3_MIN", 1200);
    armed.arm();
    armed.run(1.5);
    armed.now.servo_us[2] = 1200;
    armed.armed = false;
    armed.run(3);
    EXPECT_EQ(armed.violated(), "");
}

Flown standsArmedIn(uint32_t mode) {
    Flown flown;
    flown.mode = mode;
    flown.run(5);
    flown.arm();
    flown.run(10);
    flown.now.servo_us[2] = 1600;
    return flown;
}

TEST(MotorIdleOnTheGround, a_motor_that_nobody_asked_for_violates_it) {
    Flown flown = standsArmedIn(12);  // LOITER
    flown.run(4);
    EXPECT_EQ(flown.violated(), "motor_idle_standing ");
}

TEST(MotorIdleOnTheGround, the_mission_and_the_pilot_may_ask_for_it) {
    Flown mission = standsArmedIn(10);
    mission.run(4);
    EXPECT_EQ(mission.violated(), "");
    Flown pilot = standsArmedIn(5);
    pilot.now.stick_us[2] = 1600;
    pilot.run(4);
    EXPECT_EQ(pilot.violated(), "");
}

TEST(MotorIdleOnTheGround, a_closed_stick_asks_for_nothing) {
    Flown flown = standsArmedIn(5);
    flown.run(7);
    EXPECT_EQ(flown.violated(), "motor_idle_standing ");
}

TEST(MotorIdleOnTheGround, a_stick_counts_only_in_a_mode_that_obeys_it) {
    Flown flown = standsArmedIn(7);  // CRUISE waits for the flight
    flown.now.stick_us[2] = 1600;
    flown.run(4);
    EXPECT_EQ(flown.violated(), "motor_idle_standing ");
}

TEST(MotorIdleOnTheGround, it_is_not_seen_to_stand_while_receiver_and_barometer_both_fail) {
    for (const bool both : {true, false}) {
        Flown flown = standsArmedIn(12);
        flown.now.faulty[static_cast<size_t>(Faulty::gps)] = true;
        flown.now.faulty[static_cast<size_t>(Faulty::barometer)] = both;
        flown.run(20);
        EXPECT_EQ(flown.violated().empty(), both);
    }
}

TEST(MotorIdleOnTheGround, it_is_seen_to_stand_once_one_of_both_has_been_back_for_seconds) {
    Flown flown = standsArmedIn(12);
    flown.now.faulty[static_cast<size_t>(Faulty::gps)] = true;
    flown.now.faulty[static_cast<size_t>(Faulty::barometer)] = true;
    flown.run(20);
    flown.now.faulty[static_cast<size_t>(Faulty::gps)] = false;
    flown.run(13);
    EXPECT_EQ(flown.violated(), "");
    flown.run(1);
    EXPECT_EQ(flown.violated(), "motor_idle_standing ");
}

TEST(MotorIdleOnTheGround, after_a_restart_a_wrong_accelerometer_seems_to_climb_for_seconds) {
    for (const float scale : {1.0f, 1.15f}) {
        Flown flown = standsArmedIn(12);
        flown.parameter("INS_ACCSCAL_Z", scale);
        flown.restart();
        flown.run(7);
        EXPECT_EQ(flown.violated().find("motor_idle_standing") == std::string::npos, scale > 1);
        flown.run(5);
        EXPECT_NE(flown.violated().find("motor_idle_standing"), std::string::npos);
    }
}

}  // namespace simulator::invariants
