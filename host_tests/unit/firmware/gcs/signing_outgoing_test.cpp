// SPDX-License-Identifier: GPL-3.0-or-later
// What is sent: the radio is link1, `second`; USB is link0, `station`.
#include <set>

#include "firmware/gcs/gps_time.hpp"
#include "firmware/gcs/logs.hpp"
#include "hal/clock.hpp"
#include "signing_ground.hpp"

namespace ground {
namespace {

static_assert(firmware::gcs::kLogFrame + mavlink::kSignature <= hal::kLinkRoom,
              "more than a port's buffer");

struct SentFrame {
    Bytes frame, signature;  // the latter empty: none
    uint8_t link() const { return signature[0]; }
    uint64_t time() const {
        uint64_t time = 0;
        for (size_t i = 6; i > 0; --i) time = time << 8 | signature[i];
        return time;
    }
    bool isRight(const Bytes& key = keyOf()) const {
        return signature == signatureOf(frame, key, link(), time());
    }
};

// Of what a link has sent since the last call.
std::vector<SentFrame> sentOn(Station& station) {
    Bytes& out = station.line().out;
    std::vector<SentFrame> frames;
    for (size_t at = 0; at < out.size();) {
        const auto begin = out.begin() + static_cast<std::ptrdiff_t>(at);
        const bool v1 = *begin == mavlink::kMagicV1;
        const auto end = begin + mavlink::frameSize(v1 ? Framing::v1 : Framing::v2, begin[1]);
        const auto next = end + (!v1 && (begin[2] & mavlink::kSignedFlag) != 0 ? 13 : 0);
        frames.push_back({Bytes(begin, end), Bytes(end, next)});
        at = static_cast<size_t>(next - out.begin());
    }
    out.clear();
    return frames;
}

class OutgoingSigning : public Signing {
protected:
    std::vector<SentFrame> sentIn_ms(uint32_t time_ms) {
        sentOn(second);
        run_ms(time_ms);
        return sentOn(second);
    }
    // As a receiver gives it.
    static void setGps(uint16_t week, uint32_t time_ms) {
        firmware::state::mutable_vehicle.home.set = true;
        doubles::vehicle.fix.week = week;
        doubles::vehicle.fix.time_ms = time_ms;
        firmware::state::mutable_vehicle.gps.received_ms = hal::frame_ms();
    }
};

TEST_F(OutgoingSigning, without_a_key_nothing_is_signed) {
    for (const SentFrame& sent : sentIn_ms(3000)) EXPECT_TRUE(sent.signature.empty());
}

TEST_F(OutgoingSigning, with_a_key_everything_is_signed_on_both_links) {
    setKey();
    firmware::state::parameters.streams[0].extra1 = 10;
    firmware::state::parameters.streams[1].position = 10;
    sentOn(station);
    sentOn(second);
    run_ms(2000);
    for (Station* link : {&station, &second}) {
        const auto frames = sentOn(*link);
        EXPECT_GT(frames.size(), 15u);
        for (const SentFrame& sent : frames) {
            ASSERT_EQ(sent.signature.size(), mavlink::kSignature);
            EXPECT_TRUE(sent.isRight());
            EXPECT_EQ(sent.link(), link == &station ? 0 : 1);
        }
    }
}

TEST_F(OutgoingSigning, frames_of_every_length_are_signed) {
    setKey();
    std::set<size_t> sizes;
    for (auto& stream : firmware::state::parameters.streams) memset(&stream, 10, sizeof stream);
    for (const SentFrame& sent : sentIn_ms(3000)) {
        EXPECT_TRUE(sent.isRight()) << sent.frame.size();
        sizes.insert(crypto::blocksOf(static_cast<uint16_t>(32 + sent.frame.size() + 7)));
    }
    EXPECT_EQ(sizes, (std::set<size_t>{1, 2})) << "blocks of the hash";
}

TEST_F(OutgoingSigning, a_link_of_mavlink_1_speaks_mavlink_2_while_there_is_a_key) {
    second.framing = Framing::v1;
    setKey();
    restart();
    EXPECT_FALSE(sentIn_ms(3000).empty());
    firmware::state::parameters.sign_policy = 0;
    run_ms(2000);
    second.line().out.clear();
    run_ms(2000);
    for (const Heard& heard : second.everything()) EXPECT_EQ(heard.framing, Framing::v1);
}

TEST_F(OutgoingSigning, no_time_is_sent_twice) {
    setKey(keyOf(), kPublishedTime);
    firmware::state::parameters.streams[1].extra1 = 50;
    uint64_t last = kPublishedTime;
    for (const SentFrame& sent : sentIn_ms(5000)) {
        EXPECT_GT(sent.time(), last);
        last = sent.time();
    }
    EXPECT_NEAR(static_cast<double>(last - kPublishedTime), 6.0 * kSecond, 1.0 * kSecond);
}

TEST_F(OutgoingSigning, times_go_on_rising_over_restarts) {
    setKey(keyOf(), kPublishedTime);
    uint64_t last = kPublishedTime;
    for (int i = 0; i < 6; ++i) {
        for (const SentFrame& sent : sentIn_ms(45000)) {
            EXPECT_GT(sent.time(), last);
            last = sent.time();
        }
        restart();
    }
    const uint64_t most_ahead = 6 * 31 * kSecond;
    EXPECT_LT(last, kPublishedTime + 6 * 46 * kSecond + most_ahead);
}

// The last frame before it may have the very step of time that was stored.
TEST_F(OutgoingSigning, times_rise_over_a_restart_at_any_moment) {
    setKey(keyOf(), kPublishedTime);
    firmware::state::parameters.streams[1].extra1 = 50;
    uint64_t last = kPublishedTime;
    for (uint32_t ran_ms = 29'000; ran_ms < 31'500; ran_ms += 60) {
        for (const SentFrame& sent : sentIn_ms(ran_ms)) {
            ASSERT_GT(sent.time(), last) << "after " << ran_ms;
            last = sent.time();
        }
        restart();
        firmware::state::parameters.streams[1].extra1 = 50;
    }
}

TEST_F(OutgoingSigning, a_board_that_has_never_signed_begins_at_the_time_it_has_heard) {
    setKey(keyOf(), kPublishedTime);
    for (uint16_t i = 0; i < storage::kSentTime.size; ++i)
        fakes::setEepromCell(static_cast<uint16_t>(storage::kSentTime.begin + i), 0xFF);
    restart();
    const auto sent = sentIn_ms(2000);
    ASSERT_FALSE(sent.empty());
    EXPECT_GE(sent.front().time(), kPublishedTime);
    EXPECT_LT(sent.front().time(), kPublishedTime + kMinute);
}

TEST_F(OutgoingSigning, the_time_is_stored_once_in_half_a_minute) {
    setKey();
    run_ms(1000);
    const uint32_t before = fakes::eepromWrites();
    run_ms(250'000);
    EXPECT_LE(fakes::eepromWrites() - before, 6u * 9);
    EXPECT_GT(fakes::eepromWrites() - before, 6u * 3) << "not at all";
}

TEST_F(OutgoingSigning, the_time_is_that_of_the_gps_when_it_is_later) {
    setKey(keyOf(), kPublishedTime);
    // 2026-11-27 08:00:00 UTC: GPS week 2446 began on the 22nd, 18 s before midnight
    setGps(2446, (5 * 24 + 8) * 3600'000 + 18'000);
    const uint64_t expected = uint64_t{1795766400 - 1420070400} * 100'000;
    const auto sent = sentIn_ms(2000);
    ASSERT_FALSE(sent.empty());
    EXPECT_NEAR(static_cast<double>(sent.back().time()), static_cast<double>(expected),
                3.0 * kSecond);
    setGps(2400, 0);
    EXPECT_GE(sentIn_ms(2000).back().time(), expected) << "never back";
}

TEST_F(OutgoingSigning, the_time_is_that_of_the_ground_station_when_it_is_later) {
    setKey();
    EXPECT_EQ(answers(signedPing(kPublishedTime)), 1u);
    const auto sent = sentIn_ms(2000);
    ASSERT_FALSE(sent.empty());
    EXPECT_NEAR(static_cast<double>(sent.back().time()), static_cast<double>(kPublishedTime),
                3.0 * kSecond);
}

TEST_F(OutgoingSigning, a_new_key_is_used_at_once_and_none_ends_it) {
    setKey();
    setKey(keyOf(9), kPublishedTime);
    run_ms(1000);
    for (const SentFrame& sent : sentIn_ms(2000)) EXPECT_TRUE(sent.isRight(keyOf(9)));
    station.send(setup(Bytes(32, 0)));
    run_ms(1000);
    for (const SentFrame& sent : sentIn_ms(2000)) EXPECT_TRUE(sent.signature.empty());
}

TEST_F(OutgoingSigning, a_policy_of_0_sends_as_without_a_key) {
    setKey();
    firmware::state::parameters.sign_policy = 0;
    run_ms(1000);
    for (const SentFrame& sent : sentIn_ms(2000)) EXPECT_TRUE(sent.signature.empty());
}

// On a line that takes 60 bytes in 10 ms, a quarter of which is room for signatures.
TEST_F(OutgoingSigning, nothing_is_lost_on_a_slow_line) {
    setKey();
    second.line().endless = false;
    second.line().receive(signedFrame(mavlink::ParamRequestList{1, 1}, kPublishedTime));
    std::set<uint16_t> indices;
    for (int i = 0; i < 6000; ++i) {
        run_ms(10);
        second.line().room =
            static_cast<uint8_t>(std::min<int>(hal::kLinkRoom, second.line().room + 60));
        for (const SentFrame& sent : sentOn(second)) {
            EXPECT_TRUE(sent.isRight());
            if (sent.frame[7] != 22) continue;  // PARAM_VALUE
            indices.insert(static_cast<uint16_t>(sent.frame[16] | sent.frame[17] << 8));
        }
    }
    EXPECT_GT(indices.size(), 200u);
    EXPECT_EQ(*indices.rbegin() + 1u, indices.size()) << "every index";
}

// The hash is shared: what is being checked goes on when the port is full of frames that wait for
// the hash.
TEST_F(OutgoingSigning, a_full_port_and_an_order_do_not_wait_for_each_other) {
    setKey();
    firmware::gcs::Link& link = firmware::gcs::links[1];
    second.line().receive(signedPing(kPublishedTime));
    for (int i = 0; i < 4; ++i) firmware::gcs::telemetryPump();
    while (firmware::gcs::send(link, mavlink::CommandAck{})) {
    }
    EXPECT_EQ(answers({}), 1u);
    EXPECT_EQ(second.line().held.size(), 0u);
}

TEST_F(OutgoingSigning, every_order_is_answered_beside_all_streams_at_50_hz) {
    setKey();
    for (auto& stream : firmware::state::parameters.streams) memset(&stream, 50, sizeof stream);
    second.line().endless = false;
    size_t heard = 0;
    for (int i = 1; i <= 200; ++i) {
        second.line().receive(signedPing(kPublishedTime + static_cast<uint64_t>(i) * kSecond));
        for (int step = 0; step < 20; ++step) {
            run_ms(10);
            second.line().room =
                static_cast<uint8_t>(std::min<int>(hal::kLinkRoom, second.line().room + 57));
        }
        heard += second.all<mavlink::Ping>().size();
    }
    EXPECT_EQ(heard, 200u);
}

TEST_F(OutgoingSigning, a_slow_eeprom_delays_and_loses_nothing) {
    fakes::setEepromSlow(true);
    setKey();
    firmware::state::parameters.streams[1].extra1 = 10;
    run_ms(1000);
    const auto frames = sentIn_ms(2000);
    EXPECT_GE(frames.size(), 20u);
    for (size_t i = 0; i < frames.size(); ++i) {
        EXPECT_TRUE(frames[i].isRight());
        if (i > 0) {
            EXPECT_EQ(frames[i].frame[4], static_cast<uint8_t>(frames[i - 1].frame[4] + 1));
        }
    }
}

}  // namespace
}  // namespace ground
