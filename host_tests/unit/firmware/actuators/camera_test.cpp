// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/actuators/camera.hpp"

#include "firmware/mission/handlers.hpp"
#include "host_tests/support/fakes/vehicle.hpp"
#include "mission_flight.hpp"

namespace firmware {
using namespace actuators;
namespace {

class Camera : public Beyond {
protected:
    void SetUp() override {
        Beyond::SetUp();
        parameters.output_function[2] = kCameraFunction;
        runOutputs();
    }
    static int shutter_us() { return outputPulse_us(7); }
    static void flyOn(int metres) { mutable_vehicle.estimate.position.latitude_e7 += metres * 90; }
};

TEST_F(Camera, digicam_control_holds_the_shutter_for_its_duration) {
    EXPECT_EQ(shutter_us(), 1100);
    fly({command(203), waypoint(500)});
    EXPECT_EQ(cameraTriggerCount(), 1);
    EXPECT_EQ(shutter_us(), 1300);
    pass(9);
    EXPECT_EQ(shutter_us(), 1300);
    pass();
    EXPECT_EQ(shutter_us(), 1100);
}

TEST_F(Camera, works_the_relay_where_it_is_connected_to_that) {
    parameters.camera_on_relay = 1;
    parameters.camera_duration_ds = 3;
    fly({command(203), waypoint(500)});
    EXPECT_TRUE(relayGet());
    EXPECT_EQ(shutter_us(), 1100);
    pass(2);
    EXPECT_TRUE(relayGet());
    pass();
    EXPECT_FALSE(relayGet());
}

TEST_F(Camera, reports_a_missing_camera_output) {
    parameters.output_function[2] = 0;
    fly({command(203), waypoint(500)});
    EXPECT_TRUE(hasStatusText("Camera: no output has its function"));
    EXPECT_EQ(cameraTriggerCount(), 0);
}

TEST_F(Camera, reports_busy_rather_than_losing_a_picture) {
    fly({command(203), command(203), waypoint(500)});
    EXPECT_TRUE(hasStatusText("Camera: still busy"));
    EXPECT_EQ(cameraTriggerCount(), 1);
}

TEST_F(Camera, takes_a_picture_each_so_many_metres_until_0) {
    parameters.camera_duration_ds = 0;
    mutable_vehicle.estimate.ground_speed_mps = 10;
    fly({command(206, 25), waypoint(5000), command(206, 0), waypoint(9000)});
    EXPECT_EQ(cameraTriggerCount(), 0) << "the first is due 25 m on";
    for (int i = 0; i < 250; ++i) {
        flyOn(1);
        pass();
    }
    EXPECT_NEAR(cameraTriggerCount(), 10, 1);
    const int before = cameraTriggerCount();
    reach();
    for (int i = 0; i < 100; ++i) {
        flyOn(1);
        pass();
    }
    EXPECT_EQ(cameraTriggerCount(), before);
}

TEST_F(Camera, the_exact_distance_of_a_picture_counts) {
    parameters.camera_duration_ds = 0;
    mutable_vehicle.estimate.ground_speed_mps = 0;
    fly({command(206, 12.5f), waypoint(5000)});
    flyOn(12);
    pass();
    EXPECT_EQ(cameraTriggerCount(), 0);
    flyOn(1);
    pass();
    EXPECT_EQ(cameraTriggerCount(), 1);
}

TEST_F(Camera, waits_until_the_shutter_is_released) {
    parameters.camera_duration_ds = 10;
    fly({command(206, 5), waypoint(5000)});
    for (int i = 0; i < 36; ++i) {
        flyOn(10);
        pass();
    }
    EXPECT_EQ(cameraTriggerCount(), 3);
}

TEST_F(Camera, stops_when_disarmed_and_when_the_mission_restarts) {
    for (const bool disarmed : {true, false}) {
        requestMode(Mode::loiter, ModeReason::pilot);
        fly({waypoint(500), command(206, 25), waypoint(5000)});
        reach();
        if (disarmed) {
            mutable_vehicle.armed = false;
            pass();
            mutable_vehicle.armed = true;
        } else {
            missionRestart();
        }
        const int before = cameraTriggerCount();
        flyOn(100);
        pass(3);
        EXPECT_EQ(cameraTriggerCount(), before) << disarmed;
    }
}

TEST_F(Camera, an_output_of_another_function_goes_on_following_the_receiver) {
    parameters.output_function[2] = 0;
    mutable_vehicle.radio.pulse_us[6] = 1712;
    runOutputs();
    EXPECT_EQ(shutter_us(), 1712);
}

}  // namespace
}  // namespace firmware
