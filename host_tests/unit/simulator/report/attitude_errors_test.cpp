// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/report/attitude_errors.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace simulator;

namespace {

constexpr float kDegree = static_cast<float>(M_PI / 180);

// Rolls 100 degrees a second, from level at time 0.
Truth rolling(uint64_t time_us) {
    Truth truth{};
    truth.time_us = time_us;
    truth.roll_rad = 100 * M_PI / 180 * static_cast<double>(time_us) * 1e-6;
    truth.yaw_rad = 359.5 * M_PI / 180;
    return truth;
}

mavlink::Attitude reported(uint32_t time_ms, float roll_deg, float yaw_deg) {
    mavlink::Attitude attitude{};
    attitude.time_boot_ms = time_ms;
    attitude.roll = roll_deg * kDegree;
    attitude.yaw = yaw_deg * kDegree;
    return attitude;
}

void watch(AttitudeErrors& errors, uint64_t until_us) {
    for (uint64_t time_us = 0; time_us <= until_us; time_us += 10'000)
        errors.watch(rolling(time_us));
}

}  // namespace

TEST(AttitudeErrors, are_those_of_the_messages_time) {
    AttitudeErrors errors;
    watch(errors, 200'000);
    errors.take(reported(105, 10.5f, 0.5f), 0);  // and 20 degrees by now

    EXPECT_NEAR(*errors.roll_deg.rms(), 0, 1e-3);
    EXPECT_NEAR(*errors.pitch_deg.rms(), 0, 1e-3);
    EXPECT_NEAR(*errors.yaw_deg.rms(), 1, 1e-3);
}

TEST(AttitudeErrors, reckon_with_the_time_that_the_bootloader_takes) {
    AttitudeErrors errors;
    watch(errors, 200'000);
    errors.take(reported(40, 10.5f, 0), 65'000);

    EXPECT_NEAR(*errors.roll_deg.rms(), 0, 1e-3);
}

TEST(AttitudeErrors, count_a_message_once) {
    AttitudeErrors errors;
    watch(errors, 200'000);
    errors.take(reported(105, 10.5f, 0), 0);
    errors.take(reported(105, 30, 0), 0);

    EXPECT_NEAR(*errors.roll_deg.max(), 0, 1e-3);
}

TEST(AttitudeErrors, do_not_count_what_stands) {
    AttitudeErrors errors;
    for (uint64_t time_us = 0; time_us <= 200'000; time_us += 10'000) {
        Truth truth = rolling(time_us);
        truth.on_ground = true;
        errors.watch(truth);
    }
    errors.take(reported(105, 0, 0), 0);

    EXPECT_FALSE(errors.roll_deg.rms());
}

TEST(AttitudeErrors, pass_over_a_clock_that_was_begun_anew) {
    AttitudeErrors errors;
    watch(errors, 3'000'000);
    errors.take(reported(500, 0, 0), 0);
    errors.take(reported(5000, 0, 0), 0);

    EXPECT_FALSE(errors.roll_deg.rms());
}
