// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include "bench.hpp"
#include "wires.hpp"

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

namespace {

constexpr int kFrame = 0x20, kAge = 0x21;  // age in 0.1 ms
constexpr double kGap_us = 10500;

class Receiver : public Bench {
public:
    Receiver() : Bench("ppm") {
        run_ms(1);
        next_us_ = static_cast<double>(chip.cycle()) / 16;
        chip.captureEdge(wires::kReceiverTimer, true, chip.cycle());
    }

    // Runs through the interval and puts an edge at its end.
    void interval(double us) {
        next_us_ += us;
        const auto cycle = static_cast<uint64_t>(next_us_ * 16);
        ASSERT_TRUE(chip.run(cycle)) << chip.fault();
        chip.captureEdge(wires::kReceiverTimer, true, cycle);
    }
    void frame(const std::vector<double>& channels_us, double gap_us = kGap_us) {
        for (double us : channels_us) interval(us);
        interval(gap_us);
    }
    // The last frame reported, as far as the program has come.
    std::vector<int> channels() const {
        std::vector<int> last;
        for (int i = 1; i <= 8; ++i) last.push_back(words(i).empty() ? -1 : words(i).back());
        return last;
    }
    size_t frames() const { return words(kFrame).size(); }

private:
    double next_us_ = 0;
};

const std::vector<double> kSticks = {1000, 1100, 1200.5, 1300, 1400, 1500, 1600, 2000};

}  // namespace

TEST(HalPpm, decodes_eight_channels_to_the_microsecond) {
    Receiver bench;
    bench.interval(kGap_us);
    for (int i = 0; i < 5; ++i) bench.frame(kSticks);

    EXPECT_EQ(bench.frames(), 5u);
    EXPECT_THAT(bench.channels(), ElementsAre(1000, 1100, 1200, 1300, 1400, 1500, 1600, 2000));
}

TEST(HalPpm, waits_for_a_gap_before_it_accepts_the_first_channel) {
    Receiver bench;
    bench.frame({1100, 1200, 1300, 1400, 1500, 1600, 1700, 1800});
    bench.run_ms(1);
    EXPECT_EQ(bench.frames(), 0u);

    bench.frame(kSticks);
    EXPECT_EQ(bench.frames(), 1u);
}

TEST(HalPpm, accepts_five_channels_at_the_gap_and_leaves_the_others_0) {
    Receiver bench;
    bench.interval(kGap_us);
    bench.frame(kSticks);
    bench.frame({1001, 1101, 1201, 1301, 1401});
    bench.run_ms(1);

    EXPECT_EQ(bench.frames(), 2u);
    EXPECT_THAT(bench.channels(), ElementsAre(1001, 1101, 1201, 1301, 1401, 0, 0, 0));
}

TEST(HalPpm, refuses_four_channels) {
    Receiver bench;
    bench.interval(kGap_us);
    bench.frame({1000, 1100, 1200, 1300});
    bench.run_ms(1);

    EXPECT_EQ(bench.frames(), 0u);
}

TEST(HalPpm, ignores_a_ninth_channel) {
    Receiver bench;
    bench.interval(kGap_us);
    bench.frame({1000, 1100, 1200, 1300, 1400, 1500, 1600, 1700, 1800});
    bench.frame(kSticks);

    EXPECT_EQ(bench.frames(), 2u);
    EXPECT_EQ(bench.channels()[0], 1000);
}

TEST(HalPpm, throws_a_frame_away_that_noise_has_cut) {
    Receiver bench;
    bench.interval(kGap_us);
    bench.frame({1000, 1100, 300, 900.5, 1300, 1400, 1500, 1600});
    bench.run_ms(1);
    EXPECT_EQ(bench.frames(), 0u);

    bench.frame(kSticks);
    EXPECT_EQ(bench.frames(), 1u);
}

TEST(HalPpm, a_missed_edge_begins_no_frame_in_the_middle_of_another) {
    Receiver bench;
    bench.interval(kGap_us);
    bench.frame(kSticks);
    bench.frame({1000 + 1900, 1200, 1300, 1400, 1500, 1600, 2000});
    bench.run_ms(1);
    EXPECT_EQ(bench.frames(), 1u);
    EXPECT_EQ(bench.channels()[2], 1200) << "of the frame before";

    bench.frame(kSticks);
    EXPECT_EQ(bench.frames(), 2u);
}

TEST(HalPpm, a_silence_of_one_turn_of_the_timer_and_a_pulse_is_no_pulse) {
    constexpr double kTurn_us = 32768;
    for (double turns : {1.0, 2.0, 7.0, 256.0}) {
        Receiver bench;
        bench.interval(kGap_us);
        for (int i = 0; i < 4; ++i) bench.interval(1500);
        bench.interval(turns * kTurn_us + 1500);
        for (int i = 0; i < 3; ++i) bench.interval(1500);
        bench.run_ms(1);
        EXPECT_EQ(bench.frames(), 0u) << turns;
    }
}

TEST(HalPpm, decodes_at_every_phase_of_the_timers_overflow) {
    Receiver bench;
    bench.interval(kGap_us);
    for (int i = 0; i < 400; ++i) bench.frame(kSticks, kGap_us + 13 * (i % 100));

    EXPECT_EQ(bench.frames(), 400u);
    for (int i = 0; i < 8; ++i) {
        for (int us : bench.words(i + 1)) EXPECT_NEAR(us, kSticks[i], 0.5);
    }
}

TEST(HalPpm, ages_from_the_last_whole_frame) {
    Receiver bench;
    EXPECT_EQ(bench.report(0x30).word(), 1);  // none yet
    bench.interval(kGap_us);
    bench.frame(kSticks, 200000);

    EXPECT_NEAR(bench.words(kAge).back(), 2000, 110);
    bench.frame(kSticks);
    EXPECT_LT(bench.words(kAge).back(), 250);
}

TEST(HalPpm, carries_the_encoders_failsafe_pulses_unchanged) {
    Receiver bench;
    bench.interval(kGap_us);
    bench.frame({1500, 1500, 900, 1500, 1555, 1500, 1500, 1500});

    EXPECT_THAT(bench.channels(), ElementsAre(1500, 1500, 900, 1500, 1555, 1500, 1500, 1500));
}

TEST(HalPpm, an_edge_is_within_its_cost) {
    Receiver bench;
    bench.interval(kGap_us);
    for (int i = 0; i < 20; ++i) bench.frame(kSticks);

    EXPECT_LE(bench.longest(wires::kReceiverVector), 320u);
}
