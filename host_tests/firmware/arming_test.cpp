// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/arming.hpp"

#include <functional>
#include <string>

#include "firmware/bench.hpp"

namespace {

using firmware::ArmReason;
using firmware::Mode;
using firmware::parameters;
using firmware::vehicle;

struct Arming : bench::Bench {
    void SetUp() override {
        Bench::SetUp();
        makeReady();
        firmware::runArming();  // the rudder's time begins anew
    }
    static void makeReady() {
        vehicle.imu.healthy = vehicle.imu.calibrated = true;
        vehicle.attitude.aligned = true;
        vehicle.baro.healthy = vehicle.compass.healthy = vehicle.airspeed.healthy = true;
        vehicle.gps.healthy = true;
        vehicle.gps.fix = firmware::GpsFix::three_d;
        vehicle.gps.altitude_cm = 48800;
        vehicle.estimate.known = true;
        vehicle.estimate.position = {473977000, 85456000};
        vehicle.battery.board_mv = 5000;
        vehicle.battery.voltage_mv = 12000;
    }
};

TEST_F(Arming, arms_when_every_check_passes_and_takes_home_there) {
    EXPECT_TRUE(firmware::arm(ArmReason::ground, false));
    EXPECT_TRUE(vehicle.armed);
    EXPECT_TRUE(vehicle.home.set);
    EXPECT_EQ(vehicle.home.position, (geo::Position{473977000, 85456000}));
    EXPECT_EQ(vehicle.home.altitude_cm, 48800);
}

struct Fault {
    const char* reason;
    std::function<void()> happens;
};
class Check : public Arming, public testing::WithParamInterface<Fault> {};

TEST_P(Check, refuses_to_arm_and_says_why) {
    GetParam().happens();
    const core::RomText why = firmware::prearmFailure();
    ASSERT_NE(why, nullptr);
    EXPECT_STREQ(why, GetParam().reason);
    EXPECT_FALSE(firmware::arm(ArmReason::ground, false));
    EXPECT_FALSE(vehicle.armed);
}
INSTANTIATE_TEST_SUITE_P(
    Faults, Check,
    testing::Values(Fault{"PreArm: gyros not ready", [] { vehicle.imu.calibrated = false; }},
                    Fault{"PreArm: gyros not ready", [] { vehicle.imu.healthy = false; }},
                    Fault{"PreArm: attitude", [] { vehicle.attitude.aligned = false; }},
                    Fault{"PreArm: barometer", [] { vehicle.baro.healthy = false; }},
                    Fault{"PreArm: compass", [] { vehicle.compass.healthy = false; }},
                    Fault{"PreArm: no GPS fix", [] { vehicle.gps.fix = firmware::GpsFix::two_d; }},
                    Fault{"PreArm: airspeed sensor", [] { vehicle.airspeed.healthy = false; }},
                    Fault{"PreArm: no radio", [] { vehicle.radio.lost = true; }},
                    Fault{"PreArm: throttle is up", [] { vehicle.radio.throttle_pct = 10; }},
                    Fault{"PreArm: board voltage", [] { vehicle.battery.board_mv = 4100; }},
                    Fault{"PreArm: battery low", [] { vehicle.battery.voltage_mv = 9000; }}));

TEST_F(Arming, can_be_forced) {
    vehicle.baro.healthy = false;
    EXPECT_TRUE(firmware::arm(ArmReason::ground, true));
}

TEST_F(Arming, leaves_out_the_checks_not_asked_for) {
    parameters.arming_check = 8;  // GPS alone
    vehicle.baro.healthy = false;
    EXPECT_TRUE(firmware::prearmOk());
    vehicle.gps.fix = firmware::GpsFix::none;
    EXPECT_FALSE(firmware::prearmOk());
}

TEST_F(Arming, takes_three_seconds_of_full_right_rudder) {
    for (int tenth = 0; tenth < 28; ++tenth) {
        fakes::receiveRc(with(4, 1900));
        firmware::runRadio();
        firmware::runArming();
        fakes::advance_ms(100);
    }
    EXPECT_FALSE(vehicle.armed);
    for (int tenth = 0; tenth < 5; ++tenth) {
        fakes::receiveRc(with(4, 1900));
        firmware::runRadio();
        firmware::runArming();
        fakes::advance_ms(100);
    }
    EXPECT_TRUE(vehicle.armed);
}

TEST_F(Arming, refuses_to_disarm_in_flight_unless_forced) {
    ASSERT_TRUE(firmware::arm(ArmReason::ground, false));
    vehicle.estimate.flying = true;
    EXPECT_FALSE(firmware::disarm(ArmReason::ground, false));
    EXPECT_TRUE(vehicle.armed);
    EXPECT_TRUE(firmware::disarm(ArmReason::ground, true));
    EXPECT_FALSE(vehicle.armed);
}

TEST_F(Arming, stays_armed_after_a_landing_when_the_delay_is_0) {
    ASSERT_TRUE(firmware::arm(ArmReason::ground, false));
    parameters.land_disarm_delay_s = 0;
    vehicle.mode = Mode::automatic;
    vehicle.demand.path = firmware::Path::land;
    vehicle.progress.flaring = true;
    for (int tenth = 0; tenth < 600; ++tenth) {
        firmware::runArming();
        fakes::advance_ms(100);
    }
    EXPECT_TRUE(vehicle.armed);
    vehicle.mode = Mode::manual;
}

TEST_F(Arming, disarms_by_itself_some_seconds_after_a_landing) {
    ASSERT_TRUE(firmware::arm(ArmReason::ground, false));
    firmware::runArming();
    vehicle.mode = Mode::automatic;
    vehicle.demand.path = firmware::Path::land;
    vehicle.progress.flaring = true;
    const int delay_s = parameters.land_disarm_delay_s;
    for (int tenth = 0; tenth < delay_s * 10; ++tenth) {
        firmware::runArming();
        fakes::advance_ms(100);
    }
    EXPECT_TRUE(vehicle.armed);
    for (int tenth = 0; tenth < 5; ++tenth) {
        firmware::runArming();
        fakes::advance_ms(100);
    }
    EXPECT_FALSE(vehicle.armed);
    vehicle.mode = Mode::manual;
}

}  // namespace
