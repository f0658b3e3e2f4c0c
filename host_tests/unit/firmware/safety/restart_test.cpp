// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/safety/restart.hpp"

#include "firmware/control/attitude_control.hpp"
#include "firmware/estimator/estimator.hpp"
#include "firmware/safety/restart_records.hpp"
#include "firmware/safety/saved_home.hpp"
#include "firmware_bench.hpp"
#include "hal/clock.hpp"
#include "hal/eeprom.hpp"
#include "host_tests/support/fakes/vehicle.hpp"
#include "storage/owner.hpp"

namespace {

using namespace firmware;
using namespace firmware::notify;
using namespace firmware::state;
using namespace firmware::sensors;
using namespace firmware::estimator;
using namespace firmware::control;
using namespace firmware::modes;
using namespace firmware::safety;
using namespace firmware::gcs;
using hal::ResetCause;

constexpr geo::Position kHome = {473977000, 85456000};

class Restart : public bench::Bench {
protected:
    void SetUp() override {
        Bench::SetUp();
        while (storage::claim() == core::Status::busy) fakes::advance_ms(10);
        begin(ResetCause::asked);  // a run before this flight
        parameters.switch_mode[0] = static_cast<int8_t>(Mode::stabilize);
        requestMode(Mode::fbwa, ModeReason::boot);
        mutable_vehicle.attitude.aligned = true;
        mutable_vehicle.armed = true;
        mutable_vehicle.estimate.flying = true;
        mutable_vehicle.estimate.ground_speed_mps = 14;
        mutable_vehicle.estimate.height_m = 40;
        mutable_vehicle.home = {kHome, 48800, true};
        mutable_vehicle.baro.ground_pressure_pa = 95600;
        mutable_vehicle.baro.ground_temperature_c = 12;
        keep();
    }
    void keep() {
        runRestart();
        runRestartSlowly();
    }
    // As start() goes through it, with memory as it was.
    void begin(ResetCause cause) {
        fakes::watchdog().last_run = {cause, 3, static_cast<uint16_t>(hal::now_ms()), 80};
        fakes::resetClock();
        mutable_vehicle = {};
        mutable_vehicle.mode = Mode::initialising;
        restartBegin();
        restartResume();
        mutable_vehicle.attitude.aligned = true;
    }
    void lookAtSwitch(uint16_t pulse_us) {
        for (int i = 0; i < 5; ++i) {
            fakes::receiveRc(with(8, pulse_us));
            runRadio();
            fakes::advance_ms(10);
            runRadio();
            runRestart();
            fakes::advance_ms(10);
        }
    }
};

}  // namespace

TEST_F(Restart, flies_on_after_every_reset_that_keeps_memory_and_that_nobody_asked_for) {
    for (const ResetCause cause : {ResetCause::watchdog, ResetCause::fault, ResetCause::brown_out,
                                   ResetCause::power_on, ResetCause::unknown}) {
        SetUp();
        begin(cause);
        EXPECT_TRUE(flyingOn());
        EXPECT_TRUE(vehicle.estimate.flying);
    }
}

TEST_F(Restart, starts_disarmed_after_a_reset_that_somebody_wanted) {
    for (const ResetCause cause : {ResetCause::external, ResetCause::asked}) {
        SetUp();
        begin(cause);
        EXPECT_FALSE(flyingOn());
        lookAtSwitch(1165);
        EXPECT_FALSE(vehicle.armed);
    }
}

void barometerReads(float above_zero_m) {
    mutable_vehicle.baro.healthy = true;
    mutable_vehicle.estimate.baro_height_m = above_zero_m;
}

void runUntil_ms(uint32_t end_ms) {
    for (; hal::now_ms() < end_ms; fakes::advance_ms(10)) runRestart();
}

// A battery that is plugged in again beside a hand leaves the same records as a short sag.
TEST_F(Restart, is_armed_after_a_loss_of_power_only_when_a_sensor_sees_it_in_the_air) {
    struct Row {
        float above_zero_m;
        bool airspeed_healthy;
        float airspeed_mps;
        bool armed;
    };
    const float flying_mps = parameters.speed_min_mps * 0.75f;
    const Row rows[] = {{0, false, 0, false},
                        {8, false, 0, false},
                        {14.9f, false, 0, false},
                        {15.1f, false, 0, true},
                        {34, true, flying_mps - 0.1f, false},
                        {36, true, flying_mps - 0.1f, true},
                        {0, true, flying_mps + 0.1f, true}};
    for (const ResetCause cause :
         {ResetCause::brown_out, ResetCause::power_on, ResetCause::unknown}) {
        for (const Row& row : rows) {
            SetUp();
            steady.home_height_m = 5;
            updateChecksum(steady);
            begin(cause);
            lookAtSwitch(1165);
            EXPECT_EQ(vehicle.mode, Mode::stabilize) << "the surfaces do not wait";
            EXPECT_FALSE(vehicle.armed);
            mutable_vehicle.baro.healthy = true;
            mutable_vehicle.estimate.baro_height_m = row.above_zero_m;
            mutable_vehicle.airspeed.healthy = row.airspeed_healthy;
            mutable_vehicle.airspeed.speed_mps = row.airspeed_mps;
            runRestart();
            EXPECT_EQ(vehicle.armed, row.armed) << row.above_zero_m << " " << row.airspeed_mps;
        }
    }
}

TEST_F(Restart, waits_two_seconds_to_be_seen_in_the_air_and_forgets_the_flight_then) {
    begin(ResetCause::unknown);
    lookAtSwitch(1165);
    barometerReads(1);
    runUntil_ms(2010);
    barometerReads(60);
    runRestart();
    EXPECT_FALSE(vehicle.armed);
    begin(ResetCause::watchdog);
    EXPECT_FALSE(flyingOn());
}

TEST_F(Restart, gives_a_sensor_that_comes_late_a_second) {
    begin(ResetCause::unknown);
    lookAtSwitch(1165);
    runUntil_ms(2500);
    barometerReads(1);
    runUntil_ms(3400);
    EXPECT_FALSE(vehicle.armed);
    barometerReads(60);
    runRestart();
    EXPECT_TRUE(vehicle.armed);
}

// The bus of both chips failed and comes back.
TEST_F(Restart, waits_half_a_minute_for_a_sensor_that_can_see_it_in_the_air) {
    for (const bool in_time : {true, false}) {
        SetUp();
        begin(ResetCause::unknown);
        lookAtSwitch(1165);
        runUntil_ms(in_time ? 29900 : 31010);
        EXPECT_FALSE(vehicle.armed);
        barometerReads(60);
        runRestart();
        EXPECT_EQ(vehicle.armed, in_time);
    }
}

TEST_F(Restart, starts_disarmed_on_the_ground_after_landing_and_after_disarming) {
    const auto onGround = [] {
        mutable_vehicle.estimate.ground_speed_mps = mutable_vehicle.estimate.height_m = 0;
    };
    const auto landed = [] { mutable_vehicle.estimate.flying = false; };
    const auto disarmed = [] { mutable_vehicle.armed = false; };
    for (void (*happens)() : {+onGround, +landed, +disarmed}) {
        SetUp();
        happens();
        runRestart();
        begin(ResetCause::watchdog);
        EXPECT_FALSE(flyingOn());
    }
}

TEST_F(Restart, knows_home_and_zeros_again) {
    begin(ResetCause::watchdog);

    EXPECT_EQ(vehicle.home.position.latitude_e7, kHome.latitude_e7);
    EXPECT_EQ(vehicle.home.altitude_cm, 48800);
    EXPECT_TRUE(vehicle.home.set);
    EXPECT_EQ(vehicle.baro.ground_pressure_pa, 95600);
    EXPECT_EQ(vehicle.baro.ground_temperature_c, 12);
}

TEST_F(Restart, is_armed_and_in_a_mode_only_when_the_switch_has_been_seen) {
    begin(ResetCause::watchdog);
    runRestart();
    EXPECT_FALSE(vehicle.armed);
    EXPECT_EQ(vehicle.mode, Mode::initialising);

    lookAtSwitch(1165);
    EXPECT_TRUE(vehicle.armed);
    EXPECT_EQ(vehicle.mode, Mode::stabilize);
}

TEST_F(Restart, flies_on_as_before_without_a_receiver) {
    fakes::advance_ms(2000);
    keep();
    begin(ResetCause::watchdog);
    mutable_vehicle.radio.good_ms = 0;
    for (int i = 0; i < 15; ++i) {
        runRestart();
        if (i < 9) {
            EXPECT_FALSE(vehicle.armed) << i;
        }
        fakes::advance_ms(20);
    }

    EXPECT_TRUE(vehicle.armed);
    EXPECT_EQ(vehicle.mode, Mode::fbwa);
}

// A brown-out resets the inertial sensor too: the attitude comes late, the mode switch at once.
TEST_F(Restart, is_armed_again_although_the_mode_switch_is_read_before_the_attitude_is_found) {
    begin(ResetCause::brown_out);
    mutable_vehicle.attitude.aligned = false;
    mutable_vehicle.baro.healthy = true;
    mutable_vehicle.estimate.baro_height_m = 60;
    for (int i = 0; i < 60; ++i) {
        if (i % 2 == 0) fakes::receiveRc(with(8, 1165));
        runRadio();
        if (i % 10 == 5) runModeSwitch();
        if (i % 2 == 1) runRestart();
        fakes::advance_ms(10);
    }
    EXPECT_TRUE(vehicle.armed);
    EXPECT_EQ(vehicle.mode, Mode::stabilize);
}

// Without an inertial sensor no new record is written: the last one still says "in the air".
TEST_F(Restart, starts_disarmed_after_disarming_although_the_inertial_sensor_has_died) {
    mutable_vehicle.attitude.aligned = false;
    runRestart();
    mutable_vehicle.armed = false;
    runRestart();
    begin(ResetCause::brown_out);
    EXPECT_FALSE(flyingOn());
}

TEST_F(Restart, rejects_a_record_with_any_bit_changed) {
    steady.home_altitude_cm ^= 1;
    begin(ResetCause::watchdog);
    EXPECT_FALSE(flyingOn());

    SetUp();
    for (FastRecord& each : moving) each.position.latitude_e7 ^= 64;
    begin(ResetCause::watchdog);
    EXPECT_FALSE(flyingOn());
}

TEST_F(Restart, falls_back_on_the_record_before) {
    runRestart();
    moving[number & 1].at_ms ^= 1;
    begin(ResetCause::watchdog);
    EXPECT_TRUE(flyingOn());
}

TEST_F(Restart, holds_its_surfaces_at_trim_until_the_mode_is_known) {
    begin(ResetCause::watchdog);
    fakes::receiveRc(with(1, 1900));
    runRadio();
    mutable_vehicle.attitude.roll_rad = core::Angle(0.7f);
    runAttitudeControl();

    EXPECT_EQ(surfaces.aileron.raw, 0);
    EXPECT_EQ(surfaces.elevator.raw, 0);
    EXPECT_EQ(surfaces.rudder.raw, 0);
    EXPECT_EQ(surfaces.throttle.raw, 0);
}

TEST_F(Restart, finds_home_in_the_eeprom_when_power_and_memory_were_lost_in_flight) {
    invalidate(steady);
    begin(ResetCause::power_on);

    EXPECT_FALSE(flyingOn());
    EXPECT_TRUE(vehicle.home.set);
    EXPECT_EQ(vehicle.home.position.longitude_e7, kHome.longitude_e7);
    EXPECT_EQ(vehicle.home.altitude_cm, 48800);
}

TEST_F(Restart, forgets_no_saved_home_while_it_waits_to_be_armed_again) {
    begin(ResetCause::unknown);
    for (int i = 0; i < 5; ++i) runRestartSlowly();
    lookAtSwitch(1165);
    ASSERT_FALSE(vehicle.armed) << "it has not been seen in the air";
    for (int i = 0; i < 5; ++i) runRestartSlowly();
    invalidate(steady);
    begin(ResetCause::power_on);
    EXPECT_TRUE(vehicle.home.set) << "the power was lost once more";
}

TEST_F(Restart, finds_no_saved_home_when_the_flight_before_was_ended_by_disarming) {
    mutable_vehicle.armed = false;
    keep();
    begin(ResetCause::power_on);

    EXPECT_FALSE(vehicle.home.set);
}
