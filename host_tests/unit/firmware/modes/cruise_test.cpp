// SPDX-License-Identifier: GPL-3.0-or-later
#include "host_tests/support/fakes/vehicle.hpp"
#include "modes_bench.hpp"

namespace {

using namespace modes_bench;

class Cruise : public ModesBench {
protected:
    void lockedTo(float north_mps, float east_mps) {
        course(north_mps, east_mps);
        fly(Mode::cruise);
        guide(6);
        ASSERT_EQ(vehicle.demand.path, Path::leg);
    }
};

TEST_F(Cruise, locks_the_course_after_half_a_second_of_centred_sticks) {
    fly(Mode::cruise);
    guide(5);
    EXPECT_EQ(vehicle.demand.path, Path::none);
    guide(1);
    EXPECT_EQ(vehicle.demand.path, Path::leg);
    const geo::Offset ahead = geo::offset(vehicle.demand.from, vehicle.demand.to);
    EXPECT_NEAR(ahead.north_m, 0, 0.5);
    EXPECT_NEAR(ahead.east_m, 1000, 0.5);
    EXPECT_EQ(vehicle.demand.from, kHome);
}

TEST_F(Cruise, turns_back_to_the_line_it_has_locked) {
    lockedTo(0, 15);
    mutable_vehicle.estimate.position = geo::moved(kHome, {20, 100});
    guide();
    EXPECT_GT(vehicle.roll_demand_rad.toFloat(), 0.1f);
    EXPECT_NEAR(vehicle.progress.crosstrack_m, -20, 0.1);
}

TEST_F(Cruise, unlocks_when_the_roll_or_yaw_stick_moves) {
    for (const int channel : {1, 4}) {
        lockedTo(0, 15);
        settle(with(channel, 1900));
        guide();
        EXPECT_EQ(vehicle.demand.path, Path::none) << channel;
        EXPECT_NEAR(vehicle.roll_demand_rad.toFloat(), channel == 1 ? core::radians(45) : 0, 1e-3);
        settle(bench::kCentred);
        guide(5);
        EXPECT_EQ(vehicle.demand.path, Path::none);
        guide(2);
        EXPECT_EQ(vehicle.demand.path, Path::leg) << "and locks again";
    }
}

TEST_F(Cruise, does_not_lock_when_slow_or_without_a_position) {
    course(2, 2);
    fly(Mode::cruise);
    guide(20);
    EXPECT_EQ(vehicle.demand.path, Path::none);
    course(0, 15);
    mutable_vehicle.estimate.known = false;
    guide(20);
    EXPECT_EQ(vehicle.demand.path, Path::none);
}

TEST_F(Cruise, flies_on_with_level_wings_when_the_position_is_lost) {
    lockedTo(0, 15);
    mutable_vehicle.estimate.known = false;
    guide();
    EXPECT_EQ(vehicle.demand.path, Path::none);
    EXPECT_NEAR(vehicle.roll_demand_rad.toFloat(), 0, 1e-3);
}

TEST_F(Cruise, moves_on_along_the_line_as_it_goes) {
    lockedTo(10, 10);
    for (int flown_m = 0; flown_m <= 5000; flown_m += 10) {
        const float each_m = static_cast<float>(flown_m) * 0.70710678f;
        mutable_vehicle.estimate.position = geo::moved(kHome, {each_m, each_m});
        guide();
        EXPECT_NEAR(vehicle.progress.crosstrack_m, 0, 5);
        EXPECT_GT(vehicle.progress.distance_m, 480);
        EXPECT_LT(vehicle.progress.distance_m, 1010);
    }
}

TEST_F(Cruise, crosses_the_antimeridian) {
    mutable_vehicle.estimate.position = {470000000, 1799990000};
    lockedTo(0, 15);
    const geo::Position start = vehicle.demand.from;
    for (int flown_m = 0; flown_m <= 2000; flown_m += 50) {
        mutable_vehicle.estimate.position = geo::moved(start, {0, static_cast<float>(flown_m)});
        guide();
        EXPECT_NEAR(vehicle.progress.crosstrack_m, 0, 2) << flown_m;
    }
    EXPECT_LT(vehicle.demand.to.longitude_e7, 0);
}

TEST_F(Cruise, holds_and_changes_height_and_speed_as_fbwb_does) {
    lockedTo(0, 15);
    settle({1500, 1900, 1515, 1500, 1500, 1500, 1500, 1815});
    guide(10);
    EXPECT_EQ(vehicle.demand.path, Path::leg) << "the pitch stick does not unlock";
    EXPECT_NEAR(planned_m(), 82, 0.21);
    EXPECT_NEAR(vehicle.demand.airspeed_mps, 15.5, 0.1);
}

}  // namespace
