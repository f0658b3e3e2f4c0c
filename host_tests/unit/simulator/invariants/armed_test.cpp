// SPDX-License-Identifier: GPL-3.0-or-later
#include "host_tests/unit/simulator/invariants/flown.hpp"

namespace simulator::invariants {

using mavlink::MavCmd;

// With the surfaces in motion, as in the air.
void flyFor(Flown& flown, double seconds) {
    for (double s = 0; s < seconds - 0.005; s += 0.05) {
        flown.now.servo_us[0] = flown.now.servo_us[0] > 1500 ? 1490 : 1510;
        flown.run(0.05);
    }
}

Flown flying() {
    Flown flown;
    flown.run(2);
    flown.inTheAir();
    flyFor(flown, 10);
    return flown;
}

TEST(ArmedByACommand, arming_without_a_command_violates_it) {
    for (const bool ordered : {true, false}) {
        Flown flown;
        flown.run(5);
        if (ordered) flown.command(MavCmd::component_arm_disarm, 1);
        flown.armed = true;
        flown.run(2);
        EXPECT_EQ(flown.violated(), ordered ? "" : "armed_by_itself ");
    }
}

TEST(ArmedByACommand, a_restart_on_the_ground_does_not_arm) {
    Flown flown;
    flown.run(5);
    flown.watch.provokedRestart(true);
    flown.restart();
    flown.armed = true;
    flown.run(2);
    EXPECT_EQ(flown.violated(), "armed_by_itself ");
}

TEST(ArmedByACommand, one_disarmed_heartbeat_after_a_restart_in_the_air_is_allowed) {
    Flown flown = flying();
    flown.watch.provokedRestart(true);
    flown.restart();
    flown.armed = false;
    flyFor(flown, 1);
    flown.armed = true;
    flyFor(flown, 5);
    EXPECT_EQ(flown.violated(), "");
}

TEST(ArmedByACommand, a_receiver_that_starts_late_may_arm_what_moves_as_fast_as_one_flies) {
    for (const bool moves : {true, false}) {
        Flown flown = flying();
        flown.watch.provokedRestart(true);
        flown.restart();
        flown.armed = false;
        flown.now.truth.velocity_north_mps = moves ? 12 : 1;
        flown.now.truth.velocity_east_mps = 0;
        flown.run(10);
        flown.armed = true;
        flown.run(3);
        const bool violated = flown.violated().find("armed_by_itself") != std::string::npos;
        EXPECT_EQ(violated, !moves);
    }
}

// The fix was as fast; by the heartbeat it has hit the ground.
TEST(ArmedByACommand, what_has_just_moved_as_fast_as_one_flies_may_be_armed_and_nothing_later) {
    for (const double stands_s : {1.0, 2.0}) {
        Flown flown;
        flown.inTheAir();
        flown.run(10);
        ++flown.now.restarts;
        flown.armed = false;
        flown.run(6);
        flown.onTheGround();
        flown.run(stands_s - 0.01);
        flown.armed = true;
        flown.run(1);
        EXPECT_EQ(flown.violated().find("armed_by_itself") != std::string::npos, stands_s > 1.5);
    }
}

TEST(ArmedByACommand, the_rudder_stick_may_arm) {
    Flown flown;
    flown.run(5);
    flown.now.stick_us[3] = 1900;
    flown.run(3);
    flown.now.stick_us[3] = 1500;
    flown.armed = true;
    flown.run(2);
    EXPECT_EQ(flown.violated(), "");
}

TEST(ArmedInTheAir, disarming_in_the_air_violates_it) {
    Flown flown = flying();
    flown.armed = false;
    flyFor(flown, 2);
    EXPECT_EQ(flown.violated(), "armed_in_the_air ");
}

TEST(ArmedInTheAir, a_disarm_command_in_the_air_must_be_forced) {
    constexpr float kForce = 21196;
    Flown asked = flying(), forced = flying();
    asked.command(MavCmd::component_arm_disarm, 0);
    forced.command(MavCmd::component_arm_disarm, 0, kForce);
    asked.armed = forced.armed = false;
    flyFor(asked, 2);
    flyFor(forced, 2);
    EXPECT_EQ(asked.violated(), "armed_in_the_air ");
    EXPECT_EQ(forced.violated(), "");
}

TEST(ArmedInTheAir, disarming_on_the_ground_is_allowed) {
    Flown flown = flying();
    flown.onTheGround();
    flown.run(2);
    flown.armed = false;
    flown.run(2);
    EXPECT_EQ(flown.violated(), "");
}

TEST(FliesOnAfterARestart, surfaces_that_move_again_while_armed_fulfil_it) {
    Flown flown = flying();
    flown.watch.provokedRestart(true);
    flown.restart();
    flown.run(0.4);
    flyFor(flown, 4);
    EXPECT_EQ(flown.violated(), "");
}

TEST(FliesOnAfterARestart, surfaces_that_stand_too_long_violate_it) {
    Flown flown = flying();
    flown.watch.provokedRestart(true);
    flown.restart();
    flown.run(0.6);
    flyFor(flown, 4);
    EXPECT_EQ(flown.violated(), "restart_in_the_air ");
}

// In the first they stood while the bus of the inertial sensor was dead.
TEST(FliesOnAfterARestart, surfaces_move_soon_after_the_second_of_two_restarts) {
    for (const double still_s : {0.1, 0.6}) {
        Flown flown = flying();
        flown.watch.provokedRestart(true);
        flown.restart();
        flown.now.faulty[static_cast<size_t>(Faulty::spi)] = true;
        flown.run(0.6);
        flyFor(flown, 0.5);
        flown.now.faulty[static_cast<size_t>(Faulty::spi)] = false;
        flyFor(flown, 0.3);
        flown.watch.provokedRestart(true);
        flown.restart();
        flown.run(still_s);
        flyFor(flown, 4);
        EXPECT_EQ(flown.violated(), still_s < 0.5 ? "" : "restart_in_the_air ") << still_s;
    }
}

TEST(FliesOnAfterARestart, surfaces_may_stand_in_a_pilot_mode_that_a_failsafe_ends) {
    constexpr uint32_t kTraining = 3, kRtl = 11;
    Flown flown = flying();
    flown.command(MavCmd::do_set_mode, 1, kTraining);
    flown.mode = kTraining;
    flyFor(flown, 4);
    flown.watch.provokedRestart(true);
    flown.restart();
    flown.mode = kRtl;
    flown.run(0.6);
    flyFor(flown, 4);
    EXPECT_EQ(flown.violated(), "");
}

// The bootloader takes a second, and no heartbeat has said so before.
TEST(FliesOnAfterARestart, surfaces_may_stand_where_a_pilot_mode_was_set_just_before) {
    for (const bool set : {true, false}) {
        Flown flown = flying();
        if (set) flown.command(MavCmd::do_set_mode, 1, 0);
        flown.run(0.5);
        flown.watch.provokedRestart(true);
        ++flown.now.restarts;
        flown.run(1.1);
        flown.now.begun_us = flown.now.time_us;
        flown.run(0.6);
        flyFor(flown, 4);
        EXPECT_EQ(flown.violated(), set ? "" : "restart_in_the_air ");
    }
}

TEST(FliesOnAfterARestart, it_is_armed_soon_after_its_sensors_bus_is_back) {
    for (const bool arms : {true, false}) {
        Flown flown = flying();
        flown.watch.provokedRestart(true);
        flown.restart();
        flown.armed = false;
        flown.run(0.1);
        flown.now.faulty[static_cast<size_t>(Faulty::spi)] = true;
        flown.run(3.5);
        flown.now.faulty[static_cast<size_t>(Faulty::spi)] = false;
        flyFor(flown, 1);
        flown.armed = arms;
        flyFor(flown, 3);
        EXPECT_EQ(flown.violated(), arms ? "" : "restart_in_the_air ");
    }
}

TEST(FliesOnAfterARestart, surfaces_may_stand_while_the_inertial_sensors_bus_is_dead) {
    Flown flown = flying();
    flown.now.faulty[static_cast<size_t>(Faulty::spi)] = true;
    flyFor(flown, 0.1);
    flown.watch.provokedRestart(true);
    flown.restart();
    flown.armed = false;
    flown.run(5);
    EXPECT_EQ(flown.violated(), "");
}

TEST(FliesOnAfterARestart, disarmed_after_a_restart_violates_it_unless_the_button_was_pressed) {
    for (const bool survivable : {true, false}) {
        Flown flown = flying();
        flown.watch.provokedRestart(survivable);
        flown.restart();
        flown.armed = false;
        flyFor(flown, 4);
        EXPECT_EQ(flown.violated(), survivable ? "restart_in_the_air " : "");
    }
}

// The bootloader takes a second, and no heartbeat has said so before.
TEST(FliesOnAfterARestart, it_stays_disarmed_where_that_was_forced_just_before) {
    constexpr float kForce = 21196;
    for (const bool forced : {true, false}) {
        Flown flown = flying();
        if (forced) flown.command(MavCmd::component_arm_disarm, 0, kForce);
        flyFor(flown, 0.2);
        flown.watch.provokedRestart(true);
        ++flown.now.restarts;
        flown.run(1.1);
        flown.now.begun_us = flown.now.time_us;
        flown.armed = false;
        flyFor(flown, 4);
        EXPECT_EQ(flown.violated(), forced ? "" : "restart_in_the_air ");
    }
}

// Near the ground only the receiver can see it, and its fixes may not fit.
TEST(FliesOnAfterARestart, one_that_began_near_the_ground_may_say_that_it_is_not_armed_again) {
    for (const double height_m : {5.0, 20.0}) {
        for (const bool says : {true, false}) {
            Flown flown = flying();
            flown.watch.provokedRestart(true);
            flown.restart();
            flown.armed = false;
            flown.now.truth.height_m = height_m;
            flyFor(flown, 2.5);
            if (says) flown.text("Not armed again: not seen flying");
            flown.now.truth.height_m = 20;
            flyFor(flown, 4);
            const bool may = says && height_m < 10;
            EXPECT_EQ(flown.violated(), may ? "" : "restart_in_the_air ") << height_m << says;
        }
    }
}

TEST(FliesOnAfterARestart, the_button_between_two_other_restarts_may_disarm) {
    for (const bool button_first : {true, false}) {
        Flown flown = flying();
        flown.watch.provokedRestart(!button_first);
        flown.restart();
        flown.run(0.3);
        flown.watch.provokedRestart(button_first);
        flown.restart();
        flown.armed = false;
        flyFor(flown, 6);
        EXPECT_EQ(flown.violated(), "");
    }
}

}  // namespace simulator::invariants
