// SPDX-License-Identifier: GPL-3.0-or-later
#include "mavlink/parser.hpp"

#include <gtest/gtest.h>

#include <random>

#include "wire_bytes.hpp"

using mavlink::Framing;
using test::Bytes;
using test::operator+;

namespace {

// As a vehicle would: few messages, and room for the longest of them.
struct VehicleTable {
    static uint8_t find(uint16_t id, mavlink::Accepted& to) {
        constexpr mavlink::Accepted kRows[] = {mavlink::accepts<mavlink::Heartbeat>(),
                                               mavlink::accepts<mavlink::SetMode>(),
                                               mavlink::accepts<mavlink::MissionItemInt>(),
                                               mavlink::accepts<mavlink::MissionRequestList>()};
        for (uint8_t row = 0; row < 4; ++row) {
            to = kRows[row];
            if (to.id == id) return row;
        }
        return mavlink::kNoRow;
    }
};
using VehicleParser = mavlink::Parser<VehicleTable, 50>;
static_assert(sizeof(VehicleParser) <= 64, "the parser's share of 8 KiB");

struct Received {
    uint16_t id;
    Framing framing;
    uint8_t row, sequence, system, component;
    Bytes payload;
};

template <class Parser>
std::vector<Received> feed(Parser& parser, const Bytes& bytes) {
    std::vector<Received> frames;
    for (const uint8_t byte : bytes)
        for (bool whole = parser.put(byte); whole; whole = parser.next()) {
            const mavlink::Frame frame = parser.frame();
            frames.push_back({frame.id, frame.framing, frame.row, frame.sequence, frame.system,
                              frame.component, Bytes(frame.payload, frame.payload + frame.length)});
        }
    return frames;
}

// The message of the one frame that `bytes` ends with.
template <class Message, class Parser>
Message readOnly(Parser& parser, const Bytes& bytes) {
    bool whole = false;
    for (const uint8_t byte : bytes) whole = parser.put(byte);
    EXPECT_TRUE(whole);
    return parser.frame().template read<Message>();
}

std::vector<uint8_t> sequences(const std::vector<Received>& frames) {
    std::vector<uint8_t> all;
    for (const Received& frame : frames) all.push_back(frame.sequence);
    return all;
}
using Sequences = std::vector<uint8_t>;

Bytes heartbeat(uint8_t sequence, Framing framing = Framing::v1, uint8_t system = 255) {
    mavlink::Heartbeat message = {};
    message.type = mavlink::MavType::gcs;
    message.mavlink_version = 3;
    return test::frame({framing, sequence, system, 190}, message);
}

Bytes requestMode(uint8_t sequence) {
    mavlink::SetMode message = {};
    message.custom_mode = 11;
    message.base_mode = 1;
    return test::frame({Framing::v1, sequence, 255, 190}, message);
}

TEST(Parser, reads_both_versions_mixed) {
    VehicleParser parser;

    const auto frames = feed(parser, heartbeat(1) + heartbeat(2, Framing::v2) + requestMode(3));

    ASSERT_EQ(sequences(frames), (Sequences{1, 2, 3}));
    EXPECT_EQ(frames[0].framing, Framing::v1);
    EXPECT_EQ(frames[1].framing, Framing::v2);
    EXPECT_EQ(frames[0].payload, frames[1].payload);
    EXPECT_EQ(frames[2].id, mavlink::Wire<mavlink::SetMode>::id);
    EXPECT_EQ(frames[2].row, 1);
    EXPECT_EQ(frames[2].system, 255);
    EXPECT_EQ(frames[2].component, 190);
}

TEST(Parser, gives_zeros_for_what_the_sender_left_out) {
    mavlink::PeerParser parser;
    mavlink::MissionItemInt message = {};
    message.command = 16;  // everything after it is zero
    const Bytes bytes = test::frame({Framing::v2, 0, 255, 190}, message);
    ASSERT_LT(bytes.size(), sizeof message + 12);

    const auto read = readOnly<mavlink::MissionItemInt>(parser, bytes);

    EXPECT_EQ(memcmp(&read, &message, sizeof read), 0);
}

TEST(Parser, refuses_a_frame_with_any_bit_wrong) {
    const Bytes good = heartbeat(1);
    for (size_t at = 0; at < good.size(); ++at)
        for (int bit = 0; bit < 8; ++bit) {
            Bytes bad = good;
            bad[at] = static_cast<uint8_t>(bad[at] ^ (1 << bit));
            VehicleParser parser;

            EXPECT_TRUE(feed(parser, bad).empty()) << "byte " << at << " bit " << bit;
        }
}

TEST(Parser, takes_a_signed_frame_and_leaves_out_its_signature) {
    mavlink::SetMode mode = {};
    mode.custom_mode = 5;
    Bytes bytes = test::frame({Framing::v2, 4, 255, 190}, mode);
    bytes.resize(bytes.size() - 2);
    bytes[2] = mavlink::kSignedFlag;
    bytes = test::sealed(bytes, mavlink::Wire<mavlink::SetMode>::crc_extra);
    const Bytes signature(13, 0xFE);  // looks like the start of thirteen frames
    VehicleParser parser;

    const auto frames = feed(parser, bytes + signature + heartbeat(5));

    EXPECT_EQ(sequences(frames), (Sequences{4, 5}));
    EXPECT_EQ(parser.rejected(), 0);
}

// A SET_MODE with these incompatibility flags; `payload` is what else it carries.
Bytes flagged(uint8_t flags, uint8_t sequence, const Bytes& more = {}) {
    mavlink::SetMode mode = {};
    mode.custom_mode = 5;
    mode.base_mode = 1;
    Bytes bytes = test::frame({Framing::v2, sequence, 255, 190}, mode);
    bytes.resize(bytes.size() - 2);
    bytes[1] = static_cast<uint8_t>(bytes[1] + more.size());
    bytes[2] = flags;
    return test::sealed(bytes + more, mavlink::Wire<mavlink::SetMode>::crc_extra);
}

TEST(Parser, drops_a_frame_with_an_incompatibility_it_does_not_know) {
    VehicleParser parser;
    EXPECT_EQ(sequences(feed(parser, flagged(0x02, 4) + heartbeat(5))), (Sequences{5}));
}

TEST(Parser, drops_an_incompatible_frame_whatever_it_contains) {
    VehicleParser parser;

    const auto frames = feed(parser, flagged(0x80, 4, requestMode(66)) + heartbeat(5));

    EXPECT_EQ(sequences(frames), (Sequences{5}));
    EXPECT_EQ(parser.rejected(), 0);
}

TEST(Parser, drops_an_incompatible_frame_with_its_signature) {
    VehicleParser parser;
    const Bytes signature(13, 0xFD);

    const auto frames = feed(parser, heartbeat(3) + flagged(0x03, 4) + signature + heartbeat(5));

    EXPECT_EQ(sequences(frames), (Sequences{3, 5}));
}

TEST(Parser, what_looks_like_an_incompatible_frame_swallows_nothing) {
    VehicleParser parser;
    Bytes cut = flagged(0x02, 4);
    cut.resize(cut.size() - 3);

    const auto frames = feed(parser, cut + heartbeat(5) + heartbeat(6));

    EXPECT_EQ(sequences(frames), (Sequences{5, 6}));
}

TEST(Parser, loses_no_good_frame_to_a_signature_that_was_cut_short) {
    for (uint8_t left = 0; left < 13; ++left) {
        VehicleParser parser;
        const Bytes signature(left, 0xFE);

        const auto frames =
            feed(parser, flagged(0x01, 4) + signature + heartbeat(5) + heartbeat(6) + heartbeat(7));

        EXPECT_EQ(sequences(frames), (Sequences{4, 5, 6, 7})) << int(left) << " bytes left";
    }
}

TEST(Parser, takes_nothing_in_a_signature_for_a_frame) {
    std::mt19937 random(2);
    VehicleParser parser;
    for (int round = 0; round < 20000; ++round) {
        Bytes signature(13);
        for (uint8_t& byte : signature) byte = static_cast<uint8_t>(random());

        const auto frames = feed(parser, flagged(0x01, 4) + signature + heartbeat(5));

        ASSERT_EQ(sequences(frames), (Sequences{4, 5})) << round;
    }
    EXPECT_EQ(parser.rejected(), 0);
}

TEST(Parser, ignores_compatibility_flags) {
    mavlink::SetMode mode = {};
    mode.custom_mode = 5;
    Bytes bytes = test::frame({Framing::v2, 4, 255, 190}, mode);
    bytes.resize(bytes.size() - 2);
    bytes[3] = 0xFF;
    bytes = test::sealed(bytes, mavlink::Wire<mavlink::SetMode>::crc_extra);
    VehicleParser parser;

    EXPECT_EQ(sequences(feed(parser, bytes)), (Sequences{4}));
}

TEST(Parser, tolerates_extension_bytes_in_a_mavlink_1_frame) {
    const Bytes bytes = test::sealed({0xFE, 3, 9, 255, 190, 43, 1, 1, 2},
                                     mavlink::Wire<mavlink::MissionRequestList>::crc_extra);
    VehicleParser parser;

    const auto frames = feed(parser, bytes);

    ASSERT_EQ(frames.size(), 1u);
    EXPECT_EQ(frames[0].payload, (Bytes{1, 1, 2}));
}

TEST(Parser, refuses_a_mavlink_1_frame_that_is_too_short) {
    const Bytes bytes = test::sealed({0xFE, 1, 9, 255, 190, 43, 1},
                                     mavlink::Wire<mavlink::MissionRequestList>::crc_extra);
    VehicleParser parser;

    EXPECT_TRUE(feed(parser, bytes).empty());
}

// FILE_TRANSFER_PROTOCOL, which the vehicle does not know.
Bytes unknown(uint8_t sequence, const Bytes& payload, uint8_t crc_extra = 84) {
    Bytes bytes = {0xFD, 0, 0, 0, sequence, 255, 190, 110, 0, 0};
    bytes[1] = static_cast<uint8_t>(payload.size());
    return test::sealed(bytes + payload, crc_extra);
}

TEST(Parser, skips_whole_what_its_peer_says_in_messages_it_does_not_know) {
    // a frame carried inside another message's payload is data, not an order
    const Bytes payload = Bytes(3, 0) + requestMode(66) + Bytes(5, 0xFE);
    for (int crc_extra = 0; crc_extra < 256; ++crc_extra) {
        VehicleParser parser;

        const auto frames =
            feed(parser, heartbeat(7) + unknown(8, payload, static_cast<uint8_t>(crc_extra)) +
                             heartbeat(9));

        ASSERT_EQ(sequences(frames), (Sequences{7, 9})) << crc_extra;
        ASSERT_EQ(parser.rejected(), 0);
    }
}

TEST(Parser, finds_the_good_frame_after_an_unknown_one_of_its_peer_that_was_cut_short) {
    for (const size_t size : {size_t{30}, size_t{200}}) {
        const Bytes whole = unknown(8, Bytes(size, 0x55));
        for (size_t left = 1; left < whole.size(); ++left) {
            VehicleParser parser;
            const Bytes cut(whole.begin(), whole.begin() + static_cast<long>(left));

            const auto frames =
                feed(parser, heartbeat(1) + cut + heartbeat(2) + heartbeat(3) + heartbeat(4));

            EXPECT_EQ(sequences(frames), (Sequences{1, 2, 3, 4})) << left << " bytes of " << size;
        }
    }
}

TEST(Parser, loses_no_good_frame_to_what_looks_like_the_start_of_a_long_one) {
    const Bytes false_starts[] = {
        {0xFE, 37, 0, 255, 190, 73},              // a known message, its payload missing
        {0xFD, 38, 0, 0, 0, 255, 190, 73, 0, 0},  //
        {0xFE, 255, 0, 3, 4, 110},                // an unknown one of nobody we know
        {0xFD, 255, 0, 0, 0, 3, 4, 110, 0, 0},    //
        {0xFE},
        {0xFD},
        {0xFE, 0xFD, 0xFE, 0xFD, 0xFE},
        {0xFD, 9, 0xFF, 0, 0, 0, 0, 0, 0, 0},
    };
    for (const Bytes& start : false_starts) {
        VehicleParser parser;

        // frames that all fit into the false one's length, and then silence until the next
        const auto frames = feed(parser, start + requestMode(1) + requestMode(2) + heartbeat(3) +
                                             heartbeat(4) + heartbeat(5));

        EXPECT_EQ(sequences(frames), (Sequences{1, 2, 3, 4, 5}))
            << int(start[0]) << " " << start.size();
    }
}

TEST(Parser, finds_the_good_frame_after_one_that_was_cut_short) {
    const Bytes whole = heartbeat(1);
    for (size_t left = 1; left < whole.size(); ++left) {
        VehicleParser parser;
        const Bytes cut(whole.begin(), whole.begin() + static_cast<long>(left));

        // three more, as the cut one's length may reach that far
        const auto frames = feed(parser, cut + heartbeat(2) + heartbeat(3) + heartbeat(4));

        EXPECT_EQ(sequences(frames), (Sequences{2, 3, 4})) << left << " bytes left";
    }
}

TEST(Parser, loses_no_good_frame_in_noise) {
    std::mt19937 random(1);
    VehicleParser parser;
    uint32_t sent = 0, heard = 0;
    for (uint32_t round = 0; round < 20000; ++round) {
        Bytes noise(random() % 40);
        for (uint8_t& byte : noise) {
            byte = static_cast<uint8_t>(random());
            if (random() % 4 == 0) byte = random() % 2 ? 0xFE : 0xFD;
        }
        ++sent;
        heard += static_cast<uint32_t>(feed(parser, noise + heartbeat(1)).size());
    }
    // what is still held back comes out with the next bytes
    heard += static_cast<uint32_t>(feed(parser, Bytes(64, 0)).size());

    EXPECT_EQ(heard, sent);
}

TEST(Parser, a_frame_too_long_for_its_buffer_is_left_out) {
    // a younger dialect's MISSION_ITEM_INT, longer than ours by twenty bytes
    Bytes bytes = {0xFD, 58, 0, 0, 8, 255, 190, 73, 0, 0};
    bytes = test::sealed(bytes + Bytes(58, 1), mavlink::Wire<mavlink::MissionItemInt>::crc_extra);
    VehicleParser parser;

    EXPECT_EQ(sequences(feed(parser, bytes + heartbeat(2))), (Sequences{2}));
}

// The first frame lost a byte on its way: it waits for one of the next and has it.
TEST(Parser, gives_a_torn_frame_up_and_finds_the_whole_one_behind_it) {
    VehicleParser parser;
    Bytes torn = heartbeat(1);
    torn.erase(torn.begin() + 7);
    EXPECT_FALSE(parser.waits());
    EXPECT_TRUE(feed(parser, Bytes(torn.begin(), torn.begin() + 9)).empty());
    EXPECT_TRUE(parser.waits());
    EXPECT_FALSE(parser.giveUp()) << "there is no other";
    EXPECT_FALSE(parser.waits());
    EXPECT_EQ(sequences(feed(parser, heartbeat(2))), (Sequences{2})) << "as if nothing had been";

    // a long header, and a frame within what it says is its payload
    const Bytes item = {0xFE, 37, 0, 255, 190, 73};
    EXPECT_TRUE(feed(parser, item + heartbeat(3)).empty());
    ASSERT_TRUE(parser.giveUp());
    EXPECT_EQ(parser.frame().sequence, 3);
    EXPECT_FALSE(parser.next());
    EXPECT_FALSE(parser.waits());
}

TEST(Parser, drops_extension_bytes_younger_than_ours) {
    Bytes bytes = {0xFD, 12, 0, 0, 8, 255, 190, 43, 0, 0};
    bytes =
        test::sealed(bytes + Bytes(12, 1), mavlink::Wire<mavlink::MissionRequestList>::crc_extra);
    VehicleParser parser;

    const auto read = readOnly<mavlink::MissionRequestList>(parser, bytes);

    EXPECT_EQ(read.mission_type, 1);
}

TEST(Parser, a_peer_that_wants_everything_reads_every_message_at_full_length) {
    mavlink::PeerParser parser;
    for (const mavlink::Accepted& row : mavlink::kAllMessages) {
        const mavlink::Accepted accepted = core::romRead(row);
        Bytes bytes = {0xFD,
                       255,
                       0,
                       0,
                       8,
                       1,
                       1,
                       static_cast<uint8_t>(accepted.id),
                       static_cast<uint8_t>(accepted.id >> 8),
                       0};
        bytes = test::sealed(bytes + Bytes(255, 0xFE), accepted.crc_extra);

        const auto frames = feed(parser, bytes);

        ASSERT_EQ(frames.size(), 1u) << accepted.id;
        EXPECT_EQ(frames[0].id, accepted.id);
        EXPECT_EQ(frames[0].payload, Bytes(255, 0xFE));
    }
}

}  // namespace
