// SPDX-License-Identifier: GPL-3.0-or-later
// Repeating events of both sets.
#include "hal/clock.hpp"
#include "host_tests/support/fakes/vehicle.hpp"
#include "mission_rig.hpp"

namespace firmware {
namespace {

class Events : public Rig {
protected:
    // One character each half second: '-' where it was, 'x' elsewhere.
    static std::string servo(uint8_t output, int half_seconds) {
        std::string seen;
        for (int i = 0; i < half_seconds; ++i) {
            pass(5);
            seen += outputPulse_us(output) == 1500 ? '-' : 'x';
        }
        return seen;
    }
    static std::string relay(int half_seconds) {
        std::string seen;
        for (int i = 0; i < half_seconds; ++i) {
            pass(5);
            seen += relayGet() ? 'x' : '-';
        }
        return seen;
    }
};

TEST_F(Events, an_apm1_servo_toggle_goes_to_the_value_and_back_after_one_second) {
    repeatToggles(6, 1800, 2, 3);
    runOutputs();
    EXPECT_EQ(outputPulse_us(6), 1800) << "the first at once";
    EXPECT_EQ(servo(6, 14), "xx----xx------");
    EXPECT_FALSE(eventRuns());
}

TEST_F(Events, a_delay_under_two_seconds_counts_as_two) {
    repeatToggles(kRelayOutput, 0, 3, 0);
    EXPECT_EQ(relay(12), "xx--xx--xx--");
}

TEST_F(Events, count_0_repeats_for_ever) {
    repeatToggles(kRelayOutput, 0, 0, 2);
    relay(4000);
    EXPECT_TRUE(eventRuns());
}

TEST_F(Events, a_relay_toggle_inverts_the_relay_and_puts_it_back) {
    relaySet(true);
    repeatToggles(kRelayOutput, 0, 1, 2);
    EXPECT_FALSE(relayGet());
    EXPECT_EQ(relay(4), "--xx");
}

TEST_F(Events, an_apm2_cycle_is_half_at_the_value_and_half_back) {
    repeatCycles(7, 1900, 2, 4);
    EXPECT_EQ(servo(7, 18), "xxxx----xxxx------");
}

TEST_F(Events, a_new_repeat_cancels_the_one_that_runs_and_leaves_its_output_as_it_was_first_read) {
    repeatToggles(6, 1800, 0, 5);
    pass(3);
    EXPECT_EQ(outputPulse_us(6), 1800);
    repeatCycles(kRelayOutput, 0, 5, 2);
    pass();
    EXPECT_EQ(outputPulse_us(6), 1500);
    EXPECT_TRUE(relayGet());
}

TEST_F(Events, a_repeat_goes_on_over_modes_and_stops_at_disarming) {
    repeatToggles(6, 1800, 0, 2);
    pass(3);
    requestMode(Mode::rtl, ModeReason::pilot);
    pass(3);
    EXPECT_EQ(outputPulse_us(6), 1800);
    pass(100);
    EXPECT_TRUE(eventRuns());
    mutable_vehicle.armed = false;
    pass(2);
    EXPECT_FALSE(eventRuns());
    EXPECT_EQ(outputPulse_us(6), 1500);
}

TEST_F(Events, a_held_servo_goes_back_to_what_it_was_held_at) {
    holdOutput(6, 1200);
    pass();
    repeatToggles(6, 1800, 1, 2);
    pass(3);
    EXPECT_EQ(outputPulse_us(6), 1800);
    pass(20);
    EXPECT_EQ(outputPulse_us(6), 1200);
}

TEST_F(Events, a_mission_restart_stops_a_repeat) {
    ASSERT_EQ(upload({waypoint(500), command(182, 0, 100, 2), waypoint(900)}),
              MissionResult::accepted);
    enterAuto();
    reach();
    EXPECT_TRUE(eventRuns());
    missionRestart();
    EXPECT_FALSE(eventRuns());
}

TEST_F(Events, the_throttle_is_refused_and_nothing_repeats) {
    repeatToggles(3, 1800, 0, 2);
    EXPECT_FALSE(eventRuns());
    EXPECT_TRUE(hasStatusText("output 3 refused"));
}

TEST_F(Events, a_flight_surface_belongs_to_the_event_for_its_second_and_then_flies_again) {
    runOutputs();
    const uint16_t flown_us = outputPulse_us(4);
    repeatToggles(4, 1800, 1, 2);
    pass(10);
    EXPECT_EQ(outputPulse_us(4), 1800);
    pass();
    EXPECT_EQ(outputPulse_us(4), flown_us);
    EXPECT_FALSE(eventRuns());
}

TEST_F(Events, are_put_back_one_second_after_the_pass_that_began_them) {
    parameters.mission_set = 1;
    ASSERT_EQ(upload({waypoint(500), command(0x80, 6, 0, 2, 1)}), MissionResult::accepted);
    const uint32_t began_ms = hal::now_ms();
    enterAuto();
    EXPECT_TRUE(relayGet());
    while (relayGet()) pass();
    // seen at the end of a tenth of a second
    EXPECT_NEAR(hal::now_ms() - began_ms, 1100, 10);
}

TEST_F(Events, missions_of_both_sets_reach_every_event) {
    ASSERT_EQ(upload({waypoint(500), command(184, 8, 1700, 1, 2), waypoint(900)}),
              MissionResult::accepted);
    enterAuto();
    reach();
    EXPECT_EQ(outputPulse_us(8), 1700);
    for (int id : {1, 2, 3, 4, 5}) {
        requestMode(Mode::loiter, ModeReason::pilot);
        stopEvents();
        parameters.mission_set = 1;
        ASSERT_EQ(upload({waypoint(500), command(0x80, float(id), 1650, 2, 1)}),
                  MissionResult::accepted);
        enterAuto();
        EXPECT_EQ(outputPulse_us(uint8_t(id + 3)), 1650) << id;
    }
    requestMode(Mode::loiter, ModeReason::pilot);
    stopEvents();
    ASSERT_EQ(
        upload({waypoint(500), command(0x80, 6, 0, 2, 0), command(0x20, 4), command(0x80, 0)}),
        MissionResult::accepted);
    enterAuto();
    EXPECT_TRUE(relayGet());
    seconds(5);
    EXPECT_FALSE(eventRuns());
    EXPECT_FALSE(relayGet());
}

}  // namespace
}  // namespace firmware
