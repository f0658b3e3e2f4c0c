// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/safety/restart.hpp"

#include <math.h>
#include <string.h>

#include <string>
#include <vector>

#include "core/internal_error.hpp"
#include "firmware/control/attitude_control.hpp"
#include "firmware/estimator/estimator.hpp"
#include "hal/eeprom.hpp"
#include "hal/trace.hpp"
#include "restart_bench.hpp"

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
using namespace bench;
using hal::ResetCause;

class Restart : public RestartBench {};

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

bool reported(const std::string& part) {
    for (const std::string& text : statusTexts())
        if (text.find(part) != std::string::npos) return true;
    return false;
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
            records.slow.home_height_m = 5;
            updateChecksum(records.slow);
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

// The receiver starts more slowly than the board: 2 to 30 s.
TEST_F(Restart, is_armed_after_a_loss_of_power_when_the_receiver_sees_it_move_in_the_end) {
    for (const bool moves : {true, false}) {
        SetUp();
        begin(ResetCause::unknown);
        lookAtSwitch(1165);
        barometerReads(1);
        runUntil_ms(20000);
        EXPECT_FALSE(vehicle.armed);
        mutable_vehicle.gps.healthy = true;
        mutable_vehicle.gps.ground_speed_mps = moves ? 14 : 1;
        for (mutable_vehicle.gps.fixes = 3; vehicle.gps.fixes <= 6; ++mutable_vehicle.gps.fixes)
            runRestart();
        EXPECT_EQ(vehicle.armed, moves);
        mutable_vehicle.gps.ground_speed_mps = 14;
        runRestart();
        runRestart();
        EXPECT_EQ(vehicle.armed, moves) << "carried away later, it stays disarmed";
    }
}

// What comes after a fix that was refused is chance.
TEST_F(Restart, is_not_armed_by_a_receiver_whose_fix_was_refused) {
    for (const bool refused : {true, false}) {
        SetUp();
        begin(ResetCause::unknown);
        lookAtSwitch(1165);
        barometerReads(1);
        mutable_vehicle.gps.healthy = true;
        mutable_vehicle.gps.ground_speed_mps = 14;
        mutable_vehicle.gps.fixes = 2;
        mutable_vehicle.estimate.fix_refused = true;
        runRestart();  // the record's place, or the fix that was compared with it
        mutable_vehicle.gps.fixes = 3;
        mutable_vehicle.estimate.fix_refused = refused;
        runRestart();
        mutable_vehicle.estimate.fix_refused = false;
        mutable_vehicle.gps.fixes = 6;
        runRestart();
        EXPECT_EQ(vehicle.armed, !refused);
    }
}

// It is set in the air by a mission.
TEST_F(Restart, is_seen_in_the_air_by_its_height_over_the_field_wherever_home_is) {
    records.slow.home_height_m = 60;
    records.slow.home_above_field_m = 55;
    updateChecksum(records.slow);
    begin(ResetCause::unknown);
    lookAtSwitch(1165);
    barometerReads(5);
    runRestart();
    EXPECT_FALSE(vehicle.armed) << "it stands on the field";
    barometerReads(60);
    runRestart();
    EXPECT_TRUE(vehicle.armed);
}

TEST_F(Restart, flies_on_slowly_over_the_ground_at_the_height_of_a_home_that_was_set_in_the_air) {
    for (const float home_above_field_m : {4.0f, 40.0f}) {
        SetUp();
        zeroHeight();
        shiftHeight(-home_above_field_m);
        mutable_vehicle.estimate.height_m = 0;
        mutable_vehicle.estimate.ground_speed_mps = 3;
        keep();
        begin(ResetCause::watchdog);
        EXPECT_EQ(flyingOn(), home_above_field_m > 5);
    }
}

TEST_F(Restart, leaves_one_that_the_pilot_has_armed_meanwhile_as_it_is) {
    begin(ResetCause::unknown);
    lookAtSwitch(1165);
    barometerReads(1);
    runUntil_ms(3000);
    mutable_vehicle.armed = true;
    keep();
    EXPECT_EQ(records.fast[newestFastRecord().number & 1].at_ms, 3000) << "its flight is recorded";
    EXPECT_FALSE(reported("Not armed again"));
}

TEST_F(Restart, waits_two_seconds_to_be_seen_in_the_air_and_forgets_the_flight_then) {
    begin(ResetCause::unknown);
    lookAtSwitch(1165);
    barometerReads(1);
    runUntil_ms(2010);
    EXPECT_FALSE(reported("Not armed again")) << "the receiver may still see it move";
    barometerReads(60);
    runRestart();
    EXPECT_FALSE(vehicle.armed);
    begin(ResetCause::watchdog);
    EXPECT_FALSE(flyingOn());
}

TEST_F(Restart, reports_once_that_it_stays_disarmed_when_nothing_has_seen_it_in_the_air) {
    begin(ResetCause::unknown);
    lookAtSwitch(1165);
    barometerReads(1);
    (void)statusTexts();
    runUntil_ms(29990);
    EXPECT_FALSE(reported("Not armed again"));
    runUntil_ms(30020);
    EXPECT_TRUE(reported("Not armed again: not seen flying"));
    runUntil_ms(31000);
    EXPECT_FALSE(reported("Not armed again"));
}

TEST_F(Restart, waits_200_ms_for_the_mode_switch) {
    begin(ResetCause::watchdog);
    mutable_vehicle.radio.heard = false;
    runUntil_ms(200);
    EXPECT_TRUE(vehicle.resuming);
    runRestart();
    EXPECT_FALSE(vehicle.resuming);
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

TEST_F(Restart, obeys_no_switch_that_has_not_been_seen_three_times_in_one_place) {
    begin(ResetCause::watchdog);
    for (int i = 0; i < 9; ++i) {  // moved on after every second frame
        receiveSwitch(i / 2 % 2 == 0 ? 1165 : 1425);
        EXPECT_EQ(vehicle.mode, Mode::initialising) << i;
    }
    SetUp();
    begin(ResetCause::watchdog);
    for (int i = 0; i < 4; ++i) {  // a moved switch counts from its second frame on
        EXPECT_EQ(vehicle.mode, Mode::initialising) << i;
        receiveSwitch(1165);
    }
    EXPECT_EQ(vehicle.mode, Mode::stabilize);
}

// A brown-out resets the inertial sensor as well, which then has to be aligned first.
TEST_F(Restart, decides_nothing_before_the_attitude_is_known_or_450_ms_are_over) {
    begin(ResetCause::watchdog);
    mutable_vehicle.attitude.aligned = false;
    mutable_vehicle.radio.heard = false;
    runUntil_ms(450);
    EXPECT_TRUE(vehicle.resuming);
    runRestart();
    EXPECT_FALSE(vehicle.resuming);
}

TEST_F(Restart, goes_on_saving_records_once_it_is_armed_on_evidence) {
    begin(ResetCause::unknown);
    lookAtSwitch(1165);
    const uint8_t before = newestFastRecord().number;
    runRestart();
    EXPECT_EQ(newestFastRecord().number, before) << "not armed yet: the last record stays";
    barometerReads(60);
    runRestart();
    ASSERT_TRUE(vehicle.armed);
    const uint8_t armed = newestFastRecord().number;
    keep();
    EXPECT_NE(newestFastRecord().number, armed);
}

TEST_F(Restart, flies_on_when_the_power_goes_again_before_there_was_evidence) {
    begin(ResetCause::unknown);
    lookAtSwitch(1165);
    runRestart();
    ASSERT_FALSE(vehicle.armed);
    begin(ResetCause::unknown);
    EXPECT_TRUE(flyingOn());
}

TEST_F(Restart, forgets_the_saved_home_when_it_is_disarmed_after_flying_on) {
    begin(ResetCause::watchdog);
    lookAtSwitch(1165);
    ASSERT_TRUE(vehicle.armed);
    mutable_vehicle.armed = false;
    keep();
    begin(ResetCause::power_on);
    EXPECT_FALSE(vehicle.home.set);
}

TEST_F(Restart, saves_home_again_whichever_part_of_it_has_changed_and_else_never) {
    const auto saved = [] {
        SavedHome home;
        EXPECT_EQ(readHome(home), core::Status::ok);
        return home;
    };
    keep();
    const uint32_t writes = fakes::eepromWrites();
    keep();
    EXPECT_EQ(fakes::eepromWrites(), writes);
    mutable_vehicle.home.position.latitude_e7 += 10;
    keep();
    EXPECT_EQ(saved().position.latitude_e7, kHome.latitude_e7 + 10);
    mutable_vehicle.home.position.longitude_e7 += 20;
    keep();
    EXPECT_EQ(saved().position.longitude_e7, kHome.longitude_e7 + 20);
    mutable_vehicle.home.altitude_cm += 30;
    keep();
    EXPECT_EQ(saved().altitude_cm, 48830);
}

TEST_F(Restart, saves_no_home_while_disarmed_and_none_that_is_not_set) {
    begin(ResetCause::asked);
    const uint32_t writes = fakes::eepromWrites();
    requestMode(Mode::manual, ModeReason::boot);
    mutable_vehicle.home = {kHome, 12300, true, false, 0};
    keep();
    EXPECT_EQ(fakes::eepromWrites(), writes) << "disarmed";
    mutable_vehicle.armed = true;
    mutable_vehicle.home.set = false;
    keep();
    EXPECT_EQ(fakes::eepromWrites(), writes) << "not set";
    mutable_vehicle.home.set = true;
    keep();
    EXPECT_GT(fakes::eepromWrites(), writes);
}

TEST_F(Restart, writes_once_that_the_saved_home_is_forgotten) {
    mutable_vehicle.armed = false;
    keep();
    SavedHome home;
    ASSERT_NE(readHome(home), core::Status::ok);
    ASSERT_EQ(saveHome(kHome, 48800), core::Status::ok);  // by nobody who has it forgotten
    keep();
    EXPECT_EQ(readHome(home), core::Status::ok);
}

TEST_F(Restart, writes_the_moving_record_in_every_second_run) {
    const uint8_t before = newestFastRecord().number;
    for (int i = 0; i < 10; ++i) runRestart();
    EXPECT_EQ(static_cast<uint8_t>(newestFastRecord().number - before), 5);
}

TEST_F(Restart, keeps_the_record_before_while_the_attitude_is_not_known) {
    mutable_vehicle.attitude.aligned = false;
    mutable_vehicle.home.altitude_cm = 1;
    runRestartSlowly();
    EXPECT_EQ(records.slow.home_altitude_cm, 48800);
}

TEST_F(Restart, reports_once_what_started_it) {
    using Texts = std::vector<std::string>;
    struct Row {
        ResetCause cause;
        uint8_t trace;
        bool flew;
        const char* text;
    };
    const Row rows[] = {
        {ResetCause::watchdog, 3, true, "2 Restarted by watchdog, task 3"},
        {ResetCause::watchdog, 3, false, "4 Restarted by watchdog, task 3"},
        {ResetCause::fault, hal::kTraceTaskEnd, true, "2 Restarted by a fault, task 0"},
        {ResetCause::brown_out, 0, false, "4 Restarted after a brown-out"},
        {ResetCause::power_on, 0, false, "6 Started by the supply"},
    };
    for (const Row& row : rows) {
        SetUp();
        mutable_vehicle.armed = row.flew;
        keep();
        begin(row.cause);
        fakes::watchdog().last_run.trace = row.trace;
        (void)statusTexts();
        runRestartSlowly();
        EXPECT_EQ(statusTexts(), Texts{row.text});
        runRestartSlowly();
        EXPECT_EQ(statusTexts(), Texts{});
    }
}

TEST_F(Restart, reports_an_internal_error_once) {
    begin(ResetCause::power_on);
    runRestartSlowly();
    (void)statusTexts();
    (void)core::check(false, core::InternalError::attitude_matrix, 7);
    runRestartSlowly();
    EXPECT_EQ(statusTexts(), std::vector<std::string>{"2 Internal error 1"});
    runRestartSlowly();
    EXPECT_TRUE(statusTexts().empty());
}

// The last record: level, and turning so quickly about the nose and upwards.
void lastRecordTurns(float roll_rads, float pitch_rads = 0) {
    FastRecord& record = records.fast[newestFastRecord().number & 1];
    record.pose = {{core::Ratio(1), core::Ratio(0), core::Ratio(0)},
                   {core::Ratio(0), core::Ratio(0), core::Ratio(1)}};
    record.rate_rads = core::BodyRates::from(roll_rads, pitch_rads, 0);
    updateChecksum(record);
}
float rollNow_rad() {
    mutable_vehicle.imu.calibrated = true;
    for (int i = 0; i < 10; ++i) rotateDcm();  // at most 0.2 rad at once
    return vehicle.attitude.roll_rad.toFloat();
}

// In pitch and yaw; a roll for 0.4 s at most.
TEST_F(Restart, turns_the_attitude_on_for_as_long_as_the_program_was_gone) {
    struct Row {
        ResetCause cause;
        float lost_s, roll_s;
    };
    // 0.3 s from the record to the end, which a loss of power leaves no time to note; 80 ms to the
    // start, or what the bootloader takes
    for (const Row& row :
         {Row{ResetCause::watchdog, 0.38f, 0.38f}, Row{ResetCause::brown_out, 1.165f, 0.4f},
          Row{ResetCause::unknown, 1.165f, 0.4f}}) {
        for (const bool rolls : {true, false}) {
            SetUp();
            keep();
            lastRecordTurns(rolls ? 1 : 0, rolls ? 0 : 0.5f);
            fakes::advance_ms(300);
            begin(row.cause);
            EXPECT_NEAR(rollNow_rad(), rolls ? row.roll_s : 0, 0.01f);
            EXPECT_NEAR(vehicle.attitude.pitch_rad.toFloat(), rolls ? 0 : 0.5f * row.lost_s, 0.01f);
        }
    }
}

// Records of a flight that was ended, or never saved, are not made valid by an attitude that is
// lost.
TEST_F(Restart, makes_no_record_old_that_is_none_of_this_flight) {
    for (const bool disarmed_before : {true, false}) {
        SetUp();
        if (disarmed_before) {
            mutable_vehicle.armed = false;
            keep();
        } else {
            begin(ResetCause::asked);
            requestMode(Mode::manual, ModeReason::boot);
        }
        mutable_vehicle.armed = true;
        mutable_vehicle.attitude.aligned = false;
        fakes::advance_ms(3000);
        keep();
        begin(ResetCause::watchdog);
        EXPECT_FALSE(flyingOn()) << disarmed_before;
    }
}

TEST_F(Restart, says_of_an_old_pose_that_it_is_a_second_old_and_not_younger_than_it_was) {
    fakes::advance_ms(2000);
    keep();
    const uint16_t measured_ms = newestFastRecord().at_ms;
    mutable_vehicle.attitude.aligned = false;
    fakes::advance_ms(900);
    keep();
    EXPECT_EQ(newestFastRecord().at_ms, measured_ms);
    fakes::advance_ms(200);
    keep();
    EXPECT_EQ(newestFastRecord().at_ms, measured_ms + 100);
}

// The clock of a record has 16 bits: 65.536 s.
TEST_F(Restart, takes_a_record_of_a_minute_ago_for_an_old_one) {
    lastRecordTurns(0, 0.3f);
    mutable_vehicle.attitude.aligned = false;
    for (int i = 0; i < 3290; ++i) {  // 65.8 s, at 50 Hz
        fakes::advance_ms(20);
        runRestart();
    }
    begin(ResetCause::watchdog);
    EXPECT_TRUE(flyingOn());
    (void)rollNow_rad();
    EXPECT_NEAR(vehicle.attitude.pitch_rad.toFloat(), 0.3f * 1.08f, 0.01f)
        << "old by a second, and 80 ms to the start";
}

TEST_F(Restart, turns_it_as_the_gyros_were_watched_while_the_program_hung) {
    struct Row {
        uint8_t periods;
        bool valid, used;
    };
    for (const Row& row : {Row{10, true, true}, Row{9, true, false}, Row{10, false, false}}) {
        SetUp();
        keep();
        lastRecordTurns(0);
        records.hang.turn = {{500, 500, 500}, row.periods};
        updateChecksum(records.hang, newestFastRecord());
        if (!row.valid) ++records.hang.checksum;
        begin(ResetCause::watchdog);
        EXPECT_EQ(fabsf(rollNow_rad()) > 0.001f, row.used) << int(row.periods) << row.valid;
    }
}

TEST_F(Restart, flies_on_as_before_without_a_receiver) {
    fakes::advance_ms(2000);
    keep();
    begin(ResetCause::watchdog);
    mutable_vehicle.radio.heard = false;
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

// It came down with the sensor dead: the heights of when that began would be wrong by all of the
// descent.
TEST_F(Restart, records_height_and_place_but_no_other_pose_while_the_inertial_sensor_is_dead) {
    const FastRecord before = newestFastRecord();
    mutable_vehicle.attitude.aligned = false;
    mutable_vehicle.mode = Mode::manual;
    mutable_vehicle.estimate.height_m = 12;
    mutable_vehicle.estimate.climb_mps = -2;
    mutable_vehicle.estimate.position = {473970000, 85450000};
    mutable_vehicle.estimate.known = true;
    keep();
    const FastRecord& now = newestFastRecord();
    EXPECT_NE(now.number, before.number);
    EXPECT_EQ(now.height_m, 12);
    EXPECT_EQ(now.climb_mps, -2);
    EXPECT_EQ(now.position.latitude_e7, 473970000);
    EXPECT_EQ(now.place_known, 1);
    EXPECT_EQ(memcmp(&now.pose, &before.pose, sizeof now.pose), 0);
    EXPECT_EQ(now.mode, before.mode) << "MANUAL is the failsafe's";
}

TEST_F(Restart, a_flight_that_ends_with_a_dead_inertial_sensor_is_over) {
    mutable_vehicle.attitude.aligned = false;
    mutable_vehicle.estimate.flying = false;
    keep();
    begin(ResetCause::watchdog);
    EXPECT_FALSE(flyingOn());
}

TEST_F(Restart, rejects_a_record_with_any_bit_changed) {
    records.slow.home_altitude_cm ^= 1;
    begin(ResetCause::watchdog);
    EXPECT_FALSE(flyingOn());

    SetUp();
    for (FastRecord& each : records.fast) each.position.latitude_e7 ^= 64;
    begin(ResetCause::watchdog);
    EXPECT_FALSE(flyingOn());
}

TEST_F(Restart, falls_back_on_the_record_before) {
    runRestart();
    records.fast[newestFastRecord().number & 1].at_ms ^= 1;
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
    invalidate(records.slow);
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
    invalidate(records.slow);
    begin(ResetCause::power_on);
    EXPECT_TRUE(vehicle.home.set) << "the power was lost once more";
}

TEST_F(Restart, finds_no_saved_home_when_the_flight_before_was_ended_by_disarming) {
    mutable_vehicle.armed = false;
    keep();
    begin(ResetCause::power_on);

    EXPECT_FALSE(vehicle.home.set);
}
