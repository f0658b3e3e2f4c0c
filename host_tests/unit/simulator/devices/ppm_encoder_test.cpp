// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/devices/ppm_encoder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

using simulator::FaultKind;
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

// The frames of this time from the next edge on, each with its gap.
std::vector<std::vector<double>> frames(PpmEncoder& radio, double time_s) {
    std::vector<std::vector<double>> out(1);
    const auto end_x2 = static_cast<uint64_t>(time_s * 2e6);
    while (radio.nextEdge_us_x2() < end_x2) {
        radio.advanceTo(radio.nextEdge_us_x2() / 2);
        for (const double width : widths(radio, 1)) out.back().push_back(width);
        if (!out.back().empty() && out.back().back() >= PpmEncoder::kGap_us) out.emplace_back();
    }
    out.pop_back();
    return out;
}

const std::vector<double> kSent = {1500, 1400, 1100, 1600, 1555, 1234, 1800, 2000, 10'900};
const std::vector<double> kFailsafe = {1500, 1500, 900, 1500, 1555, 1500, 1500, 1500, 10'900};

PpmEncoder running() {
    PpmEncoder radio;
    radio.sticks(kSticks, true);
    frames(radio, 1);
    return radio;
}

TEST(PpmEncoder, sends_all_eight_failsafe_values_250_ms_after_the_last_input) {
    for (const bool by_fault : {false, true}) {
        PpmEncoder radio = running();
        by_fault ? radio.fail(FaultKind::lost, 1'000'000) : radio.sticks({}, false);
        const auto after = frames(radio, 2);
        EXPECT_EQ(after[0], kSent);
        EXPECT_EQ(std::count(after.begin(), after.end(), kSent), 11) << "22.4 ms each";
        EXPECT_EQ(after.back(), kFailsafe);
        by_fault ? radio.fail(FaultKind::none, 2'000'000) : radio.sticks(kSticks, true);
        EXPECT_EQ(frames(radio, 3).back(), kSent);
    }
}

TEST(PpmEncoder, of_version_2_3_16_holds_channels_5_to_8) {
    PpmEncoder radio = running();
    radio.fail(FaultKind::held, 1'000'000);
    const auto after = frames(radio, 3);
    EXPECT_NEAR(static_cast<double>(std::count(after.begin(), after.end(), kSent)), 45, 1);
    EXPECT_EQ(after.back(),
              (std::vector<double>{1500, 1500, 900, 1500, 1555, 1234, 1800, 2000, 10'900}));
}

TEST(PpmEncoder, that_is_dead_gives_no_edge) {
    PpmEncoder radio = running();
    widths(radio, 3);
    radio.fail(FaultKind::silent, 1'000'000);
    EXPECT_EQ(widths(radio, 20).size(), 5u);
    EXPECT_EQ(radio.nextEdge_us_x2(), UINT64_MAX);
    radio.fail(FaultKind::none, 1'500'000);
    EXPECT_EQ(radio.nextEdge_us_x2(), 2 * 1'510'900u);
}

TEST(PpmEncoder, without_wire_3_alone_latches_the_throttle_at_900) {
    PpmEncoder radio = running();
    radio.fail(FaultKind::throttle_lost, 1'000'000);
    const auto after = frames(radio, 2);
    std::vector<double> expected = kSent;
    EXPECT_EQ(after[7], expected);
    expected[2] = 900;
    EXPECT_EQ(after[9], expected);
    EXPECT_EQ(after.back(), expected);
}

TEST(PpmEncoder, ignores_pulses_that_are_too_short_or_too_long) {
    PpmEncoder radio = running();
    auto wild = kSticks;
    wild[0] = 899;
    wild[1] = 2101;
    radio.sticks(wild, true);
    EXPECT_EQ(frames(radio, 2).back(), kSent);
}

TEST(PpmEncoder, merges_two_channels_when_an_edge_is_missed) {
    PpmEncoder radio = running();
    radio.fail(FaultKind::missed_edge, 1'000'000);
    const auto all = frames(radio, 10);
    const auto whole = std::count(all.begin(), all.end(), kSent);
    EXPECT_GT(whole, 0.75 * static_cast<double>(all.size()));
    EXPECT_LT(whole, 0.92 * static_cast<double>(all.size()));
    const auto merged = std::find_if(all.begin(), all.end(), [](const auto& frame) {
        return frame.size() == 8 && frame[0] == 2900;
    });
    EXPECT_NE(merged, all.end());
}

TEST(PpmEncoder, cuts_a_channel_in_two_by_an_extra_edge) {
    PpmEncoder radio = running();
    radio.fail(FaultKind::extra_edge, 1'000'000);
    const auto all = frames(radio, 10);
    const auto cut = std::find_if(all.begin(), all.end(), [](const auto& frame) {
        return frame.size() == 10 && frame[0] == 750 && frame[1] == 750 && frame[2] == 1400;
    });
    EXPECT_NE(cut, all.end());
}

TEST(PpmEncoder, passes_a_receivers_own_sum_through) {
    PpmEncoder radio = running();
    radio.fail(FaultKind::nine_channels, 1'000'000);
    EXPECT_EQ(frames(radio, 2).back().size(), 10u);
    radio.fail(FaultKind::wide, 2'000'000);
    EXPECT_EQ(frames(radio, 3).back(),
              (std::vector<double>{1500, 1300, 700, 1700, 1610, 968, 2100, 2300, 10'900}));
    radio.sticks({}, false);
    EXPECT_EQ(frames(radio, 3.2).front()[7], 2300) << "what was received last is what is repeated";
}

TEST(PpmEncoder, starts_with_failsafe_values_after_a_brown_out) {
    PpmEncoder radio = running();
    radio.sticks({}, false);
    radio.power(false, 1'000'000);
    EXPECT_EQ(radio.nextEdge_us_x2(), UINT64_MAX);
    radio.power(true, 1'100'000);
    radio.advanceTo(1'349'999);
    EXPECT_EQ(radio.nextEdge_us_x2(), UINT64_MAX);
    radio.advanceTo(1'350'000);
    EXPECT_EQ(radio.nextEdge_us_x2(), 2 * 1'382'768u);
    EXPECT_EQ(frames(radio, 2).back(), kFailsafe);
}

TEST(PpmEncoder, waits_for_an_input_after_a_power_on) {
    PpmEncoder radio = running();
    radio.sticks({}, false);
    radio.power(false, 1'000'000);
    radio.forgetBrownOut();
    radio.power(true, 1'100'000);
    radio.advanceTo(9'000'000);
    EXPECT_EQ(radio.nextEdge_us_x2(), UINT64_MAX);
    radio.sticks(kSticks, true);
    EXPECT_NE(radio.nextEdge_us_x2(), UINT64_MAX);
}
