// SPDX-License-Identifier: GPL-3.0-or-later
// The natively compiled board with a firmware that is nothing but a wait.
#include "simulator/native/native_board.hpp"

#include <gtest/gtest.h>

#include "hal/clock.hpp"
#include "hal/imu_interrupt.hpp"

namespace {
int loops_waited = 0;
bool the_time_came = false;
}  // namespace

// Work waits all the time, and is done when the clock says so: as a log that is sent slowly.
namespace firmware {
namespace app {
void setup();
void loop();
void setup() {}
void loop() {
    ++loops_waited;
    if (hal::now_ms() % 100 < 90) return hal::idle([] { return true; });
    the_time_came = true;
    hal::idle([] { return false; });
}
}  // namespace app
}  // namespace firmware

namespace hal {
bool imuDataReady() { return false; }
}  // namespace hal

TEST(NativeBoard, lets_time_pass_for_firmware_that_waits_for_it_without_resting) {
    simulator::NativeBoard board{simulator::WorldOptions()};

    EXPECT_TRUE(board.runUntil(200'000));
    EXPECT_TRUE(the_time_came);
    EXPECT_GE(board.time_us(), 200'000u);
    EXPECT_GT(loops_waited, 1000);  // as fast as ever at first

    // the linker put no marks around the variables of this firmware: they cannot be put back
    board.reset();
    EXPECT_FALSE(board.runUntil(300'000));
    EXPECT_EQ(board.fault(), "reset: this program's firmware cannot start twice");
    EXPECT_EQ(board.restarts(), 0u);
}
