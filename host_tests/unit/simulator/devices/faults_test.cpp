// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/devices/faults.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace simulator;

TEST(Faults, are_read_as_they_are_written) {
    const auto fault = parseFault("gps:lost@60-90.5");
    ASSERT_TRUE(fault);
    EXPECT_EQ(fault->sensor, Faulty::gps);
    EXPECT_EQ(fault->kind, FaultKind::lost);
    EXPECT_EQ(fault->from_s, 60);
    EXPECT_EQ(fault->to_s, 90.5);

    const auto for_ever = parseFault("imu:nonsense@0");
    ASSERT_TRUE(for_ever);
    EXPECT_GT(for_ever->to_s, 1e6);
}

TEST(Faults, of_every_sensor_and_kind_have_a_name) {
    for (int sensor = 0; sensor < kFaulty; ++sensor)
        for (int kind = 1; kind < kFaultKinds; ++kind) {
            if (static_cast<FaultKind>(kind) == FaultKind::sag) continue;  // it has a number
            if (!canFail(static_cast<Faulty>(sensor), static_cast<FaultKind>(kind))) continue;
            const std::string text = std::string(nameOf(static_cast<Faulty>(sensor))) + ":" +
                                     nameOf(static_cast<FaultKind>(kind)) + "@1-2";
            const auto fault = parseFault(text);
            ASSERT_TRUE(fault) << text;
            EXPECT_EQ(static_cast<int>(fault->sensor), sensor);
            EXPECT_EQ(static_cast<int>(fault->kind), kind);
        }
}

TEST(Faults, of_the_supply_say_how_deep_and_how_fast_it_falls) {
    const auto cut = parseFault("supply:cut@60-60.5");
    ASSERT_TRUE(cut);
    EXPECT_EQ(cut->volts, 0);
    EXPECT_EQ(cut->fall_ms, 5);
    const auto sag = parseFault("supply:sag_3.2v@60-60.012");
    ASSERT_TRUE(sag);
    EXPECT_EQ(sag->volts, 3.2);
    EXPECT_NEAR(sag->fall_ms, 1.8, 1e-9);
    const auto slow = parseFault("supply:sag_2.5v_20ms@60-60.1");
    ASSERT_TRUE(slow);
    EXPECT_EQ(slow->volts, 2.5);
    EXPECT_EQ(slow->fall_ms, 20);
}

TEST(Faults, that_mean_nothing_are_refused) {
    for (const char* text : {"",
                             "gps",
                             "gps:lost",
                             "gps@60",
                             "gps:none@60",
                             "wing:lost@60",
                             "gps:gone@60",
                             "gps:lost@",
                             "gps:lost@x",
                             "gps:lost@60-",
                             "gps:lost@-5",
                             "gps:lost@60-60",
                             "gps:lost@60-50",
                             "gps:lost@60-70x",
                             "@gps:lost",
                             "radio:noisy@5",
                             "gps:lost@nan",
                             "gps:drift@5",
                             "compass:dead_roll@5",
                             "imu:dead@5",
                             "imu:cut@5",
                             "supply:lost@5",
                             "supply:sag@5",
                             "supply:sag_v@5",
                             "supply:sag_5v@5",
                             "supply:sag_-1v@5",
                             "supply:sag_3v_@5",
                             "supply:sag_3v_5@5",
                             "supply:sag_3vx@5",
                             "supply:sag_3v_5msx@5"})
        EXPECT_FALSE(parseFault(text)) << text;
}

constexpr FaultShape kShape = {2, 100, 200, 7, 0.5};

TEST(Faults, make_a_value_stuck_noisy_nonsense_or_off) {
    Random random(1);
    FaultyValue value;
    EXPECT_EQ(value.of(5, kShape, random), 5);
    value.fail(FaultKind::stuck);
    EXPECT_EQ(value.of(6, kShape, random), 6);
    EXPECT_EQ(value.of(7, kShape, random), 6);
    value.fail(FaultKind::jump);
    EXPECT_EQ(value.of(7, kShape, random), 14);
    value.fail(FaultKind::drift, 10);
    EXPECT_EQ(value.of(7, kShape, random), 12);
    value.fail(FaultKind::nonsense);
    double noise = 0;
    for (int i = 0; i < 100; ++i) {
        const double nonsense = value.of(7, kShape, random);
        EXPECT_TRUE(nonsense > 100 && nonsense < 200);
    }
    value.fail(FaultKind::noisy);
    for (int i = 0; i < 1000; ++i) noise += std::pow(value.of(7, kShape, random) - 7, 2);
    EXPECT_NEAR(std::sqrt(noise / 1000), 2, 0.2);
    value.fail(FaultKind::stuck);
    EXPECT_EQ(value.of(9, kShape, random), 9) << "where it is now";
    value.fail(FaultKind::none);
    EXPECT_EQ(value.of(8, kShape, random), 8);
}

TEST(Faults, draw_no_random_number_while_all_is_well) {
    Random used(1), fresh(1);
    FaultyValue value;
    value.of(1, kShape, used);
    EXPECT_EQ(used.bits(), fresh.bits());
}

}  // namespace
