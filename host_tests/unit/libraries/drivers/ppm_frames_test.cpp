// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivers/ppm_frames.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace {

using Widths_us = std::vector<int>;

constexpr int kGap_us = 8000;
const Widths_us kSticks = {1000, 1100, 1200, 1300, 1400, 1500, 1600, 1700};

class PpmFrames : public testing::Test {
protected:
    PpmFrames() { decoder_.reset(); }

    bool edge(int width_us) { return decoder_.edge(static_cast<uint16_t>(2 * width_us), false); }

    // The edges of a frame, the last of them behind the gap that ends it. How many were complete.
    int frame(const Widths_us& widths) {
        int complete = 0;
        for (int width : widths) complete += edge(width);
        return complete + edge(kGap_us);
    }
    void begin() { edge(kGap_us); }
    void frames(int count, const Widths_us& widths) {
        while (count-- > 0) frame(widths);
    }
    static Widths_us us(const uint16_t* halves) {
        if (halves == nullptr) return {};
        Widths_us widths(halves, halves + drivers::PpmFrames::kChannels);
        for (int& width : widths) width /= 2;
        return widths;
    }
    Widths_us newest() const { return us(decoder_.newest()); }
    // The newest so far, taken whenever one is there.
    Widths_us whole() {
        const Widths_us taken = us(decoder_.takeWhole());
        if (!taken.empty()) whole_ = taken;
        return whole_;
    }
    bool wholeIsNew() { return decoder_.takeWhole() != nullptr; }

    static Widths_us doubled(Widths_us widths, size_t channel) {
        widths[channel] /= 2;
        widths.insert(widths.begin() + static_cast<long>(channel), widths[channel]);
        return widths;
    }
    static Widths_us only(Widths_us widths, size_t count) {
        widths.resize(count);
        return widths;
    }

private:
    drivers::PpmFrames decoder_{};
    Widths_us whole_;
};

TEST_F(PpmFrames, takes_nothing_before_the_first_gap) {
    for (int width : kSticks) EXPECT_FALSE(edge(width));
    EXPECT_TRUE(whole().empty());
}

TEST_F(PpmFrames, is_complete_with_the_eighth_channel_and_whole_with_the_gap) {
    begin();
    for (size_t i = 0; i < 8; ++i) EXPECT_EQ(edge(kSticks[i]), i == 7);
    EXPECT_EQ(newest(), kSticks);
    EXPECT_TRUE(whole().empty());
    EXPECT_FALSE(edge(kGap_us));
    EXPECT_EQ(whole(), kSticks);
}

TEST_F(PpmFrames, gives_each_whole_frame_once) {
    begin();
    frames(2, kSticks);
    EXPECT_TRUE(wholeIsNew());
    EXPECT_FALSE(wholeIsNew());
    frame(doubled(kSticks, 2));
    EXPECT_FALSE(wholeIsNew());
    frame(kSticks);
    EXPECT_TRUE(wholeIsNew());
}

TEST_F(PpmFrames, gives_0_for_channels_that_are_not_sent) {
    begin();
    EXPECT_EQ(frame({1000, 1100, 1200, 1300, 1400}), 1);
    EXPECT_EQ(newest(), (Widths_us{1000, 1100, 1200, 1300, 1400, 0, 0, 0}));
    EXPECT_EQ(whole(), newest());
    EXPECT_EQ(frame({1000, 1100, 1200, 1300}), 0) << "fewer are no frame";
}

TEST_F(PpmFrames, is_not_whole_with_an_edge_too_many_in_any_channel_however_often) {
    begin();
    frames(3, kSticks);
    const Widths_us others = {1900, 1900, 1900, 1900, 1900, 1900, 1900, 1900};
    for (size_t channel = 0; channel < 8; ++channel) {
        frame(doubled(others, channel));
        EXPECT_EQ(whole(), kSticks) << channel;
        EXPECT_NE(newest(), kSticks) << channel;
        frames(1, kSticks);
    }
    frames(7, doubled(others, 3));
    EXPECT_EQ(whole(), kSticks);
    frame(others);
    EXPECT_EQ(whole(), others);
}

TEST_F(PpmFrames, is_not_whole_with_two_short_channels_read_as_one) {
    begin();
    frames(3, kSticks);
    EXPECT_EQ(frame({1000, 2300, 1300, 1400, 1500, 1600, 1700}), 1) << "at the gap";
    EXPECT_EQ(newest()[1], 2300);
    EXPECT_EQ(whole(), kSticks);
}

TEST_F(PpmFrames, stays_whole_while_two_frames_of_another_number_are_received) {
    begin();
    frame(kSticks);
    for (int i = 0; i < 7; ++i) {  // every buffer is used in turn
        frame(doubled(kSticks, static_cast<size_t>(i)));
        EXPECT_EQ(whole(), kSticks) << i;
    }
}

TEST_F(PpmFrames, learns_another_number_of_channels_when_it_lasts) {
    begin();
    Widths_us nine = kSticks;
    nine.push_back(1800);
    frames(3, kSticks);
    const Widths_us six = only({1900, 1900, 1900, 1900, 1900, 1900, 1900, 1900}, 6);
    frames(40, six);
    EXPECT_EQ(whole(), kSticks);
    frame(six);
    EXPECT_EQ(whole(), (Widths_us{1900, 1900, 1900, 1900, 1900, 1900, 0, 0}));
    frames(41, nine);
    EXPECT_EQ(whole(), kSticks);
}

TEST_F(PpmFrames, learns_nothing_from_the_frame_in_whose_middle_it_began) {
    for (int i = 0; i < 5; ++i) edge(1500);
    edge(kGap_us);
    EXPECT_TRUE(whole().empty());
    frame(kSticks);
    EXPECT_EQ(whole(), kSticks);
}

TEST_F(PpmFrames, learns_through_frames_that_are_broken) {
    begin();
    frame(doubled(kSticks, 2));  // the first of all
    for (int i = 0; i < 8; ++i) {
        frames(7, kSticks);
        frame(doubled(kSticks, 4));
    }
    EXPECT_EQ(whole(), kSticks);
}

TEST_F(PpmFrames, a_frame_that_noise_has_cut_is_neither_complete_nor_whole) {
    begin();
    frames(2, kSticks);
    const Widths_us shifted = doubled(kSticks, 7);
    frame(shifted);
    EXPECT_EQ(frame({1900, 300, 1900, 1900, 1900, 1900, 1900, 1900}), 0);
    EXPECT_EQ(whole(), kSticks) << "the frame before it was not whole";
}

TEST_F(PpmFrames, two_channels_whose_edge_was_missed_are_no_gap) {
    begin();
    frames(2, kSticks);
    EXPECT_EQ(frame({2900, 1200, 1300, 1400, 1500, 1600, 2000}), 0);
    EXPECT_EQ(newest(), kSticks);
}

TEST_F(PpmFrames, counts_no_further_than_it_can) {
    begin();
    frames(2, kSticks);
    for (int i = 0; i < 256 + 8; ++i) edge(1900);
    edge(kGap_us);
    EXPECT_EQ(whole(), kSticks);
}

}  // namespace
