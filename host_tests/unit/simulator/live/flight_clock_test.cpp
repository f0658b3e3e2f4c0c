// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/live/flight_clock.hpp"

#include <gtest/gtest.h>

using namespace simulator::live;
using std::chrono::milliseconds;

namespace {

class Clock : public testing::Test {
protected:
    double wait_ms(int now_ms, uint64_t until_ms) {
        const auto wait = clock.wait(start + milliseconds(now_ms), until_ms * 1000);
        return wait ? std::chrono::duration<double, std::milli>(*wait).count() : -1;
    }
    FlightClock clock;
    const FlightClock::Clock::time_point start = FlightClock::Clock::now();
};

}  // namespace

TEST_F(Clock, goes_at_real_time) {
    clock.setSpeed(1, start, 0);

    EXPECT_EQ(wait_ms(0, 10), 10);
    EXPECT_EQ(wait_ms(4, 10), 6);
    EXPECT_EQ(wait_ms(12, 10), 0);
}

TEST_F(Clock, goes_at_a_multiple_of_it_from_then_on) {
    clock.setSpeed(1, start, 0);
    clock.setSpeed(5, start + milliseconds(1000), 1'000'000);

    EXPECT_EQ(wait_ms(1000, 1100), 20);
    clock.setSpeed(0.5, start + milliseconds(1000), 1'000'000);
    EXPECT_EQ(wait_ms(1000, 1100), 200);
}

TEST_F(Clock, goes_as_fast_as_it_can) {
    clock.setSpeed(0, start, 0);

    EXPECT_EQ(wait_ms(0, 1'000'000), 0);
}

TEST_F(Clock, stands_still_while_paused_and_goes_on_from_there) {
    clock.setSpeed(1, start, 0);
    clock.pause(true, start + milliseconds(100), 100'000);

    EXPECT_EQ(wait_ms(5000, 110), -1);
    EXPECT_TRUE(clock.paused());
    clock.pause(false, start + milliseconds(9000), 100'000);
    EXPECT_EQ(wait_ms(9000, 110), 10);
}

TEST_F(Clock, catches_up_what_is_little_and_gives_up_what_is_much) {
    clock.setSpeed(1, start, 0);

    EXPECT_EQ(wait_ms(900, 100), 0);
    EXPECT_EQ(wait_ms(900, 910), 10);  // 800 ms late, caught up
    EXPECT_EQ(wait_ms(3910, 910), 0);  // 3 s late
    EXPECT_EQ(wait_ms(3910, 920), 10);
}

TEST_F(Clock, measures_how_fast_it_goes) {
    clock.setSpeed(0, start, 0);

    EXPECT_EQ(clock.measured(start + milliseconds(100), 5'000'000), 0);  // not yet
    EXPECT_DOUBLE_EQ(clock.measured(start + milliseconds(1000), 30'000'000), 30);
    EXPECT_DOUBLE_EQ(clock.measured(start + milliseconds(1100), 99'000'000), 30);
}
