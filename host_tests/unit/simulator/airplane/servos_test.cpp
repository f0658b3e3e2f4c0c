// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/airplane/servos.hpp"

#include <gtest/gtest.h>

namespace {

using namespace simulator;

AirplaneParameters quick() {
    AirplaneParameters p;
    p.controls.rate_per_s = 10;
    p.controls.lag_s = 0.01;
    return p;
}

void settle(Servos& servos, const Controls& demand) {
    for (int i = 0; i < 1000; ++i) servos.advance(0.0025, demand);
}

TEST(Servos, stay_within_their_deadband) {
    AirplaneParameters p = quick();
    p.linkage.deadband = 0.02;
    Servos servos(p);
    settle(servos, {0.5, 0, 0, 0});
    const double at = servos.at().aileron;
    EXPECT_NEAR(at, 0.5, 0.0201);
    settle(servos, {at + 0.015, 0, 0, 0});
    EXPECT_EQ(servos.at().aileron, at);
    settle(servos, {at + 0.06, 0, 0, 0});
    EXPECT_NEAR(servos.at().aileron, at + 0.06, 0.0201);
}

TEST(Servos, move_surfaces_through_their_linkage) {
    AirplaneParameters p = quick();
    p.linkage.curve = 0.3;
    Servos servos(p);
    settle(servos, {1, 0.5, -0.5, 0});
    EXPECT_NEAR(servos.at().aileron, 1, 1e-6);
    EXPECT_NEAR(servos.at().elevator, 0.35 + 0.3 * 0.125, 1e-6);
    EXPECT_NEAR(servos.at().rudder, -(0.35 + 0.3 * 0.125), 1e-6);
}

}  // namespace
