// SPDX-License-Identifier: GPL-3.0-or-later
#include "mavlink/frame.hpp"

#include <gtest/gtest.h>

#include "mavlink/peer.hpp"
#include "wire_bytes.hpp"

using mavlink::Framing;

namespace {

mavlink::Heartbeat heartbeat() {
    mavlink::Heartbeat message = {};
    message.custom_mode = 10;
    message.type = mavlink::MavType::fixed_wing;
    message.autopilot = mavlink::MavAutopilot::ardupilotmega;
    message.base_mode = 0x51;
    message.system_status = mavlink::MavState::standby;
    message.mavlink_version = 3;
    return message;
}

TEST(Frame, a_heartbeat_in_mavlink_1_is_17_bytes_known_from_elsewhere) {
    const auto bytes = test::frame({Framing::v1, 7, 1, 1}, heartbeat());

    // as npm node-mavlink 2.3.0 writes it
    const test::Bytes expected = {0xFE, 9, 7, 1, 1, 0, 10, 0, 0, 0, 1, 3, 0x51, 3, 3, 0xE5, 0x1C};
    EXPECT_EQ(bytes, expected);
}

TEST(Frame, a_heartbeat_in_mavlink_2_is_21_bytes_known_from_elsewhere) {
    const auto bytes = test::frame({Framing::v2, 7, 1, 1}, heartbeat());

    const test::Bytes expected = {0xFD, 9, 0, 0, 7, 1,    1, 0, 0,    0,   10,
                                  0,    0, 0, 1, 3, 0x51, 3, 3, 0xBB, 0x1D};
    EXPECT_EQ(bytes, expected);
}

TEST(Frame, mavlink_2_leaves_out_the_zeros_at_the_end_of_the_payload) {
    mavlink::CommandLong message = {};
    message.param1 = 1.0f;  // 00 00 80 3F, and 29 zeros after it but for the command
    message.command = 400;

    const auto bytes = test::frame({Framing::v2, 0, 255, 190}, message);

    EXPECT_EQ(bytes[1], 30);  // up to the high byte of the command
    EXPECT_EQ(bytes.size(), 30u + 12u);
}

TEST(Frame, mavlink_2_sends_one_byte_of_a_payload_of_zeros) {
    const auto bytes = test::frame({Framing::v2, 0, 1, 1}, mavlink::ParamRequestList{});

    EXPECT_EQ(bytes[1], 1);
    EXPECT_EQ(bytes.size(), 13u);
}

TEST(Frame, mavlink_1_sends_the_whole_payload_and_no_extensions) {
    mavlink::MissionCount message = {};
    message.mission_type = 1;

    const auto bytes = test::frame({Framing::v1, 0, 1, 1}, message);

    EXPECT_EQ(bytes[1], mavlink::Wire<mavlink::MissionCount>::length);
}

TEST(Frame, its_size_is_known_before_it_is_written) {
    for (const Framing framing : {Framing::v1, Framing::v2}) {
        const auto message = mavlink::outgoing(framing, heartbeat());

        EXPECT_EQ(mavlink::frameSize(framing, message.length),
                  test::frame({framing, 0, 1, 1}, heartbeat()).size());
    }
}

}  // namespace
