// SPDX-License-Identifier: GPL-3.0-or-later
// What CONDITIONs wait for.
#include "mission_flight.hpp"

#include "firmware/mission/handlers.hpp"
#include "host_tests/support/fakes/vehicle.hpp"

namespace firmware {
using namespace mission;
namespace {

TEST_F(MissionFlight, a_delay_holds_the_servo_back_for_its_seconds) {
    fly({waypoint(500), command(112, 5), command(183, 6, 1700), waypoint(900)});
    reach();
    seconds(4);
    EXPECT_EQ(outputPulse_us(6), 1500);
    seconds(2);
    EXPECT_EQ(outputPulse_us(6), 1700);
}

TEST_F(MissionFlight, a_delay_stands_in_p1_in_apm1) {
    parameters.mission_set = 1;
    fly({waypoint(500), command(0x20, 5), command(0x81, 1)});
    seconds(4);
    EXPECT_FALSE(relayGet());
    seconds(2);
    EXPECT_TRUE(relayGet());
}

TEST_F(MissionFlight, a_resumed_delay_waits_its_full_time) {
    fly({waypoint(500), command(112, 5), command(181, 0, 1), waypoint(900)});
    reach();
    seconds(4);
    requestMode(Mode::loiter, ModeReason::pilot);
    seconds(10);
    EXPECT_FALSE(relayGet());
    enterAuto();
    seconds(4);
    EXPECT_FALSE(relayGet());
    seconds(2);
    EXPECT_TRUE(relayGet());
}

TEST_F(MissionFlight, a_distance_waits_for_the_airplane_to_come_near) {
    fly({waypoint(500), command(114, 200), command(181, 0, 1), waypoint(900)});
    reach();
    mutable_vehicle.progress.distance_m = 201;
    pass();
    EXPECT_FALSE(relayGet());
    mutable_vehicle.progress.distance_m = 199;
    pass();
    EXPECT_TRUE(relayGet());
}

TEST_F(MissionFlight, a_distance_beside_a_takeoff_waits_until_that_nav_ends) {
    fly({command(114, 200), command(181, 0, 1), takeoff(400), waypoint(900)});
    mutable_vehicle.progress.distance_m = 0;
    pass(5);
    EXPECT_FALSE(relayGet());
}

TEST_F(MissionFlight, change_alt_moves_the_target_at_its_rate_from_the_airplane_and_it_stays) {
    MissionItem climb = command(113, 2);
    climb.frame = kRelativeFrame;
    climb.z = 70;
    fly({waypoint(500, 60), climb, command(181, 0, 1), waypoint(900, 60), waypoint(1900, 60)});
    mutable_vehicle.estimate.height_m = 55;
    reach();
    EXPECT_FALSE(vehicle.demand.sloped);
    EXPECT_FLOAT_EQ(vehicle.demand.from_height_m, 55) << "guidance moves this one, not the leg's";
    EXPECT_NEAR(vehicle.demand.height_m, 55.2, 0.01);
    seconds(5);
    EXPECT_NEAR(vehicle.demand.height_m, 65.2, 0.1);
    EXPECT_FALSE(relayGet());
    mutable_vehicle.estimate.height_m = 68.5f;
    pass();
    EXPECT_TRUE(relayGet()) << "within 2 m";
    seconds(10);
    EXPECT_FLOAT_EQ(vehicle.demand.height_m, 70);
    requestMode(Mode::loiter, ModeReason::pilot);
    pass(5);
    enterAuto();
    seconds(5);
    EXPECT_FLOAT_EQ(vehicle.demand.height_m, 70) << "it stays over a resume";
    reach();
    pass(5);
    EXPECT_FLOAT_EQ(vehicle.demand.height_m, 60) << "until the next NAV loads";
}

TEST_F(MissionFlight, change_alt_leaves_the_ground_of_a_landing_where_it_is) {
    MissionItem climb = command(113, 2);
    climb.frame = kRelativeFrame;
    climb.z = 30;
    fly({waypoint(500), climb, placed(21, 900, 0, 0)});
    reach();
    pass(5);
    EXPECT_FLOAT_EQ(vehicle.demand.height_m, 0);
}

}  // namespace
}  // namespace firmware
