// SPDX-License-Identifier: GPL-3.0-or-later
#include <random>

#include "ground.hpp"

using firmware::notify::sendStatusText;
using firmware::notify::Severity;
using ground::Framing;
using ground::Telemetry;

namespace {

TEST_F(Telemetry, speaks_mavlink_1_until_it_hears_mavlink_2) {
    run_ms(1000);
    EXPECT_EQ(station.everything().at(0).framing, Framing::v1);

    station.framing = Framing::v2;
    station.send(mavlink::Heartbeat{});
    run_ms(1000);

    EXPECT_EQ(station.everything().at(0).framing, Framing::v2);
    for (const auto& heard : second.everything()) EXPECT_EQ(heard.framing, Framing::v1);
}

TEST_F(Telemetry, a_message_that_mavlink_1_cannot_number_goes_out_in_mavlink_2) {
    EXPECT_EQ(command(mavlink::MavCmd::request_protocol_version), 0);

    const auto versions = station.all<mavlink::ProtocolVersion>();
    ASSERT_EQ(versions.size(), 1u);
    EXPECT_EQ(versions[0].max_version, 200);
    run_ms(1000);
    EXPECT_EQ(station.everything().at(0).framing, Framing::v1);
}

TEST_F(Telemetry, ignores_messages_for_another_target) {
    mavlink::CommandLong message = {};
    message.command = mavlink::MavCmd::component_arm_disarm;
    message.param1 = 1;
    message.target_component = 1;
    message.target_system = 2;
    EXPECT_TRUE(ask<mavlink::CommandAck>(message).empty());
    message.target_system = 1;
    message.target_component = 154;  // a gimbal's
    EXPECT_TRUE(ask<mavlink::CommandAck>(message).empty());
    EXPECT_FALSE(firmware::state::vehicle.armed);

    message.target_system = message.target_component = 0;  // everybody
    EXPECT_EQ(ask<mavlink::CommandAck>(message).size(), 1u);
    EXPECT_TRUE(firmware::state::vehicle.armed);
}

TEST_F(Telemetry, link0_follows_the_usb_cable) {
    EXPECT_EQ(fakes::serial(hal::Port::link0).baud, 57600u);
    EXPECT_EQ(fakes::serial(hal::Port::link1).baud, 57600u);

    fakes::setUsb(true);
    run_ms(20);
    EXPECT_EQ(fakes::serial(hal::Port::link0).baud, 115200u);

    fakes::setUsb(false);
    run_ms(20);
    EXPECT_EQ(fakes::serial(hal::Port::link0).baud, 57600u);
    EXPECT_EQ(fakes::serial(hal::Port::link1).opened.size(), 1u);
}

TEST_F(Telemetry, a_muted_link_is_silent_until_a_message_arrives) {
    run_ms(1000);
    (void)station.everything();
    (void)second.everything();
    doubles::plan.radio_off = true;
    sendStatusText(Severity::notice, STATUS_TEXT("Nobody hears this"));
    for (int i = 0; i < 3; ++i) {
        second.send(mavlink::Heartbeat{});  // to everyone, which is not to the airplane
        run_ms(1000);
    }
    EXPECT_TRUE(station.everything().empty());
    EXPECT_TRUE(second.everything().empty()) << "the heartbeat included";

    mavlink::ParamRequestRead question = {};
    question.target_system = question.target_component = 1;
    second.send(question);
    run_ms(1500);
    EXPECT_FALSE(second.all<mavlink::ParamValue>().empty());
    run_ms(1500);
    EXPECT_FALSE(second.all<mavlink::Heartbeat>().empty());
    EXPECT_FALSE(station.all<mavlink::Heartbeat>().empty());
}

TEST_F(Telemetry, usb_is_never_switched_off) {
    fakes::setUsb(true);
    run_ms(1000);
    doubles::plan.radio_off = true;
    (void)station.everything();
    (void)second.everything();
    run_ms(2000);
    EXPECT_FALSE(station.all<mavlink::Heartbeat>().empty());
    EXPECT_TRUE(second.everything().empty());
}

// The header of a mission item, and an order within what it says is its payload.
TEST_F(Telemetry, obeys_an_order_behind_a_torn_frame_soon_or_not_at_all) {
    mavlink::ParamRequestRead question = {};
    question.target_system = question.target_component = 1;
    station.line().receive(std::vector<uint8_t>{0xFE, 37, 0, 255, 190, 73});
    station.send(question);
    run_ms(300);
    EXPECT_TRUE(station.all<mavlink::ParamValue>().empty());
    run_ms(400);
    EXPECT_EQ(station.all<mavlink::ParamValue>().size(), 1u);
}

TEST_F(Telemetry, waits_for_a_frame_that_a_radio_tears_for_a_third_of_a_second) {
    mavlink::ParamRequestRead question = {};
    question.target_system = question.target_component = 1;
    uint8_t bytes[mavlink::kLongestFrame];
    const uint16_t size = mavlink::encode({Framing::v1, 0, 255, 190}, question, bytes);
    for (uint16_t at = 0; at < size; at += 5) {
        station.line().receive(
            std::vector<uint8_t>(bytes + at, bytes + std::min<uint16_t>(size, at + 5)));
        run_ms(330);
    }
    EXPECT_EQ(station.all<mavlink::ParamValue>().size(), 1u);
}

TEST_F(Telemetry, is_idle_until_bytes_come) {
    rest();
    EXPECT_FALSE(firmware::gcs::telemetryPump());
    EXPECT_FALSE(firmware::gcs::telemetryWaits());

    second.send(mavlink::Ping{});
    EXPECT_TRUE(firmware::gcs::telemetryWaits());
    EXPECT_TRUE(firmware::gcs::telemetryPump());
    rest();
    EXPECT_FALSE(firmware::gcs::telemetryWaits());
}

TEST_F(Telemetry, is_idle_until_there_is_room_to_send) {
    rest();
    station.line().room = 30;
    sendStatusText(Severity::info, STATUS_TEXT("news"));
    rest();
    EXPECT_FALSE(firmware::gcs::telemetryWaits());

    station.line().room = 100;
    EXPECT_TRUE(firmware::gcs::telemetryWaits());
    rest();
    EXPECT_EQ(station.texts().size(), 1u);
    EXPECT_FALSE(firmware::gcs::telemetryWaits());
}

TEST_F(Telemetry, sends_heartbeats_when_the_frames_leave_no_idle_time) {
    for (uint32_t ms = 0; ms < 10000; ms += 20) {
        firmware::gcs::telemetrySend();
        fakes::advance_ms(20);
    }
    EXPECT_NEAR(station.all<mavlink::Heartbeat>().size(), 10, 1);
}

TEST_F(Telemetry, leaves_requests_in_the_port_until_there_is_room_for_the_answer) {
    station.line().room = 20;
    station.line().endless = false;

    station.send(mavlink::Ping{});
    run_ms(200);
    EXPECT_TRUE(station.all<mavlink::Ping>().empty());
    EXPECT_FALSE(station.line().in.empty());

    station.line().room = hal::kLinkRoom;
    run_ms(20);
    EXPECT_EQ(station.all<mavlink::Ping>().size(), 1u);
}

TEST_F(Telemetry, answers_a_ping_and_a_timesync_question) {
    mavlink::Ping ping = {};
    ping.seq = 77;
    ping.time_usec = 123456789;
    const auto pings = ask<mavlink::Ping>(ping);
    ASSERT_EQ(pings.size(), 1u);
    EXPECT_EQ(pings[0].seq, 77u);
    EXPECT_EQ(pings[0].time_usec, 123456789u);
    EXPECT_EQ(pings[0].target_system, 255);

    mavlink::Timesync sync = {};
    sync.ts1 = 42;
    const auto syncs = ask<mavlink::Timesync>(sync);
    ASSERT_EQ(syncs.size(), 1u);
    EXPECT_EQ(syncs[0].ts1, 42);
    EXPECT_GT(syncs[0].tc1, 0);
}

TEST_F(Telemetry, answers_the_log_list_without_logs) {
    mavlink::LogRequestList message = {};
    message.target_system = message.target_component = 1;
    message.end = 0xFFFF;

    const auto entries = ask<mavlink::LogEntry>(message);

    ASSERT_EQ(entries.size(), 1u);
    EXPECT_EQ(entries[0].num_logs, 0);
    EXPECT_EQ(entries[0].last_log_num, 0);
    EXPECT_EQ(entries[0].size, 0u);
}

TEST_F(Telemetry, a_log_that_does_not_exist_ends_where_it_is_asked_for) {
    for (const Framing framing : {Framing::v1, Framing::v2}) {
        station.framing = framing;
        mavlink::LogRequestData message = {};
        message.target_system = message.target_component = 1;
        message.id = 7;
        message.ofs = 900;
        message.count = 0xFFFFFFFF;

        const auto parts = ask<mavlink::LogData>(message);

        ASSERT_EQ(parts.size(), 1u);
        EXPECT_EQ(parts[0].count, 0);
        EXPECT_EQ(parts[0].id, 7);
        EXPECT_EQ(parts[0].ofs, 900u);
    }
}

TEST_F(Telemetry, a_log_s_end_waits_for_room) {
    mavlink::LogRequestData message = {};
    message.target_system = message.target_component = 1;
    station.line().room = 60;  // enough for most answers, not for this
    EXPECT_TRUE(ask<mavlink::LogData>(message, 200).empty());

    station.line().room = hal::kLinkRoom;
    run_ms(20);
    EXPECT_EQ(station.all<mavlink::LogData>().size(), 1u);
}

TEST_F(Telemetry, erasing_logs_that_do_not_exist_is_answered_by_a_text) {
    mavlink::LogErase message = {};
    message.target_system = message.target_component = 1;
    station.send(message);
    mavlink::LogRequestEnd end = {};
    end.target_system = end.target_component = 1;
    station.send(end);
    run_ms(20);
    EXPECT_EQ(station.texts().at(0), "No logs to erase");
    EXPECT_TRUE(station.everything().empty());
}

TEST_F(Telemetry, texts_reach_both_links_with_their_number) {
    sendStatusText(Severity::warning, STATUS_TEXT("Item # refused"), -17);
    sendStatusText(Severity::info,
                   STATUS_TEXT("12345678901234567890123456789012345678901234567890"));

    run_ms(100);

    for (ground::Station* each : {&station, &second}) {
        const auto texts = each->texts();
        ASSERT_EQ(texts.size(), 2u);
        EXPECT_EQ(texts[0], "Item -17 refused");
        EXPECT_EQ(texts[1].size(), 50u);
    }
}

TEST_F(Telemetry, texts_queued_before_the_links_are_open_are_sent_after) {
    sendStatusText(Severity::info, STATUS_TEXT("early"));
    firmware::gcs::telemetryStart();
    run_ms(100);
    EXPECT_EQ(station.texts().at(0), "early");
}

TEST_F(Telemetry, a_text_carries_its_severity) {
    sendStatusText(Severity::critical, STATUS_TEXT("down"));
    run_ms(20);
    EXPECT_EQ(station.all<mavlink::Statustext>().at(0).severity, mavlink::MavSeverity::critical);
}

TEST_F(Telemetry, dropped_texts_are_counted_and_reported) {
    for (int i = 0; i < 12; ++i) sendStatusText(Severity::info, STATUS_TEXT("text #"), i);

    run_ms(500);

    const auto texts = station.texts();
    const size_t sent = texts.size() - 1;
    ASSERT_GE(sent, 4u);
    for (size_t i = 0; i < sent; ++i) EXPECT_EQ(texts[i], "text " + std::to_string(i));
    EXPECT_EQ(texts.back(), std::to_string(12 - sent) + " texts lost");
}

TEST_F(Telemetry, the_most_negative_number_is_spelled) {
    sendStatusText(Severity::info, STATUS_TEXT("#"), INT32_MIN);
    run_ms(20);
    EXPECT_EQ(station.texts().at(0), "-2147483648");
}

mavlink::RcChannelsOverride sticks(uint16_t first, uint16_t second) {
    mavlink::RcChannelsOverride message = {};
    message.target_system = message.target_component = 1;
    message.chan1_raw = first;
    message.chan2_raw = second;
    return message;
}

TEST_F(Telemetry, the_ground_stations_sticks_replace_and_release_channels) {
    uint16_t pulse_us = 0;
    station.send(sticks(1200, 1800));
    run_ms(20);
    ASSERT_TRUE(firmware::sensors::rcOverride(0, pulse_us));
    EXPECT_EQ(pulse_us, 1200);
    ASSERT_TRUE(firmware::sensors::rcOverride(1, pulse_us));
    EXPECT_EQ(pulse_us, 1800);
    EXPECT_FALSE(firmware::sensors::rcOverride(2, pulse_us));

    station.send(sticks(65535, 0));  // as it is, and given back
    run_ms(20);
    ASSERT_TRUE(firmware::sensors::rcOverride(0, pulse_us));
    EXPECT_EQ(pulse_us, 1200);
    EXPECT_FALSE(firmware::sensors::rcOverride(1, pulse_us));
}

TEST_F(Telemetry, rc_override_of_another_system_is_ignored) {
    uint16_t pulse_us = 0;
    station.system = 254;
    station.send(sticks(1200, 1800));
    run_ms(20);
    EXPECT_FALSE(firmware::sensors::rcOverride(0, pulse_us));
}

TEST_F(Telemetry, sticks_that_are_no_longer_repeated_are_released) {
    uint16_t pulse_us = 0;
    station.send(sticks(1200, 1800));
    run_ms(2900);
    EXPECT_TRUE(firmware::sensors::rcOverride(0, pulse_us));
    run_ms(200);
    EXPECT_FALSE(firmware::sensors::rcOverride(0, pulse_us));
}

mavlink::ManualControl joystick(int16_t forward, int16_t right) {
    mavlink::ManualControl message = {};
    message.target = 1;
    message.x = forward;
    message.y = right;
    message.z = 250;
    message.r = INT16_MAX;
    return message;
}

TEST_F(Telemetry, a_joystick_of_the_ground_station_replaces_the_sticks) {
    uint16_t pulse_us = 0;
    station.send(joystick(500, 1000));
    run_ms(20);
    ASSERT_TRUE(firmware::sensors::rcOverride(0, pulse_us));
    EXPECT_EQ(pulse_us, 1900);
    ASSERT_TRUE(firmware::sensors::rcOverride(1, pulse_us));
    EXPECT_EQ(pulse_us, 1300);  // forward: nose down
    ASSERT_TRUE(firmware::sensors::rcOverride(2, pulse_us));
    EXPECT_EQ(pulse_us, 1300);
    for (uint8_t channel = 3; channel < 8; ++channel)
        EXPECT_FALSE(firmware::sensors::rcOverride(channel, pulse_us)) << int{channel};
    EXPECT_GT(firmware::state::vehicle.ground_heard_ms, 0u);
}

TEST_F(Telemetry, a_joystick_is_understood_whatever_stands_behind_its_target) {
    station.framing = Framing::v2;
    mavlink::ManualControl message = joystick(0, -1000);
    message.buttons2 = 0x0102;  // where other messages have the component
    station.send(message);
    run_ms(20);
    uint16_t pulse_us = 0;
    ASSERT_TRUE(firmware::sensors::rcOverride(0, pulse_us));
    EXPECT_EQ(pulse_us, 1100);
}

TEST_F(Telemetry, a_joystick_past_its_end_is_at_its_end) {
    uint16_t pulse_us = 0;
    for (const int forward : {INT16_MIN, -INT16_MAX, -1001}) {
        station.send(joystick(static_cast<int16_t>(forward), 0));
        run_ms(20);
        ASSERT_TRUE(firmware::sensors::rcOverride(1, pulse_us)) << forward;
        EXPECT_EQ(pulse_us, 1900) << forward;
    }
    station.send(joystick(INT16_MAX, 0));
    run_ms(20);
    EXPECT_FALSE(firmware::sensors::rcOverride(1, pulse_us));
}

TEST_F(Telemetry, a_joystick_for_another_or_from_another_is_ignored) {
    uint16_t pulse_us = 0;
    mavlink::ManualControl message = joystick(0, 1000);
    message.target = 2;
    station.send(message);
    station.system = 254;
    station.send(joystick(0, 1000));
    run_ms(20);
    EXPECT_FALSE(firmware::sensors::rcOverride(0, pulse_us));
    EXPECT_EQ(firmware::state::vehicle.ground_heard_ms, 0u);
}

TEST_F(Telemetry, knows_when_the_ground_station_was_last_heard) {
    mavlink::Heartbeat message = {};
    station.system = 42;
    station.send(message);
    run_ms(100);
    const uint32_t before_ms = firmware::state::vehicle.ground_heard_ms;

    station.system = 255;
    station.send(message);
    run_ms(100);

    EXPECT_GT(firmware::state::vehicle.ground_heard_ms, before_ms);
}

TEST_F(Telemetry, ten_megabytes_of_noise_have_no_effect) {
    std::mt19937 random(3);
    const firmware::state::Parameters before = firmware::state::parameters;
    for (uint32_t sent = 0; sent < 10000000; sent += 1000) {
        std::vector<uint8_t> noise(1000);
        for (uint8_t& byte : noise) byte = static_cast<uint8_t>(random());
        station.line().receive(noise);
        for (int i = 0; i < 70; ++i) firmware::gcs::telemetryPump();
        if (sent % 100000 == 0) run_ms(1000);
        ASSERT_TRUE(station.line().in.empty());
    }

    station.forget();
    EXPECT_EQ(station.broken(), 0);
    EXPECT_EQ(memcmp(&before, &firmware::state::parameters, sizeof before), 0);
    EXPECT_FALSE(firmware::state::vehicle.armed);
    // what the last bytes may have promised is known to be false after one frame more
    station.send(mavlink::CommandLong{});
    EXPECT_EQ(ask<mavlink::Ping>(mavlink::Ping{}).size(), 1u);
}

TEST_F(Telemetry, survives_any_payload) {
    std::mt19937 random(1);
    const uint8_t odd[] = {0, 1, 0x7F, 0x80, 0xFF};
    for (int round = 0; round < 300; ++round) {
        for (const mavlink::Accepted& accepted : mavlink::kAllMessages) {
            uint8_t payload[255];
            for (uint8_t& byte : payload)
                byte = random() % 3 == 0 ? odd[random() % 5] : static_cast<uint8_t>(random());
            const uint8_t length = static_cast<uint8_t>(accepted.length + random() % 3);
            station.sendRaw({payload, accepted.id, length, accepted.crc_extra});
        }
        run_ms(20);
        station.line().in.clear();
        station.forget();
    }

    run_ms(12000);  // an upload may have begun
    station.forget();
    EXPECT_EQ(ask<mavlink::Ping>(mavlink::Ping{}).size(), 1u);
}

}  // namespace
