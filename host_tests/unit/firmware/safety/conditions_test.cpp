// SPDX-License-Identifier: GPL-3.0-or-later
// Decisions of two conditions and more about arming, failsafes and modes, each as a truth table.
#include <vector>

#include "core/maths.hpp"
#include "firmware/modes/mode_requests.hpp"
#include "firmware/safety/arming.hpp"
#include "firmware/safety/failsafe.hpp"
#include "firmware/safety/failsafe_causes.hpp"
#include "firmware/safety/failsafe_table.hpp"
#include "firmware/safety/restart_evidence.hpp"
#include "firmware/sensors/health.hpp"
#include "firmware_bench.hpp"
#include "hal/clock.hpp"
#include "prearm.hpp"
#include "truth_table.hpp"
#include "wrong_board.hpp"

namespace {

using namespace firmware::safety;
using firmware::sensors::Sensor;
using firmware::state::GpsFix;
using firmware::state::Mode;
using firmware::state::mutable_vehicle;
using firmware::state::parameters;
using firmware::state::Path;
using firmware::state::vehicle;

using bench::all;
using bench::any;
using bench::Bits;
using bench::Decision;
using bench::Set;

// All that arming asks for.
struct Ready : bench::Bench {
    void SetUp() override {
        Bench::SetUp();
        auto& all = mutable_vehicle;
        all.imu.healthy = all.imu.calibrated = all.attitude.aligned = true;
        all.imu.accel_mss = core::Accelerations::from(0, 0, -core::kGravity_mss);
        all.baro.healthy = all.compass.healthy = all.airspeed.healthy = all.gps.healthy = true;
        all.gps.fix = GpsFix::three_d;
        all.gps.hdop_c = 180;
        all.compass.field_mg = {220, 30, 430};
        all.compass.points_down = 1;
        all.estimate.known = all.home.set = all.log_usable = true;
        all.battery.board_mv = 5000;
        all.battery.voltage_mv = 12000;
        fakes::advance_ms(20000);
    }
};
struct Conditions : bench::TruthTable<Ready> {};

// ---- arming

// Whether a check of these bits of ARMING_CHECK fails, and with this reason.
bool refused(int16_t bits, const char* reason) {
    parameters.arming_check = bits;
    return bench::prearmFailure() == reason;
}

void compassUsed(bool is) { parameters.compass_use = is; }
void radioLost(bool is) { mutable_vehicle.radio.lost = is; }
void neverReceived(bool is) { mutable_vehicle.radio.heard = !is; }
void flying(bool is) { mutable_vehicle.estimate.flying = is; }
void known(bool is) { mutable_vehicle.estimate.known = is; }
void homeSet(bool is) { mutable_vehicle.home.set = is; }
void armed(bool is) { mutable_vehicle.armed = is; }

TEST_F(Conditions, of_each_check_of_the_sensors_turn_it_alone) {
    check({
        {"accelerometers",
         {[](bool is) {
              if (is) mutable_vehicle.imu.accel_mss = core::Accelerations::from(0, 0, -7.0f);
          },
          [](bool is) {
              if (is) mutable_vehicle.imu.accel_mss = core::Accelerations::from(0, 0, -12.5f);
          }},
         [] { return refused(16, "PreArm: accelerometers"); },
         any},
        {"compass",
         {compassUsed, [](bool is) { mutable_vehicle.compass.healthy = !is; }},
         [] { return refused(4, "PreArm: compass"); },
         all},
        {"magnetic field",
         {compassUsed,
          [](bool is) {
              if (is) mutable_vehicle.compass.field_mg = {60, 10, 120};
          },
          [](bool is) {
              if (is) mutable_vehicle.compass.field_mg = {660, 90, 1290};
          }},
         [] { return refused(4, "PreArm: check mag field"); },
         [](const Bits& is) { return is[0] && (is[1] || is[2]); }},
        {"compass offsets",
         {compassUsed, [](bool is) { parameters.compass.offset_mg[1] = is ? 510 : 490; }},
         [] { return refused(4, "PreArm: compass offsets"); },
         all},
        {"compass upside down",
         {compassUsed,
          [](bool is) {
              mutable_vehicle.compass.field_mg = {220, 30, is ? -430.0f : 430.0f};
          }},
         [] { return refused(4, "PreArm: compass upside down"); },
         all},
        {"GPS",
         {[](bool is) { mutable_vehicle.gps.fix = is ? GpsFix::two_d : GpsFix::three_d; },
          [](bool is) { known(!is); }},
         [] { return refused(8, "PreArm: no GPS fix"); },
         any},
    });
}
TEST_F(Conditions, of_each_check_of_the_receiver_turn_it_alone) {
    check({
        {"radio", {radioLost, neverReceived}, [] { return refused(64, "PreArm: no radio"); }, any},
        {"throttle",
         {radioLost, neverReceived,
          [](bool is) { mutable_vehicle.radio.throttle_pct = is ? 4 : 3; }},
         [] { return refused(64, "PreArm: throttle is up"); },
         [](const Bits& is) { return !is[0] && !is[1] && is[2]; }},
        {"RC calibration",
         {[](bool is) { parameters.channel[0].min_us = is ? 1301 : 1300; },
          [](bool is) { parameters.channel[0].max_us = is ? 1699 : 1700; },
          [](bool is) {
              if (is) parameters.channel[0].trim_us = parameters.channel[0].min_us - 1;
          },
          [](bool is) {
              if (is) parameters.channel[0].trim_us = parameters.channel[0].max_us + 1;
          }},
         [] { return refused(64, "PreArm: RC1 not calibrated"); },
         any},
    });
}
TEST_F(Conditions, of_each_check_of_airspeed_supply_and_log_turn_it_alone) {
    check({
        {"airspeed",
         {[](bool is) { parameters.airspeed_enable = is; },
          [](bool is) { parameters.airspeed_use = is; },
          [](bool is) { mutable_vehicle.airspeed.healthy = !is; }},
         [] { return refused(512, "PreArm: airspeed sensor"); },
         all},
        {"board voltage",
         {[](bool is) {
              if (is) mutable_vehicle.battery.board_mv = 4299;
          },
          [](bool is) {
              if (is) mutable_vehicle.battery.board_mv = 5801;
          }},
         [] { return refused(128, "PreArm: board voltage"); },
         any},
        {"battery",
         {[](bool is) { parameters.battery_monitor = is ? 4 : 0; },
          [](bool is) { mutable_vehicle.battery.voltage_mv = is ? 6001 : 6000; },
          [](bool is) { parameters.battery_low_v = is ? 7.0f : 5.0f; }},
         [] { return refused(256, "PreArm: battery low"); },
         all},
        {"logging",
         {[](bool is) { parameters.log_bitmask = is; },
          [](bool is) { mutable_vehicle.log_usable = !is; }},
         [] { return refused(1024, "PreArm: no log chip"); },
         all},
        {"whether a check is made",
         {[](bool is) { parameters.arming_check = is ? 8 : 0; },
          [](bool is) { parameters.arming_check |= is ? 1 : 0; }},
         [] {
             mutable_vehicle.gps.hdop_c = 351;
             return bench::prearmFailure() == "PreArm: high GPS HDOP";
         },
         any},
    });
}

bool forced;
ArmReason reason;

TEST_F(Conditions, of_arming_and_disarming_by_order_turn_them_alone) {
    check({
        {"arms",
         {[](bool is) { forced = is; }, [](bool is) { bench::findBoard(is); },
          [](bool is) { mutable_vehicle.gps.hdop_c = is ? 351 : 350; }},
         [] {
             parameters.arming_check = 8;
             return arm(ArmReason::ground, forced);
         },
         [](const Bits& is) { return !is[1] && (is[0] || !is[2]); }},
        {"disarms",
         {flying, [](bool is) { reason = is ? ArmReason::landed : ArmReason::ground; },
          [](bool is) { forced = is; }},
         [] {
             mutable_vehicle.armed = true;
             const bool done = disarm(reason, forced);
             EXPECT_NE(vehicle.armed, done);
             return done;
         },
         [](const Bits& is) { return !is[0] || is[1] || is[2]; }},
    });
}

bool armedAfterRunning(int tenths) {
    for (int i = 0; i < tenths; ++i) runArming();
    return vehicle.armed;
}

const std::vector<Set> kRudder = {
    [](bool is) { parameters.arming_rudder = is ? 2 : 0; },
    [](bool is) { radioLost(!is); },
    [](bool is) { mutable_vehicle.mode = is ? Mode::fbwa : Mode::loiter; },
    [](bool is) { flying(!is); },
    [](bool is) { mutable_vehicle.radio.throttle_pct = is ? 0 : 1; },
    [](bool is) { mutable_vehicle.radio.yaw_cd = is ? 4001 : 4000; },
};

TEST_F(Conditions, of_arming_and_disarming_by_the_rudder_turn_them_alone) {
    check({
        {"arms by the rudder", kRudder,
         [] {
             parameters.arming_check = 0;
             return armedAfterRunning(31);
         },
         all},
        {"disarms by the rudder", kRudder,
         [] {
             mutable_vehicle.armed = true;
             mutable_vehicle.radio.yaw_cd = static_cast<int16_t>(-vehicle.radio.yaw_cd);
             return !armedAfterRunning(31);
         },
         all},
    });
}

TEST_F(Conditions, of_disarming_after_a_landing_turn_it_alone) {
    check({{"disarms after a landing",
            {[](bool is) { mutable_vehicle.demand.path = is ? Path::land : Path::leg; },
             [](bool is) { mutable_vehicle.progress.flaring = is; },
             [](bool is) { mutable_vehicle.mode = is ? Mode::automatic : Mode::loiter; },
             [](bool is) { flying(!is); },
             [](bool is) { parameters.land_disarm_delay_s = is ? 2 : 0; }},
            [] {
                mutable_vehicle.armed = true;
                return !armedAfterRunning(21);
            },
            all}});
}

TEST_F(Conditions, of_home_being_refined_turn_it_alone) {
    check({{"refines home",
            {[](bool is) { mutable_vehicle.gps.fix = is ? GpsFix::three_d : GpsFix::two_d; }, known,
             [](bool is) { mutable_vehicle.gps.hdop_c = is ? 350 : 351; }},
            [] {
                mutable_vehicle.home.set = false;
                (void)armedAfterRunning(2);
                return vehicle.home.set;
            },
            all}});
}

// ---- failsafes

bool guardOf(uint8_t row) { return kTransitions[row].guard(); }

TEST_F(Conditions, of_the_guards_of_the_failsafes_turn_them_alone) {
    const auto long_returns = [](bool is) { parameters.long_action = is ? 1 : 0; };
    const auto short_acts = [](bool is) { parameters.short_action = is ? 1 : 0; };
    const auto guided = [](bool is) {
        if (is) parameters.fence_action = 1;
    };
    const auto guided_throttle = [](bool is) {
        if (is) parameters.fence_action = 3;
    };
    check({
        {"fence turns back",
         {guided, guided_throttle, known},
         [] { return guardOf(1); },
         [](const Bits& is) { return (is[0] || is[1]) && is[2]; }},
        {"home known", {homeSet, known}, [] { return guardOf(2); }, all},
        {"home if FS_LONG_ACTN returns",
         {long_returns, homeSet, known},
         [] { return guardOf(6); },
         all},
        {"home if FS_SHORT_ACTN acts",
         {short_acts, homeSet, known},
         [] { return guardOf(7); },
         all},
    });
}

void watch(int tenths) {
    for (int i = 0; i < tenths; ++i) watchCauses();
}

TEST_F(Conditions, of_a_low_battery_turn_it_alone) {
    check({{"battery low",
            {armed, [](bool is) { parameters.battery_monitor = is ? 4 : 0; },
             [](bool is) { fakes::setUsb(!is); },
             [](bool is) {
                 parameters.battery_capacity_mah = 2200;
                 parameters.battery_low_mah = is ? 500 : 0;
             },
             [](bool is) { mutable_vehicle.battery.consumed_mah = is ? 1701 : 1700; },
             [](bool is) {
                 parameters.battery_low_v = 10.5f;
                 mutable_vehicle.battery.voltage_mv = is ? 10499 : 10500;
             }},
            [] {
                watch(100);
                fakes::setUsb(false);
                return batteryLow();
            },
            [](const Bits& is) { return is[0] && is[1] && is[2] && ((is[3] && is[4]) || is[5]); }},
           {"battery stays low",
            {armed,
             [](bool is) {
                 parameters.battery_monitor = 4;
                 parameters.battery_low_v = 10.5f;
                 mutable_vehicle.battery.voltage_mv = is ? 10000 : 12000;
                 const bool now = vehicle.armed;
                 mutable_vehicle.armed = true;
                 watch(100);
                 mutable_vehicle.battery.voltage_mv = 12000;
                 mutable_vehicle.armed = now;
             }},
            [] {
                watch(1);
                return batteryLow();
            },
            all}});
}

void failsafes(int tenths) {
    for (int i = 0; i < tenths; ++i) {
        runFailsafe();
        fakes::advance_ms(100);
    }
}

// In a take-off and a landing of AUTO and TAKEOFF an empty battery waits; where a failsafe has
// taken over already it does not.
TEST_F(Conditions, of_a_flight_near_the_ground_turn_it_alone) {
    const auto automatic = [](bool is) {
        mutable_vehicle.armed = mutable_vehicle.estimate.flying = true;
        mutable_vehicle.mode = is ? Mode::automatic : Mode::loiter;
    };
    const auto takes_off = [](bool is) {
        if (is) mutable_vehicle.mode = Mode::takeoff;
    };
    const auto circles_for_the_radio = [](bool is) {
        parameters.short_action = 1;
        mutable_vehicle.demand.path = Path::leg;
        mutable_vehicle.radio.lost = is;
        failsafes(1);
        EXPECT_EQ(vehicle.mode == Mode::circle, is);
    };
    const auto on_the_path = [](Path path) {
        parameters.battery_monitor = 4;
        parameters.battery_low_v = 10.5f;
        mutable_vehicle.battery.voltage_mv = 10000;
        mutable_vehicle.demand.path = path;
    };
    static const auto of = on_the_path;
    check({{"battery acts",
            {automatic, takes_off, circles_for_the_radio,
             [](bool is) { of(is ? Path::takeoff : Path::leg); },
             [](bool is) {
                 if (is) of(Path::land);
             }},
            [] {
                failsafes(105);
                return vehicle.mode == Mode::rtl;
            },
            [](const Bits& is) { return !((is[0] || is[1]) && !is[2] && (is[3] || is[4])); }}});
}

TEST_F(Conditions, of_lost_links_turn_them_alone) {
    check({{"radio lost for long",
            {armed, radioLost, [](bool is) { parameters.long_timeout_s = is ? 5.0f : 5.1f; }},
            [] {
                watch(51);
                return radioLostLong();
            },
            all},
           {"ground station lost",
            {[](bool is) { parameters.ground_failsafe = is; },
             [](bool is) { mutable_vehicle.ground_heard_ms = is ? hal::now_ms() : 0; },
             [](bool is) {
                 parameters.long_timeout_s = 5;
                 fakes::advance_ms(is ? 5000 : 4999);
             }},
            groundLostLong,
            all}});
}

TEST_F(Conditions, of_lost_sensors_turn_them_alone) {
    const auto unhealthy_barometer = [](bool is) { mutable_vehicle.baro.healthy = !is; };
    const auto reckoned = [](bool is) { mutable_vehicle.estimate.reckoned = is; };
    check({{"position lost", {flying, [](bool is) { known(!is); }}, positionLost, all},
           {"height lost", {unhealthy_barometer, reckoned}, heightLost, all},
           {"airspeed lost",
            {[](bool is) { parameters.airspeed_enable = is; },
             [](bool is) { parameters.airspeed_use = is; },
             [](bool is) { mutable_vehicle.airspeed.healthy = !is; }},
            airspeedLost,
            all},
           {"compass lost",
            {compassUsed, [](bool is) { mutable_vehicle.compass.healthy = !is; }},
            compassLost,
            all},
           {"inertial sensor lost while armed",
            {armed, [](bool is) { mutable_vehicle.imu.healthy = !is; }},
            [] {
                watch(3);
                return inertialLost();
            },
            all},
           {"inertial sensor back, the attitude not",
            {[](bool is) {
                 mutable_vehicle.failing =
                     is ? firmware::state::bitOf(Cause::inertial) : uint16_t{0};
             },
             [](bool is) { mutable_vehicle.attitude.aligned = !is; }},
            inertialLost,
            all}});
}

// ---- the evidence of flight after a restart

void barometerAt(bool is) { mutable_vehicle.estimate.baro_height_m = is ? 60 : 0; }

TEST_F(Conditions, of_the_evidence_of_flight_turn_it_alone) {
    check({{"the receiver sees it move",
            {[](bool is) { mutable_vehicle.gps.healthy = is; },
             [](bool is) { mutable_vehicle.gps.fixes = is ? 6 : 5; },
             [](bool is) { mutable_vehicle.gps.ground_speed_mps = is ? 20.0f : 1.0f; },
             [](bool is) { mutable_vehicle.estimate.fix_refused = !is; },
             [](bool is) { mutable_vehicle.estimate.reckoned = !is; }},
            receiverSeesItMove,
            all},
           {"the barometer sees it in the air",
            {[](bool is) { mutable_vehicle.baro.healthy = is; }, barometerAt},
            [] { return measuredInTheAir(0); },
            all}});
}

// ---- modes

firmware::modes::ModeSituation now;
const std::vector<Set> kSituation = {[](bool is) { now.resuming = is; },
                                     [](bool is) { now.no_attitude = is; },
                                     [](bool is) { now.no_sticks = is; }};

TEST_F(Conditions, of_a_mode_request_turn_it_alone) {
    using firmware::modes::mayEnter;
    using firmware::state::ModeReason;
    check({{"the pilot's FBWA", kSituation,
            [] { return mayEnter(Mode::fbwa, ModeReason::pilot, now); },
            [](const Bits& is) { return !any(is); }}});
    // what is granted in one of the situations is not turned by it
    for (const Decision& decision :
         std::vector<Decision>{{"the ground station's MANUAL", kSituation,
                                [] { return mayEnter(Mode::manual, ModeReason::ground, now); },
                                [](const Bits& is) { return !is[0] && !is[2]; }},
                               {"RTL of the mission", kSituation,
                                [] { return mayEnter(Mode::rtl, ModeReason::mission, now); },
                                [](const Bits& is) { return !is[0] && !is[1]; }},
                               {"RTL of a failsafe", kSituation,
                                [] { return mayEnter(Mode::rtl, ModeReason::failsafe, now); },
                                [](const Bits& is) { return !is[0]; }}})
        (void)table(decision);
}

}  // namespace
