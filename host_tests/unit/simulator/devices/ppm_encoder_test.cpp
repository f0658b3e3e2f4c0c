// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/devices/ppm_encoder.hpp"

#include <gtest/gtest.h>

#include <vector>

using simulator::PpmEncoder;

namespace {

constexpr std::array<uint16_t, 8> kSticks = {1500, 1400, 1100, 1600, 1555, 1234, 1800, 2000};

// The widths between the next `count` + 1 edges, in microseconds.
std::vector<double> widths(PpmEncoder& radio, int count) {
    std::vector<double> out;
    for (int i = 0; i < count && radio.nextEdge_us_x2() != UINT64_MAX; ++i) {
        const uint64_t from = radio.nextEdge_us_x2();
        radio.passEdge();
        if (radio.nextEdge_us_x2() != UINT64_MAX)
            out.push_back(static_cast<double>(radio.nextEdge_us_x2() - from) / 2);
    }
    return out;
}

}  // namespace

TEST(PpmEncoder, is_silent_until_the_transmitter_was_seen) {
    PpmEncoder radio;
    EXPECT_EQ(radio.nextEdge_us_x2(), UINT64_MAX);
    radio.sticks(kSticks, false);
    EXPECT_EQ(radio.nextEdge_us_x2(), UINT64_MAX);
    radio.advanceTo(1'000'000);
    radio.sticks(kSticks, true);
    EXPECT_EQ(radio.nextEdge_us_x2(), 2 * 1'010'900u);
}

TEST(PpmEncoder, sends_eight_channels_and_a_gap) {
    PpmEncoder radio;
    radio.sticks(kSticks, true);
    const std::vector<double> frame = {1500, 1400, 1100, 1600, 1555, 1234, 1800, 2000, 10'900};
    for (int i = 0; i < 3; ++i) EXPECT_EQ(widths(radio, 9), frame);
}

TEST(PpmEncoder, takes_new_sticks_with_the_next_frame) {
    PpmEncoder radio;
    radio.sticks(kSticks, true);
    EXPECT_EQ(widths(radio, 2), (std::vector<double>{1500, 1400}));
    auto moved = kSticks;
    moved.fill(1000);
    radio.sticks(moved, true);
    EXPECT_EQ(widths(radio, 8),
              (std::vector<double>{1100, 1600, 1555, 1234, 1800, 2000, 10'900, 1000}));
}

TEST(PpmEncoder, finishes_the_frame_and_falls_silent_without_a_transmitter) {
    PpmEncoder radio;
    radio.sticks(kSticks, true);
    widths(radio, 3);
    radio.sticks(kSticks, false);
    EXPECT_EQ(widths(radio, 20).size(), 5u);
    EXPECT_EQ(radio.nextEdge_us_x2(), UINT64_MAX);
    radio.advanceTo(500'000);
    radio.sticks(kSticks, true);
    EXPECT_EQ(radio.nextEdge_us_x2(), 2 * 510'900u);
}

TEST(PpmEncoder, of_an_older_version_sends_failsafe_values) {
    PpmEncoder radio(PpmEncoder::Loss::failsafe_values);
    radio.sticks(kSticks, true);
    widths(radio, 9);
    radio.sticks({}, false);
    EXPECT_EQ(widths(radio, 9),
              (std::vector<double>{1500, 1500, 900, 1500, 1555, 1234, 1800, 2000, 10'900}));
}

TEST(PpmEncoder, limits_what_a_receiver_can_not_send) {
    PpmEncoder radio;
    auto wild = kSticks;
    wild[0] = 0;
    wild[1] = 5000;
    radio.sticks(wild, true);
    EXPECT_EQ(widths(radio, 2), (std::vector<double>{900, 2100}));
}
