// SPDX-License-Identifier: GPL-3.0-or-later
#include "control/stall.hpp"

#include <gtest/gtest.h>

#include "core/maths.hpp"

namespace {

using control::Stall;
using control::StallSigns;
using Phase = Stall::Phase;

StallSigns signs(float elevator, float short_deg, float rate_dps, bool slow = false,
                 bool sinks = true) {
    return {core::Ratio(elevator),
            core::Angle(core::radians(short_deg)),
            core::BodyRate(core::radians(rate_dps)),
            slow,
            sinks,
            false};
}
// The nose up where it is demanded, by a quarter of the elevator, and the airplane falls.
StallSigns falling(float elevator, bool falls = true) {
    StallSigns made = signs(elevator, 2, 0);
    made.falls = made.slow = falls;
    return made;
}
// As foam trainers fall: full up, the nose 30 degrees short and hardly turning.
const StallSigns kStalled = signs(1, 30, -5);

class StallTest : public testing::Test {
protected:
    Phase after(float seconds, const StallSigns& signs) {
        for (int i = 0; i < seconds * 20; ++i) stall.run(signs);
        return stall.phase();
    }
    void breakIt() { ASSERT_EQ(after(0.35f, kStalled), Phase::breaking); }
    void pullOut() {
        breakIt();
        ASSERT_EQ(after(0.4f, kStalled), Phase::pulling_out);
    }
    Stall stall;
};

TEST_F(StallTest, is_noticed_in_a_third_of_a_second) {
    EXPECT_EQ(after(0.3f, kStalled), Phase::flying);
    EXPECT_EQ(after(0.05f, kStalled), Phase::breaking);
}

TEST_F(StallTest, is_noticed_while_the_elevator_is_still_on_its_way_up_when_it_is_slow) {
    EXPECT_EQ(after(1, signs(0.45f, 10, -16)), Phase::flying);
    EXPECT_EQ(after(1, signs(0.45f, 10, -16, true)), Phase::breaking);
}

TEST_F(StallTest, is_noticed_although_gusts_lift_the_nose_for_a_moment) {
    for (int i = 0; i < 10 && stall.phase() == Phase::flying; ++i) {
        after(0.1f, kStalled);
        after(0.05f, signs(1, 28, 40));
    }
    EXPECT_EQ(stall.phase(), Phase::breaking);
}

TEST_F(StallTest, is_noticed_where_the_airplane_falls_with_its_nose_held_up) {
    EXPECT_EQ(after(0.3f, falling(0.25f)), Phase::flying);
    EXPECT_EQ(after(0.05f, falling(0.25f)), Phase::breaking);
    EXPECT_EQ(after(1.4f, falling(-0.1f)), Phase::breaking) << "until it flies";
    EXPECT_EQ(after(0.1f, falling(-0.1f)), Phase::pulling_out);
}

TEST_F(StallTest, is_none_where_it_falls_without_elevator) {
    EXPECT_EQ(after(2, falling(0.1f)), Phase::flying);
}

TEST_F(StallTest, is_none_while_the_nose_follows) {
    EXPECT_EQ(after(2, signs(1, 40, 30)), Phase::flying);
}

TEST_F(StallTest, is_none_with_a_nose_that_is_where_it_should_be) {
    EXPECT_EQ(after(2, signs(1, 4, 0)), Phase::flying);
}

TEST_F(StallTest, is_none_above_what_is_demanded) {
    EXPECT_EQ(after(2, signs(-1, -30, 0)), Phase::flying);
}

TEST_F(StallTest, is_none_without_much_elevator) {
    EXPECT_EQ(after(2, signs(0.3f, 30, 0, true)), Phase::flying);
}

TEST_F(StallTest, is_none_on_a_runway) {
    EXPECT_EQ(after(2, signs(1, 20, 0, true, false)), Phase::flying);
}

TEST_F(StallTest, a_pull_that_takes_its_time_to_begin_is_none) {
    after(0.25f, signs(1, 45, -20));
    EXPECT_EQ(after(0.6f, signs(1, 40, 50)), Phase::flying);
}

TEST_F(StallTest, is_broken_for_longer_while_it_is_slow) {
    breakIt();
    StallSigns slow = kStalled;
    slow.slow = true;
    EXPECT_EQ(after(1.4f, slow), Phase::breaking);
    EXPECT_EQ(after(0.1f, slow), Phase::pulling_out);
}

TEST_F(StallTest, ends_when_the_nose_is_back) {
    pullOut();
    EXPECT_EQ(after(1, signs(0.3f, 20, 25)), Phase::pulling_out);
    EXPECT_EQ(after(0.05f, signs(0.1f, 2, 10)), Phase::flying);
}

TEST_F(StallTest, does_not_end_before_there_is_speed) {
    pullOut();
    EXPECT_EQ(after(2, signs(0.1f, 2, 0, true)), Phase::pulling_out);
    EXPECT_EQ(after(0.05f, signs(0.1f, 2, 0)), Phase::flying);
}

TEST_F(StallTest, ends_without_speed_when_that_is_never_measured) {
    pullOut();
    EXPECT_EQ(after(5.9f, signs(0.3f, 20, 25, true)), Phase::pulling_out);
    EXPECT_EQ(after(0.1f, signs(0.3f, 20, 25, true)), Phase::flying);
}

TEST_F(StallTest, is_broken_again_when_it_returns) {
    pullOut();
    EXPECT_EQ(after(0.35f, kStalled), Phase::breaking);
}

}  // namespace
