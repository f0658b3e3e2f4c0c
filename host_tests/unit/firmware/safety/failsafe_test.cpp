// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/safety/failsafe.hpp"
#include "firmware/sensors/rc_override.hpp"

#include <string.h>

#include "firmware/notify/text_queue.hpp"
#include "firmware_bench.hpp"
#include "host_tests/support/fakes/vehicle.hpp"
#include "mavlink/peer.hpp"

namespace {

using firmware::state::Mode;
using firmware::state::mutable_vehicle;
using firmware::state::parameters;
using firmware::state::vehicle;

constexpr uint32_t kShort_ms = 1500;
constexpr uint32_t kLong_ms = 7000;

struct Failsafe : bench::Bench {};

TEST_F(Failsafe, circles_at_once_and_returns_home_after_the_long_time) {
    fly(Mode::fbwa);
    loseRadio(kShort_ms);
    EXPECT_EQ(vehicle.mode, Mode::circle);
    EXPECT_TRUE(vehicle.failsafe_short);
    EXPECT_FALSE(vehicle.failsafe_glides);
    loseRadio(kLong_ms);
    EXPECT_EQ(vehicle.mode, Mode::rtl);
    EXPECT_TRUE(vehicle.failsafe_long);
}

// The texts of a link since the last call, one a line.
std::string statusTexts() {
    std::string texts;
    char text[firmware::notify::kTextSize];
    firmware::notify::Severity severity;
    while (firmware::notify::readText(0, severity, text)) {
        texts += std::string(text, strnlen(text, sizeof text)) + "\n";
        for (uint8_t reader : {0, 1, 2})
            if (firmware::notify::textWaits(reader)) firmware::notify::textTaken(reader);
    }
    return texts;
}

TEST_F(Failsafe, reports_a_cause_once_when_it_begins_and_once_when_it_is_over) {
    fly(Mode::fbwa);
    (void)statusTexts();
    loseRadio(kShort_ms);
    EXPECT_NE(statusTexts().find("Radio lost: short failsafe\n"), std::string::npos);
    loseRadio(1000);
    EXPECT_EQ(statusTexts().find("Radio lost: short failsafe"), std::string::npos);
    settle(bench::kCentred);
    firmware::safety::runFailsafe();
    EXPECT_NE(statusTexts().find("Radio back\n"), std::string::npos);
}

TEST_F(Failsafe, gives_back_the_mode_when_the_radio_is_back_in_time) {
    fly(Mode::fbwa);
    loseRadio(kShort_ms);
    ASSERT_EQ(vehicle.mode, Mode::circle);

    settle(with(8, 1425));
    firmware::safety::runFailsafe();

    EXPECT_EQ(vehicle.mode, Mode::fbwa);
    EXPECT_FALSE(vehicle.failsafe_short);
    EXPECT_FALSE(vehicle.failsafe_gives_back) << "any other mode may be asked for again";
}

TEST_F(Failsafe, sends_no_text_for_a_cause_that_ends_without_one) {
    fly(Mode::fbwa);
    parameters.battery_monitor = 4;
    parameters.battery_low_v = 10.5f;
    mutable_vehicle.battery.voltage_mv = 10000;
    (void)statusTexts();
    for (int i = 0; i < 101; ++i) firmware::safety::runFailsafe();
    const std::string begun = statusTexts();
    EXPECT_NE(begun.find("Battery low\n"), std::string::npos);
    mutable_vehicle.armed = false;
    firmware::safety::runFailsafe();
    for (const std::string& texts : {begun, statusTexts()}) {
        EXPECT_NE(texts.rfind("\n", 0), 0u) << texts;
        EXPECT_EQ(texts.find("\n\n"), std::string::npos) << texts;
    }
}

TEST_F(Failsafe, is_asked_nothing_more_by_a_mode_that_circles_already) {
    parameters.short_action = 1;
    fly(Mode::circle);
    const uint8_t entries = vehicle.mode_entries;
    loseRadio(kShort_ms);
    EXPECT_EQ(vehicle.mode, Mode::circle);
    EXPECT_EQ(vehicle.mode_entries, entries);
}

TEST_F(Failsafe, does_not_make_a_mode_that_circles_glide) {
    parameters.short_action = 2;
    fly(Mode::circle);
    loseRadio(kShort_ms);
    EXPECT_EQ(vehicle.mode, Mode::circle);
    EXPECT_FALSE(vehicle.failsafe_glides);
}

TEST_F(Failsafe, leaves_a_mode_that_was_chosen_meanwhile) {
    fly(Mode::fbwa);
    loseRadio(kShort_ms);
    firmware::modes::requestMode(Mode::loiter, firmware::modes::ModeReason::ground);

    settle(bench::kCentred);
    firmware::safety::runFailsafe();

    EXPECT_NE(vehicle.mode, Mode::circle);
    EXPECT_NE(vehicle.mode, Mode::fbwa);
}

TEST_F(Failsafe, keeps_returning_home_after_the_long_time_though_the_radio_is_back) {
    fly(Mode::fbwa);
    loseRadio(kShort_ms + kLong_ms);
    ASSERT_EQ(vehicle.mode, Mode::rtl);

    for (int i = 0; i < 5; ++i) {
        fakes::receiveRc(bench::kCentred);
        firmware::sensors::runRadio();
        fakes::advance_ms(10);
    }
    firmware::safety::runFailsafe();

    EXPECT_EQ(vehicle.mode, Mode::rtl);
    EXPECT_FALSE(vehicle.failsafe_long);
}

TEST_F(Failsafe, lets_loiter_go_on_by_default) {
    fly(Mode::loiter);
    loseRadio(kShort_ms + kLong_ms);
    EXPECT_EQ(vehicle.mode, Mode::loiter);
}

TEST_F(Failsafe, returns_home_from_loiter_when_configured) {
    parameters.short_action = 1;
    parameters.long_action = 1;
    fly(Mode::loiter);
    loseRadio(kShort_ms);
    EXPECT_EQ(vehicle.mode, Mode::circle);
    loseRadio(kLong_ms);
    EXPECT_EQ(vehicle.mode, Mode::rtl);
}

TEST_F(Failsafe, glides_in_fbwa_when_configured) {
    parameters.short_action = parameters.long_action = 2;
    fly(Mode::stabilize);
    loseRadio(kShort_ms);
    ASSERT_EQ(vehicle.mode, Mode::fbwa);
    firmware::modes::runMode();
    EXPECT_EQ(vehicle.throttle_demand.toFloat(), 0);
    EXPECT_EQ(vehicle.roll_demand_rad.toFloat(), 0);
}

TEST_F(Failsafe, circles_when_there_is_no_home_to_return_to) {
    fly(Mode::fbwa);
    mutable_vehicle.home.set = false;
    loseRadio(kShort_ms + kLong_ms);
    EXPECT_EQ(vehicle.mode, Mode::circle);
}

// A ground station on link0, heard or silent while the receiver works.
struct GroundStation : Failsafe {
    void SetUp() override {
        Failsafe::SetUp();
        fakes::serial(hal::Port::link0).room = hal::kLinkRoom;
        firmware::gcs::telemetryStart();
        parameters.ground_failsafe = 1;
    }
    template <class Message>
    void say(const Message& message, uint8_t system = 255) {
        uint8_t bytes[mavlink::kLongestFrame];
        const uint16_t size =
            mavlink::encode({mavlink::Framing::v1, 0, system, 190}, message, bytes);
        fakes::serial(hal::Port::link0).receive(std::vector<uint8_t>(bytes, bytes + size));
        for (int i = 0; i < 10; ++i) firmware::gcs::telemetryPump();
    }
    void beat() { say(mavlink::Heartbeat{}); }
    void fly_s(int seconds, bool beating) {
        for (int i = 0; i < seconds; ++i) {
            if (beating) beat();
            for (int quarter = 0; quarter < 4; ++quarter) {
                settle(bench::kCentred);
                firmware::safety::runFailsafe();
            }
        }
    }
    void hold(const std::vector<uint16_t>& sticks) {
        mavlink::RcChannelsOverride message = {};
        memcpy(&message, sticks.data(), 8 * sizeof sticks[0]);
        message.target_system = message.target_component = 1;
        say(message);
    }
};

TEST_F(GroundStation, takes_the_airplane_home_when_it_has_fallen_silent) {
    fly(Mode::fbwa);
    fly_s(10, true);
    EXPECT_EQ(vehicle.mode, Mode::fbwa);
    fly_s(3, false);
    EXPECT_EQ(vehicle.mode, Mode::fbwa);

    fly_s(2, false);

    EXPECT_EQ(vehicle.mode, Mode::rtl);
    EXPECT_TRUE(vehicle.failsafe_long);
}

TEST_F(GroundStation, coming_back_ends_the_failsafe_but_does_not_change_the_mode) {
    fly(Mode::fbwa);
    fly_s(1, true);
    fly_s(7, false);
    ASSERT_TRUE(vehicle.failsafe_long);

    fly_s(2, true);

    EXPECT_FALSE(vehicle.failsafe_long);
    EXPECT_EQ(vehicle.mode, Mode::rtl);
}

TEST_F(GroundStation, the_pilot_may_take_over_while_it_is_silent) {
    fly(Mode::fbwa);
    fly_s(1, true);
    fly_s(7, false);
    ASSERT_EQ(vehicle.mode, Mode::rtl);

    firmware::modes::requestMode(Mode::stabilize, firmware::modes::ModeReason::pilot);
    fly_s(7, false);

    EXPECT_EQ(vehicle.mode, Mode::stabilize);
}

TEST_F(GroundStation, never_heard_is_no_failsafe) {
    fly(Mode::fbwa);
    fly_s(20, false);
    EXPECT_EQ(vehicle.mode, Mode::fbwa);
}

TEST_F(GroundStation, another_systems_heartbeats_neither_start_nor_stop_the_failsafe) {
    fly(Mode::fbwa);
    say(mavlink::Heartbeat{}, 42);
    fly_s(8, false);
    EXPECT_EQ(vehicle.mode, Mode::fbwa);

    beat();
    for (int i = 0; i < 8; ++i) {
        say(mavlink::Heartbeat{}, 42);
        fly_s(1, false);
    }
    EXPECT_EQ(vehicle.mode, Mode::rtl);
}

TEST_F(GroundStation, is_not_missed_when_FS_GCS_ENABL_is_0) {
    parameters.ground_failsafe = 0;
    fly(Mode::fbwa);
    fly_s(1, true);
    fly_s(10, false);
    EXPECT_EQ(vehicle.mode, Mode::fbwa);
}

TEST_F(GroundStation, is_not_missed_on_the_ground) {
    fly_s(1, true);
    fly_s(10, false);
    EXPECT_EQ(vehicle.mode, Mode::manual);
    EXPECT_FALSE(vehicle.failsafe_long);
}

TEST_F(GroundStation, leaves_auto_alone_unless_FS_LONG_ACTN_says_otherwise) {
    fly(Mode::loiter);
    fly_s(1, true);
    fly_s(7, false);
    EXPECT_EQ(vehicle.mode, Mode::loiter);
    EXPECT_TRUE(vehicle.failsafe_long);
}

TEST_F(GroundStation, losing_both_links_ends_at_home) {
    fly(Mode::fbwa);
    fly_s(1, true);
    fly_s(7, false);
    ASSERT_EQ(vehicle.mode, Mode::rtl);
    loseRadio(kShort_ms + kLong_ms);
    beat();
    firmware::safety::runFailsafe();
    loseRadio(200);

    EXPECT_EQ(vehicle.mode, Mode::rtl);
}

TEST_F(GroundStation, flies_by_its_sticks_alone_and_is_missed_when_they_stop) {
    parameters.ground_failsafe = 0;
    fly(Mode::fbwa);
    for (int i = 0; i < 50; ++i) {
        hold({1400, 1500, 1600, 1500, 1500, 1500, 1500, 1815});
        loseRadio(100);
    }
    EXPECT_FALSE(vehicle.radio.lost);
    EXPECT_LT(vehicle.radio.roll_cd, 0);
    EXPECT_EQ(vehicle.mode, Mode::fbwa);

    loseRadio(3100);  // RC_CHANNELS_OVERRIDE counts for three seconds

    EXPECT_TRUE(vehicle.radio.lost);
    EXPECT_EQ(vehicle.radio.roll_cd, 0);
    EXPECT_EQ(vehicle.mode, Mode::circle);
}

TEST_F(GroundStation, holding_one_channel_does_not_hide_that_the_receiver_is_gone) {
    parameters.ground_failsafe = 0;
    fly(Mode::fbwa);
    for (int i = 0; i < 20; ++i) {
        hold({0, 0, 0, 0, 0, 1700, 0, 0});
        loseRadio(100);
    }
    EXPECT_TRUE(vehicle.radio.lost);
    EXPECT_EQ(vehicle.mode, Mode::circle);
}

TEST_F(GroundStation, its_sticks_are_dropped_when_it_is_missed) {
    fly(Mode::fbwa);
    hold({1400, 0, 0, 0, 0, 0, 0, 0});
    parameters.long_timeout_s = 1;
    fly_s(2, false);
    ASSERT_EQ(vehicle.mode, Mode::rtl);

    uint16_t pulse_us = 0;
    EXPECT_FALSE(firmware::sensors::rcOverride(0, pulse_us));
}

TEST_F(Failsafe, does_nothing_on_the_ground_while_disarmed) {
    loseRadio(kShort_ms + kLong_ms);
    EXPECT_EQ(vehicle.mode, Mode::manual);
    EXPECT_FALSE(vehicle.failsafe_short);
}

}  // namespace
