// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/safety/arming.hpp"
#include "firmware/sensors/compass_mounting.hpp"

#include <fstream>
#include <functional>
#include <sstream>
#include <string>

#include "core/internal_error.hpp"
#include "core/maths.hpp"
#include "firmware/gcs/link.hpp"
#include "firmware/mission/home.hpp"
#include "firmware/mission/mission.hpp"
#include "firmware/notify/text_queue.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware_bench.hpp"
#include "hal/eeprom.hpp"
#include "host_tests/support/fakes/vehicle.hpp"
#include "prearm.hpp"
#include "storage/eeprom_map.hpp"
#include "storage/owner.hpp"
#include "wrong_board.hpp"

namespace {

using firmware::safety::ArmReason;
using firmware::state::Mode;
using firmware::state::mutable_vehicle;
using firmware::state::parameters;
using firmware::state::vehicle;

struct Arming : bench::Bench {
    void SetUp() override {
        Bench::SetUp();
        makeReady();
        parameters.log_bitmask = 0;
        firmware::mission::missionBoot();
        for (int i = 0; i < 500 && !firmware::mission::missionKnown(); ++i) {
            firmware::mission::missionRun();
            fakes::advance_ms(10);
        }
    }
    static void makeReady() {
        mutable_vehicle.imu.healthy = mutable_vehicle.imu.calibrated = true;
        mutable_vehicle.imu.accel_mss = core::Accelerations::from(0, 0, -core::kGravity_mss);
        mutable_vehicle.attitude.aligned = true;
        mutable_vehicle.baro.healthy = mutable_vehicle.compass.healthy =
            mutable_vehicle.airspeed.healthy = true;
        mutable_vehicle.gps.healthy = true;
        mutable_vehicle.gps.fix = firmware::state::GpsFix::three_d;
        mutable_vehicle.gps.altitude_cm = 48800;
        mutable_vehicle.gps.hdop_c = 180;
        mutable_vehicle.compass.field_mg = {220, 30, 430};
        mutable_vehicle.compass.points_down = 1;
        mutable_vehicle.estimate.known = true;
        mutable_vehicle.estimate.position = {473977000, 85456000};
        mutable_vehicle.battery.board_mv = 5000;
        mutable_vehicle.battery.voltage_mv = 12000;
    }
    // Whether a status text on either link since the last call has this part.
    static bool hasStatusText(const std::string& part) {
        std::vector<uint8_t>& out = fakes::serial(hal::Port::link0).out;
        out.clear();
        for (firmware::gcs::Link& link : firmware::gcs::links)
            while (firmware::gcs::sendText(link)) {
            }
        const std::string said(out.begin(), out.end());
        return said.find(part) != std::string::npos;
    }
    static void look() {
        for (int tenth = 0; tenth < 10; ++tenth) firmware::safety::runArming();
    }
    uint16_t throttle_us = 1100;
    void holdRudder(uint16_t pulse_us, int tenths) {
        for (int tenth = 0; tenth < tenths; ++tenth) {
            std::vector<uint16_t> sticks = with(4, pulse_us);
            sticks[2] = throttle_us;
            fakes::receiveRc(sticks);
            firmware::sensors::runRadio();
            firmware::safety::runArming();
            fakes::advance_ms(100);
        }
    }
};

TEST_F(Arming, arms_when_every_check_passes_and_takes_home_there) {
    EXPECT_TRUE(firmware::safety::arm(ArmReason::ground, false));
    EXPECT_TRUE(vehicle.armed);
    EXPECT_TRUE(vehicle.home.set);
    EXPECT_EQ(vehicle.home.position, (geo::Position{473977000, 85456000}));
    EXPECT_EQ(vehicle.home.altitude_cm, 48800);
}

struct Refined : Arming {
    static void run(int tenths) {
        for (int tenth = 0; tenth < tenths; ++tenth) firmware::safety::runArming();
    }
    void SetUp() override {
        Arming::SetUp();
        mutable_vehicle.gps.fix = firmware::state::GpsFix::none;
    }
    static void fix() { mutable_vehicle.gps.fix = firmware::state::GpsFix::three_d; }
    static void moveBy(float north_m) {
        mutable_vehicle.estimate.position = geo::moved(vehicle.estimate.position, {north_m, 0});
    }
};

TEST_F(Refined, home_is_there_with_the_first_good_fix) {
    run(10);
    EXPECT_FALSE(vehicle.home.set);
    fix();
    mutable_vehicle.gps.hdop_c = 360;
    run(10);
    EXPECT_FALSE(vehicle.home.set);
    mutable_vehicle.gps.hdop_c = 180;
    run(2);
    EXPECT_TRUE(vehicle.home.set);
    EXPECT_EQ(vehicle.home.position, vehicle.estimate.position);
    EXPECT_EQ(vehicle.home.altitude_cm, 48800);
    EXPECT_FALSE(vehicle.armed);
}

TEST_F(Refined, home_follows_an_airplane_that_is_carried_and_stays_with_one_that_stands) {
    fix();
    run(2);
    const uint8_t changes = vehicle.home.changes;
    moveBy(2);
    run(120);
    EXPECT_EQ(vehicle.home.changes, changes);
    moveBy(20);
    run(60);
    EXPECT_EQ(vehicle.home.position, vehicle.estimate.position);
    EXPECT_EQ(static_cast<uint8_t>(vehicle.home.changes - changes), 1);
}

TEST_F(Refined, home_follows_a_height_that_has_drifted) {
    fix();
    run(2);
    const uint8_t changes = vehicle.home.changes;
    mutable_vehicle.gps.altitude_cm += 400;
    run(60);
    EXPECT_EQ(vehicle.home.altitude_cm, 49200);
    mutable_vehicle.estimate.height_m = 3;
    run(60);
    EXPECT_FLOAT_EQ(vehicle.estimate.height_m, 0);
    EXPECT_EQ(static_cast<uint8_t>(vehicle.home.changes - changes), 2);
}

TEST_F(Refined, home_is_not_set_while_it_moves) {
    fix();
    mutable_vehicle.estimate.ground_speed_mps = 4;
    run(60);
    EXPECT_FALSE(vehicle.home.set);
}

TEST_F(Refined, home_that_the_pilot_has_set_stays_until_arming) {
    fix();
    run(2);
    const geo::Position place = geo::moved(vehicle.estimate.position, {300, 0});
    firmware::mission::setHome(place, 50000);
    run(120);
    EXPECT_EQ(vehicle.home.position, place);
    EXPECT_TRUE(firmware::safety::arm(ArmReason::ground, false));
    EXPECT_EQ(vehicle.home.position, vehicle.estimate.position);
    EXPECT_TRUE(hasStatusText("Home moved by 300 m"));
    EXPECT_TRUE(firmware::safety::disarm(ArmReason::ground, false));
    moveBy(50);
    run(60);
    EXPECT_EQ(vehicle.home.position, vehicle.estimate.position);
}

TEST_F(Refined, home_that_moved_a_little_is_not_reported) {
    fix();
    run(2);
    moveBy(4);
    EXPECT_TRUE(firmware::safety::arm(ArmReason::ground, false));
    EXPECT_EQ(vehicle.home.position, vehicle.estimate.position);
    EXPECT_FALSE(hasStatusText("Home moved"));
}

TEST_F(Refined, home_that_moved_by_more_than_five_metres_is_reported) {
    fix();
    run(2);
    moveBy(7);
    EXPECT_TRUE(firmware::safety::arm(ArmReason::ground, false));
    EXPECT_TRUE(hasStatusText("Home moved by 7 m"));
}

TEST_F(Refined, home_of_before_is_named_when_there_is_no_fix_at_arming) {
    fix();
    run(2);
    const geo::Position home = vehicle.home.position;
    mutable_vehicle.gps.fix = firmware::state::GpsFix::none;
    EXPECT_TRUE(firmware::safety::arm(ArmReason::ground, true));
    EXPECT_EQ(vehicle.home.position, home);
    EXPECT_TRUE(hasStatusText("Armed, home as before"));
}

TEST_F(Refined, home_of_a_flight_that_goes_on_after_a_restart_stays) {
    fix();
    const geo::Position home = geo::moved(vehicle.estimate.position, {-800, 0});
    firmware::mission::resumeHome(home, 40000);
    run(120);
    EXPECT_EQ(vehicle.home.position, home);
}

struct Fault {
    int16_t bit;  // of ARMING_CHECK
    const char* reason;
    std::function<void()> happens;
};
// Parameters that stand in an EEPROM with this first byte, and of which two bits have changed.
void storedBy(uint8_t first) {
    fakes::setEepromCell(0, first);
    if (first != 0xB7) fakes::setEepromCell(8, first);
    fakes::setEepromCell(storage::parameterAddress(100), 0xFE);
    fakes::setEepromCell(storage::parameterAddress(101), 0xFE);
    const firmware::state::Parameters now = parameters;
    while (firmware::state::parametersLoad() == core::Status::busy) fakes::advance_ms(10);
    static_cast<firmware::state::Parameters&>(parameters) = now;
}
class Check : public Arming, public testing::WithParamInterface<Fault> {};

TEST_P(Check, refuses_to_arm_and_says_why) {
    GetParam().happens();
    EXPECT_FALSE(firmware::safety::arm(ArmReason::ground, false));
    const std::string reason = GetParam().reason;
    EXPECT_TRUE(hasStatusText(reason.substr(0, reason.find('#')))) << reason;
    EXPECT_FALSE(vehicle.armed);
}
TEST_P(Check, is_made_by_its_bit_of_arming_check) {
    GetParam().happens();
    parameters.arming_check = GetParam().bit;
    EXPECT_NE(bench::prearmFailure(), "");
    parameters.arming_check = static_cast<int16_t>(0x7FFE & ~GetParam().bit);
    EXPECT_EQ(bench::prearmFailure(), "");
}
INSTANTIATE_TEST_SUITE_P(
    Faults, Check,
    testing::Values(
        Fault{16, "PreArm: gyros not ready", [] { mutable_vehicle.imu.calibrated = false; }},
        Fault{16, "PreArm: gyros not healthy", [] { mutable_vehicle.imu.healthy = false; }},
        Fault{16, "PreArm: accelerometers",
              [] { mutable_vehicle.imu.accel_mss = core::Accelerations::from(0, 0, -7.5f); }},
        Fault{16, "PreArm: accelerometers",
              [] { mutable_vehicle.imu.accel_mss = core::Accelerations::from(8, 3, -9); }},
        Fault{16, "PreArm: attitude", [] { mutable_vehicle.attitude.aligned = false; }},
        Fault{2, "PreArm: barometer", [] { mutable_vehicle.baro.healthy = false; }},
        Fault{4, "PreArm: compass", [] { mutable_vehicle.compass.healthy = false; }},
        Fault{4, "PreArm: check mag field",
              [] {
                  mutable_vehicle.compass.field_mg = {90, 90, 90};
              }},
        Fault{4, "PreArm: check mag field",
              [] {
                  mutable_vehicle.compass.field_mg = {0, 900, 0};
              }},
        Fault{4, "PreArm: compass offsets",
              [] { parameters.compass.offset_mg[0] = parameters.compass.offset_mg[1] = 380; }},
        Fault{4, "PreArm: compass offsets", [] { parameters.compass.offset_mg[2] = 510; }},
        Fault{4, "PreArm: compass upside down",
              [] {
                  mutable_vehicle.compass.field_mg = {200, 0, -430};
              }},
        Fault{4, "PreArm: compass upside down",
              [] {
                  mutable_vehicle.compass.field_mg = {200, 0, 430};
                  mutable_vehicle.compass.points_down = -1;
              }},
        Fault{4, "PreArm: compass upside down",
              [] {  // on its tail
                  mutable_vehicle.imu.accel_mss =
                      core::Accelerations::from(core::kGravity_mss, 0, 0);
                  mutable_vehicle.compass.field_mg = {430, 0, 200};
              }},
        Fault{4, "PreArm: compass upside down",
              [] {  // on its side
                  mutable_vehicle.imu.accel_mss =
                      core::Accelerations::from(0, core::kGravity_mss, 0);
                  mutable_vehicle.compass.field_mg = {0, 430, 200};
              }},
        Fault{4, "PreArm: set COMPASS_ORIENT #",
              [] {  // flown to the north and back with the field on the right
                  mutable_vehicle.gps.ground_speed_mps = 12;
                  mutable_vehicle.compass.accepted = true;
                  const core::Vector3 before_mg = vehicle.compass.field_mg;
                  for (const float right_mg : {200.0f, -200.0f}) {
                      mutable_vehicle.gps.course_cd = right_mg > 0 ? 0 : 18000;
                      mutable_vehicle.gps.velocity_mps = {right_mg > 0 ? 12.0f : -12.0f, 0, 0};
                      mutable_vehicle.compass.field_mg = {0, right_mg, 430};
                      for (int look = 0; look < 8; ++look)
                          firmware::sensors::watchCompassMounting();
                  }
                  mutable_vehicle.compass.field_mg = before_mg;
              }},
        Fault{8, "PreArm: no GPS fix",
              [] { mutable_vehicle.gps.fix = firmware::state::GpsFix::two_d; }},
        Fault{8, "PreArm: no GPS fix", [] { mutable_vehicle.estimate.known = false; }},
        Fault{8, "PreArm: high GPS HDOP", [] { mutable_vehicle.gps.hdop_c = 400; }},
        Fault{512, "PreArm: airspeed sensor", [] { mutable_vehicle.airspeed.healthy = false; }},
        Fault{64, "PreArm: no radio", [] { mutable_vehicle.radio.lost = true; }},
        Fault{64, "PreArm: no radio", [] { mutable_vehicle.radio.heard = false; }},
        Fault{64, "PreArm: RC# not calibrated", [] { parameters.channel[1].min_us = 1400; }},
        Fault{64, "PreArm: RC# not calibrated", [] { parameters.channel[3].max_us = 1600; }},
        Fault{64, "PreArm: RC# not calibrated", [] { parameters.channel[0].trim_us = 1950; }},
        Fault{64, "PreArm: RCMAP: RC# twice", [] { parameters.map_throttle = 2; }},
        Fault{64, "PreArm: throttle is up", [] { mutable_vehicle.radio.throttle_pct = 10; }},
        Fault{128, "PreArm: board voltage", [] { mutable_vehicle.battery.board_mv = 4100; }},
        Fault{256, "PreArm: battery low",
              [] {
                  parameters.battery_monitor = 3;
                  parameters.battery_low_v = 10;
                  mutable_vehicle.battery.voltage_mv = 9900;
              }},
        Fault{16384, "PreArm: mission unreadable",
              [] {  // yet: the EEPROM is busy
                  fakes::setEepromSlow(true);
                  const uint8_t other = 1;
                  ASSERT_EQ(hal::eepromWrite(100, &other, 1), core::Status::ok);
                  firmware::mission::missionBoot();
              }},
        Fault{32, "PreArm: EEPROM is not ours", [] { storedBy(0x41); }},
        Fault{32, "PreArm: parameters damaged",
              [] {
                  ASSERT_EQ(storage::claim(), core::Status::ok);
                  firmware::state::parameterSet(3, 90);
                  firmware::state::parametersRun();
                  storedBy(0xB7);
              }},
        Fault{1024, "PreArm: no log chip", [] { parameters.log_bitmask = 1; }}));

TEST_F(Arming, does_not_arm_after_an_internal_error_whatever_is_left_out) {
    parameters.arming_check = 0;
    EXPECT_TRUE(core::check(true, core::InternalError::height_not_finite, __LINE__));
    EXPECT_EQ(bench::prearmFailure(), "");
    EXPECT_FALSE(core::check(false, core::InternalError::height_not_finite, __LINE__));
    EXPECT_FALSE(firmware::safety::arm(ArmReason::ground, false));
    EXPECT_TRUE(hasStatusText("PreArm: internal error 2"));
    EXPECT_EQ(core::internalErrors().times[2], 1);
    EXPECT_EQ(core::internalErrors().line, __LINE__ - 4);
}

TEST_F(Arming, accepts_the_battery_that_the_battery_failsafe_accepts) {
    parameters.battery_monitor = 4;
    mutable_vehicle.battery.voltage_mv = 7400;
    EXPECT_TRUE(firmware::safety::arm(ArmReason::ground, false)) << "two cells";
    mutable_vehicle.armed = false;
    mutable_vehicle.battery.voltage_mv = 7400;
    parameters.battery_low_v = 7.0f;
    EXPECT_TRUE(firmware::safety::arm(ArmReason::ground, false));
    mutable_vehicle.armed = false;
    mutable_vehicle.battery.voltage_mv = 6900;
    EXPECT_FALSE(firmware::safety::arm(ArmReason::ground, false));
    EXPECT_TRUE(hasStatusText("PreArm: battery low"));
}

TEST_F(Arming, accepts_what_is_just_good_enough) {
    parameters.channel[1].min_us = 1300;
    parameters.channel[1].max_us = 1700;
    mutable_vehicle.radio.throttle_pct = 3;
    mutable_vehicle.gps.hdop_c = 350;
    mutable_vehicle.battery.board_mv = 4300;
    EXPECT_EQ(bench::prearmFailure(), "");
    mutable_vehicle.battery.board_mv = 5800;
    EXPECT_EQ(bench::prearmFailure(), "");
    mutable_vehicle.radio.throttle_pct = 4;
    EXPECT_NE(bench::prearmFailure(), "");
}

TEST_F(Arming, accepts_sensors_at_the_bounds_of_what_is_plausible) {
    const auto rawForce = [](int16_t x, int16_t y, int16_t z) {
        auto& force = mutable_vehicle.imu.accel_mss;
        force.x.raw = x;
        force.y.raw = y;
        force.z.raw = z;
    };
    for (const int16_t tenths : {78, 118}) {
        rawForce(0, 0, static_cast<int16_t>(-26 * tenths));
        EXPECT_EQ(bench::prearmFailure(), "") << tenths;
    }
    makeReady();
    for (const float field_mg : {185.0f, 875.0f}) {
        mutable_vehicle.compass.field_mg = {0, 0, field_mg};
        EXPECT_EQ(bench::prearmFailure(), "") << field_mg;
    }
    makeReady();
    parameters.compass.offset_mg[1] = 500;
    EXPECT_EQ(bench::prearmFailure(), "");
    rawForce(0, 0, -2510);  // 1 g
    mutable_vehicle.compass.field_mg = {200, 0, -80};
    EXPECT_EQ(bench::prearmFailure(), "") << "hardly upside down";
    mutable_vehicle.compass.field_mg = {200, 0, -81};
    EXPECT_EQ(bench::prearmFailure(), "PreArm: compass upside down");
}

TEST_F(Arming, accepts_settings_at_the_bounds_of_what_is_plausible) {
    parameters.battery_monitor = 4;
    parameters.battery_low_v = 7;
    mutable_vehicle.battery.voltage_mv = 7000;
    EXPECT_EQ(bench::prearmFailure(), "");
    for (const int16_t trim_us : {parameters.channel[0].min_us, parameters.channel[0].max_us}) {
        parameters.channel[0].trim_us = trim_us;
        EXPECT_EQ(bench::prearmFailure(), "") << trim_us;
    }
}

TEST_F(Arming, waits_for_a_calibration_but_not_for_the_airplane_to_lie_still) {
    using firmware::state::Calibrating;
    mutable_vehicle.calibrating = Calibrating::rest;
    EXPECT_EQ(bench::prearmFailure(), "");
    mutable_vehicle.calibrating = static_cast<Calibrating>(uint8_t(Calibrating::rest) + 1);
    parameters.arming_check = 0;
    EXPECT_EQ(bench::prearmFailure(), "PreArm: calibrating");
}

TEST_F(Arming, looks_at_three_checks_in_a_run_so_that_all_are_made_within_a_second) {
    for (int run = 0; run < 9; ++run) firmware::safety::runArming();
    EXPECT_FALSE(vehicle.prearm_ok);
    firmware::safety::runArming();
    EXPECT_TRUE(vehicle.prearm_ok);
}

TEST_F(Arming, reports_a_failed_check_ten_seconds_after_the_start_at_the_earliest) {
    fakes::resetClock();
    mutable_vehicle.baro.healthy = false;
    fakes::advance_ms(9999);
    look();
    EXPECT_FALSE(hasStatusText("PreArm: barometer"));
    fakes::advance_ms(1);
    look();
    EXPECT_TRUE(hasStatusText("PreArm: barometer"));
    fakes::advance_ms(29999);
    look();
    EXPECT_FALSE(hasStatusText("PreArm: barometer"));
    fakes::advance_ms(1);
    look();
    EXPECT_TRUE(hasStatusText("PreArm: barometer"));
}

TEST_F(Arming, reports_the_wrong_board_every_five_seconds) {
    bench::findBoard(true);
    fakes::advance_ms(10000);
    look();
    EXPECT_TRUE(hasStatusText("Wrong board: for an APM 2"));
    fakes::advance_ms(4999);
    look();
    EXPECT_FALSE(hasStatusText("Wrong board"));
    fakes::advance_ms(1);
    look();
    EXPECT_TRUE(hasStatusText("Wrong board"));
}

TEST_F(Arming, keeps_its_home_when_it_is_armed_already) {
    ASSERT_TRUE(firmware::safety::arm(ArmReason::ground, false));
    const geo::Position home = vehicle.home.position;
    mutable_vehicle.estimate.position.latitude_e7 += 50000;
    mutable_vehicle.baro.healthy = false;
    EXPECT_TRUE(firmware::safety::arm(ArmReason::ground, false)) << "no check either";
    EXPECT_EQ(vehicle.home.position, home);
}

TEST_F(Arming, by_the_rudder_takes_three_seconds_and_no_less) {
    parameters.arming_rudder = 2;
    holdRudder(1900, 30);
    EXPECT_FALSE(vehicle.armed);
    holdRudder(1900, 1);
    EXPECT_TRUE(vehicle.armed);
}

TEST_F(Arming, can_be_forced) {
    mutable_vehicle.baro.healthy = false;
    EXPECT_TRUE(firmware::safety::arm(ArmReason::ground, true));
}

TEST_F(Arming, leaves_out_the_checks_not_asked_for) {
    parameters.arming_check = 8;  // GPS alone
    mutable_vehicle.baro.healthy = false;
    look();
    EXPECT_TRUE(firmware::state::vehicle.prearm_ok);
    mutable_vehicle.gps.fix = firmware::state::GpsFix::none;
    look();
    EXPECT_FALSE(firmware::state::vehicle.prearm_ok);
}

TEST_F(Arming, takes_three_seconds_of_full_right_rudder) {
    holdRudder(1900, 28);
    EXPECT_FALSE(vehicle.armed);
    holdRudder(1900, 5);
    EXPECT_TRUE(vehicle.armed);
}

TEST_F(Arming, by_rudder_is_refused_with_the_reason) {
    mutable_vehicle.gps.fix = firmware::state::GpsFix::none;
    holdRudder(1900, 33);
    EXPECT_FALSE(vehicle.armed);
    EXPECT_TRUE(hasStatusText("PreArm: no GPS fix"));
}

TEST_F(Arming, by_rudder_needs_the_throttle_closed_and_arming_rudder_set) {
    throttle_us = 1250;
    holdRudder(1900, 40);
    EXPECT_FALSE(vehicle.armed);
    throttle_us = 1100;
    parameters.arming_rudder = 0;
    holdRudder(1900, 40);
    EXPECT_FALSE(vehicle.armed);
}

TEST_F(Arming, left_rudder_disarms_on_the_ground_when_arming_rudder_is_2) {
    ASSERT_TRUE(firmware::safety::arm(ArmReason::ground, false));
    holdRudder(1100, 40);
    EXPECT_TRUE(vehicle.armed) << "1 arms only";
    parameters.arming_rudder = 2;
    mutable_vehicle.estimate.flying = true;
    holdRudder(1100, 40);
    EXPECT_TRUE(vehicle.armed) << "gliding";
    mutable_vehicle.estimate.flying = false;
    holdRudder(1100, 28);
    EXPECT_TRUE(vehicle.armed);
    holdRudder(1100, 5);
    EXPECT_FALSE(vehicle.armed);
}

TEST_F(Arming, names_the_channel_that_is_not_calibrated) {
    parameters.channel[3].max_us = 1600;
    EXPECT_FALSE(firmware::safety::arm(ArmReason::ground, false));
    EXPECT_TRUE(hasStatusText("PreArm: RC4 not calibrated"));
}

TEST_F(Arming, names_the_channel_that_two_sticks_share) {
    parameters.map_yaw = 1;
    EXPECT_FALSE(firmware::safety::arm(ArmReason::ground, false));
    EXPECT_TRUE(hasStatusText("PreArm: RCMAP: RC1 twice"));
    parameters.map_yaw = 8;
    EXPECT_TRUE(firmware::safety::arm(ArmReason::ground, false));
}

// What requests do in each state, with and without a check that fails.
struct ArmingTable : Arming {
    bool armedAfter(const std::function<void()>& ask, bool armed, bool flying, bool checks_pass) {
        TearDown();
        SetUp();
        parameters.arming_rudder = 2;
        mutable_vehicle.baro.healthy = checks_pass;
        mutable_vehicle.armed = armed;
        mutable_vehicle.estimate.flying = flying;
        ask();
        return vehicle.armed;
    }
    std::string cell(const std::function<void()>& ask, bool armed, bool flying) {
        const bool then = armedAfter(ask, armed, flying, true);
        const bool unchecked = armedAfter(ask, armed, flying, false);
        if (armed) {
            EXPECT_EQ(then, unchecked) << "disarming has no checks";
            return then ? "-" : "disarms";
        }
        return !then ? "-" : unchecked ? "arms" : "arms after the checks";
    }
    std::string row(const std::string& who, const std::function<void()>& ask) {
        std::string row = "\n| " + who + " |";
        for (const bool armed : {false, true})
            for (const bool flying : {false, true}) row += " " + cell(ask, armed, flying) + " |";
        return row + "\n";
    }
    void ground(bool force) {
        if (vehicle.armed)
            (void)firmware::safety::disarm(ArmReason::ground, force);
        else
            (void)firmware::safety::arm(ArmReason::ground, force);
    }
    void rudder() { holdRudder(vehicle.armed ? 1100 : 1900, 40); }
    void lands() {
        mutable_vehicle.mode = Mode::automatic;
        mutable_vehicle.demand.path = firmware::state::Path::land;
        mutable_vehicle.progress.flaring = true;
        for (int s = 0; s < parameters.land_disarm_delay_s + 2; ++s) look();
    }
};

TEST_F(ArmingTable, is_that_of_the_manual) {
    std::stringstream page;
    page << std::ifstream(FAILSAFE_MANUAL).rdbuf();
    const std::string manual = page.str();
    const std::string rows[] = {
        row("rudder, `ARMING_RUDDER` 2", [this] { rudder(); }),
        row("ground station", [this] { ground(false); }),
        row("ground station by force", [this] { ground(true); }),
        row("landing of AUTO", [this] { lands(); }),
        row("restart in the air", [] { firmware::safety::armAfterRestart(); }),
    };
    for (const std::string& each : rows) EXPECT_NE(manual.find(each), manual.npos) << each;
}

TEST_F(Arming, reports_the_failed_check_twice_a_minute) {
    mutable_vehicle.baro.healthy = false;
    int reported = 0;
    for (int tenth = 0; tenth < 1200; ++tenth) {
        firmware::safety::runArming();
        if (hasStatusText("PreArm: barometer")) ++reported;
        fakes::advance_ms(100);
    }
    EXPECT_EQ(reported, 4);
}

TEST_F(Arming, refuses_to_disarm_in_flight_unless_forced) {
    ASSERT_TRUE(firmware::safety::arm(ArmReason::ground, false));
    mutable_vehicle.estimate.flying = true;
    EXPECT_FALSE(firmware::safety::disarm(ArmReason::ground, false));
    EXPECT_TRUE(vehicle.armed);
    EXPECT_TRUE(firmware::safety::disarm(ArmReason::ground, true));
    EXPECT_FALSE(vehicle.armed);
}

TEST_F(Arming, disarmed_already_it_is_disarmed_without_a_text) {
    mutable_vehicle.estimate.flying = true;
    EXPECT_TRUE(firmware::safety::disarm(ArmReason::ground, false));
    EXPECT_FALSE(hasStatusText("isarm"));
}

TEST_F(Arming, stays_armed_after_a_landing_when_the_delay_is_0) {
    ASSERT_TRUE(firmware::safety::arm(ArmReason::ground, false));
    parameters.land_disarm_delay_s = 0;
    mutable_vehicle.mode = Mode::automatic;
    mutable_vehicle.demand.path = firmware::state::Path::land;
    mutable_vehicle.progress.flaring = true;
    for (int tenth = 0; tenth < 600; ++tenth) {
        firmware::safety::runArming();
        fakes::advance_ms(100);
    }
    EXPECT_TRUE(vehicle.armed);
}

TEST_F(Arming, disarms_by_itself_some_seconds_after_a_landing) {
    ASSERT_TRUE(firmware::safety::arm(ArmReason::ground, false));
    firmware::safety::runArming();
    mutable_vehicle.mode = Mode::automatic;
    mutable_vehicle.demand.path = firmware::state::Path::land;
    mutable_vehicle.progress.flaring = true;
    const int delay_s = parameters.land_disarm_delay_s;
    for (int tenth = 0; tenth < delay_s * 10; ++tenth) {
        firmware::safety::runArming();
        fakes::advance_ms(100);
    }
    EXPECT_TRUE(vehicle.armed);
    for (int tenth = 0; tenth < 5; ++tenth) {
        firmware::safety::runArming();
        fakes::advance_ms(100);
    }
    EXPECT_FALSE(vehicle.armed);
}

}  // namespace
