// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/safety/arming.hpp"

#include "board.hpp"
#include "core/file_state.hpp"
#include "core/internal_error.hpp"
#include "core/maths.hpp"
#include "firmware/estimator/estimator.hpp"
#include "firmware/mission/home.hpp"
#include "firmware/mission/mission.hpp"
#include "firmware/modes/modes.hpp"
#include "firmware/notify/status_text.hpp"
#include "firmware/safety/fence.hpp"
#include "firmware/sensors/compass_learning.hpp"
#include "firmware/sensors/compass_mounting.hpp"
#include "firmware/sensors/sensors.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware/state/published.hpp"
#include "hal/clock.hpp"

namespace firmware {

namespace state {
template <>
struct Publisher<ArmingState> : Writable<ArmingState> {
    using Writable::state;
};
}  // namespace state

namespace safety {

using namespace notify;
using namespace state;
using namespace sensors;
using namespace mission;

namespace {

constexpr ArmingState& published = Publisher<ArmingState>::state();

// ARMING_CHECK: bit 0 asks for all of them; what is kAlways nothing leaves out.
enum CheckBit : uint16_t {
    kAll = 1,
    kBarometer = 2,
    kCompass = 4,
    kGps = 8,
    kInertial = 16,
    kParameters = 32,
    kRadio = 64,
    kBoardVoltage = 128,
    kBattery = 256,
    kAirspeed = 512,
    kLogging = 1024,
    kMission = 16384,
    kAlways = 0xFFFF,
};

bool boardBad() { return wrongBoard(); }
bool terminated() { return vehicle.terminated; }
uint8_t boardModel() { return board::kModel; }
uint8_t internalError() { return static_cast<uint8_t>(core::internalErrors().last); }
bool hadInternalError() { return internalError() != 0; }
bool calibrationRuns() { return vehicle.calibrating > Calibrating::rest; }
bool inertialBad() { return !vehicle.imu.healthy; }
bool gyrosUnknown() { return !vehicle.imu.calibrated; }

// At rest it measures gravity and nothing else: 0.8 to 1.2 g, held or rocked by the wind too.
bool accelerometersBad() {
    const auto square = [](core::Acceleration axis) {
        const int16_t tenths = axis.raw / 26;  // 0.1 m/s2
        return core::product(tenths, tenths);
    };
    const auto& force = vehicle.imu.accel_mss;
    const int32_t length = square(force.x) + square(force.y) + square(force.z);
    return length < 78L * 78 || length > 118L * 118;
}
bool attitudeBad() { return !vehicle.attitude.aligned; }
bool barometerBad() { return !vehicle.baro.healthy || !estimator::barometerSteady(); }

bool compassBad() { return parameters.compass_use != 0 && !vehicle.compass.healthy; }
// The earth's field is 230 to 670 milligauss; what is far from that is a magnet or a motor's wire.
bool fieldBad() {
    constexpr float kLeast_mg = 185, kMax_mg = 875;
    const float square = core::dot(vehicle.compass.field_mg, vehicle.compass.field_mg);
    return parameters.compass_use != 0 &&
           (square < kLeast_mg * kLeast_mg || square > kMax_mg * kMax_mg);
}

// More than that has not come from the airplane itself.
bool offsetsBad() {
    constexpr float kMax_mg = 500;
    const float* const mg = parameters.compass.offset_mg;
    const core::Vector3 offset = {mg[0], mg[1], mg[2]};
    return parameters.compass_use != 0 && core::dot(offset, offset) > kMax_mg * kMax_mg;
}

// Mounted so it would show east for west: COMPASS_ORIENT says how an external one is mounted. At
// rest the accelerometers measure the way up.
bool compassUpsideDown() {
    constexpr int32_t kClearly_mg = 80;
    const auto& field_mg = vehicle.compass.field_mg;
    const auto& force = vehicle.imu.accel_mss;
    const int32_t up = core::product(core::toFixed(field_mg.x, 0), force.x.raw) +
                       core::product(core::toFixed(field_mg.y, 0), force.y.raw) +
                       core::product(core::toFixed(field_mg.z, 0), force.z.raw);
    constexpr int32_t kGravity = static_cast<int32_t>(core::kGravity_mss * 256);
    return parameters.compass_use != 0 && vehicle.compass.points_down * up > kClearly_mg * kGravity;
}

bool gpsBad() { return vehicle.gps.fix != GpsFix::three_d || !vehicle.estimate.known; }
bool dilutionBad() { return vehicle.gps.hdop_c > 350; }

bool radioBad() { return vehicle.radio.lost || !vehicle.radio.heard; }
bool throttleUp() { return !radioBad() && vehicle.radio.throttle_pct > 3; }
bool uncalibrated(const Channel& range) {
    return range.min_us > 1300 || range.max_us < 1700 || range.trim_us < range.min_us ||
           range.trim_us > range.max_us;
}
// Of the four that fly: a way of less than 200 us to either side has not been set, it is a mistake.
// 0: there is none.
uint8_t uncalibratedChannel() {
    const int8_t flown[] = {parameters.map_roll, parameters.map_pitch, parameters.map_throttle,
                            parameters.map_yaw};
    for (const int8_t channel : flown)
        if (uncalibrated(parameters.channel[channel - 1])) return static_cast<uint8_t>(channel);
    return 0;
}
bool radioUncalibrated() { return uncalibratedChannel() != 0; }

// Two RCMAP_ name it: one stick would do what two are for, and a receiver's failsafe pulse on the
// throttle's channel would not be seen. 0: there is none.
uint8_t sharedChannel() {
    uint16_t seen = 0;
    for (uint8_t stick = 0; stick < 4; ++stick) {
        const int8_t channel = (&parameters.map_roll)[stick];
        const uint16_t bit = static_cast<uint16_t>(1 << channel);
        if ((seen & bit) != 0) return static_cast<uint8_t>(channel);
        seen |= bit;
    }
    return 0;
}
bool channelShared() { return sharedChannel() != 0; }

bool airspeedBad() {
    return parameters.airspeed_enable != 0 && parameters.airspeed_use != 0 &&
           !vehicle.airspeed.healthy;
}
// the MPXV7002 and the servos want their 5 V: 4.3 .. 5.8 V
bool boardVoltageBad() {
    return vehicle.battery.board_mv < 4300 || vehicle.battery.board_mv > 5800;
}
// A pack that is there (over 6 V) and below what would bring it home at once.
bool batteryBad() {
    return parameters.battery_monitor != 0 && vehicle.battery.voltage_mv > 6000 &&
           vehicle.battery.voltage_mv < parameters.battery_low_v * 1000;
}
bool missionBad() { return !missionKnown(); }
bool loggingBad() { return parameters.log_bitmask != 0 && !vehicle.log_usable; }

struct Check {
    uint16_t bit;
    bool (*fails)();
    TextField<19> reason;
    uint8_t (*number)();  // that takes the place of '#'; nullptr: there is none
};

// The first that fails is reported.
// clang-format off
constexpr Check kChecks[] ROM = {
    {kAlways,       boardBad,          "Wrong board: for an APM #", boardModel},
    {kAlways,       terminated,        "PreArm: flight terminated", nullptr},
    {kAlways,       hadInternalError,  "PreArm: internal error #", internalError},
    {kAlways,       calibrationRuns,   "PreArm: calibrating", nullptr},
    {kInertial,     inertialBad,       "PreArm: gyros not healthy", nullptr},
    {kInertial,     gyrosUnknown,      "PreArm: gyros not ready", nullptr},
    {kInertial,     accelerometersBad, "PreArm: accelerometers", nullptr},
    {kInertial,     attitudeBad,       "PreArm: attitude", nullptr},
    {kBarometer,    barometerBad,      "PreArm: barometer", nullptr},
    {kCompass,      compassBad,        "PreArm: compass", nullptr},
    {kCompass,      fieldBad,          "PreArm: check mag field", nullptr},
    {kCompass,      offsetsBad,        "PreArm: compass offsets", nullptr},
    {kCompass,      compassUpsideDown, "PreArm: compass upside down", nullptr},
    {kCompass,      compassTurned,     "PreArm: set COMPASS_ORIENT #", compassOrientation},
    {kGps,          gpsBad,            "PreArm: no GPS fix", nullptr},
    {kGps,          dilutionBad,       "PreArm: high GPS HDOP", nullptr},
    {kAirspeed,     airspeedBad,       "PreArm: airspeed sensor", nullptr},
    {kRadio,        radioBad,          "PreArm: no radio", nullptr},
    {kRadio,        radioUncalibrated, "PreArm: RC# not calibrated", uncalibratedChannel},
    {kRadio,        channelShared,     "PreArm: RCMAP: RC# twice", sharedChannel},
    {kRadio,        throttleUp,        "PreArm: throttle is up", nullptr},
    {kBoardVoltage, boardVoltageBad,   "PreArm: board voltage", nullptr},
    {kBattery,      batteryBad,        "PreArm: battery low", nullptr},
    {kMission,      missionBad,        "PreArm: mission unreadable", nullptr},
    {kParameters,   parametersForeign, "PreArm: EEPROM is not ours", nullptr},
    {kParameters,   parametersDamaged, "PreArm: parameters damaged", nullptr},
    {kParameters,   fenceBad,          "PreArm: fence not fit", nullptr},
    {kLogging,      loggingBad,        "PreArm: no log chip", nullptr},
};
// clang-format on

constexpr uint8_t kRudderArms = 30;  // 0.1 s
constexpr int16_t kFullRudder_cd = 4000;
constexpr uint16_t kRemind_ms = 30000, kRemindSoon_ms = 5000;
constexpr uint32_t kNotBefore_ms = 10000;  // the sensors need a while

struct Arming {
    uint8_t rudder_held;  // for so long, 0.1 s
    uint8_t next_check;
    uint16_t landed;  // for so long, 0.1 s
};
core::FileState<Arming> arming{};

// Apart from the zeros, which need no copy in flash.
struct Reminder {
    uint32_t sent_ms = kNotBefore_ms - kRemind_ms;
};
core::FileState<Reminder> reminder{};

void fixHome() {
    constexpr float kWorthReporting_m = 5;
    const HomeState before = vehicle.home;
    if (!setHomeOfFlight())
        return sendStatusText(Severity::warning, before.set ? STATUS_TEXT("Armed, home as before")
                                                            : STATUS_TEXT("Armed without a home"));
    const float moved_m = geo::distance_m(before.position, vehicle.home.position);
    if (before.set && moved_m > kWorthReporting_m)
        sendStatusText(Severity::notice, STATUS_TEXT("Home moved by # m"), core::rounded(moved_m));
}

void armNow() {
    published.armed = true;
    fixHome();
    sendStatusText(Severity::notice, STATUS_TEXT("Throttle armed"));
}

// Full rudder for three seconds with the throttle closed, in a mode where the pilot has it: to the
// right arms, to the left, on the ground, disarms. ARMING_RUDDER: 0 neither, 1 arms only, 2 both.
void runRudderArming() {
    const auto& radio = vehicle.radio;
    const int16_t rudder_cd = vehicle.armed ? -radio.yaw_cd : radio.yaw_cd;
    const bool asks = parameters.arming_rudder > vehicle.armed && !radio.lost && !autoThrottle() &&
                      !vehicle.estimate.flying && radio.throttle_pct == 0 &&
                      rudder_cd > kFullRudder_cd;
    if (!asks) {
        arming.rudder_held = 0;
    } else if (++arming.rudder_held > kRudderArms) {
        arming.rudder_held = 0;
        if (vehicle.armed) {
            disarm(ArmReason::pilot, false);
        } else {
            arm(ArmReason::pilot, false);
        }
    }
}

bool fails(const Check& check) {
    const uint16_t bit = core::romRead(check.bit);
    if (bit != kAlways && (parameters.arming_check & (bit | kAll)) == 0) return false;
    return core::romRead(check.fails)();
}

void report(Severity severity, const Check& check) {
    const auto number = core::romRead(check.number);
    sendStatusText(severity, check.reason, number != nullptr ? number() : 0);
}

void remind(const Check& check) {
    const uint32_t now_ms = hal::now_ms();
    const uint16_t pause_ms = wrongBoard() ? kRemindSoon_ms : kRemind_ms;
    if (now_ms - reminder.sent_ms < pause_ms) return;
    reminder.sent_ms = now_ms;
    report(Severity::warning, check);
}

// A few at a time, so that they are through in a second; at one that fails it stays.
void runNextChecks() {
    constexpr uint8_t kAtOnce = 3;
    for (uint8_t i = 0; i < kAtOnce; ++i) {
        const Check& check = kChecks[arming.next_check];
        if (fails(check)) {
            published.prearm_ok = false;
            return remind(check);
        }
        if (++arming.next_check < core::count(kChecks)) continue;
        arming.next_check = 0;
        published.prearm_ok = true;
    }
}

// After a landing of AUTO: the motor is off and the airplane lies still for LAND_DISARMDELAY;
// 0: it stays armed.
void runLanded() {
    const bool down = vehicle.demand.path == Path::land && vehicle.progress.flaring &&
                      vehicle.mode == Mode::automatic && !vehicle.estimate.flying;
    arming.landed = down ? arming.landed + 1 : 0;
    const uint8_t delay_s = static_cast<uint8_t>(parameters.land_disarm_delay_s);
    if (delay_s != 0 && arming.landed > delay_s * 10) disarm(ArmReason::landed, false);
}

}  // namespace

bool reportPrearmFailure(Severity severity) {
    for (const Check& check : kChecks) {
        if (!fails(check)) continue;
        report(severity, check);
        return true;
    }
    return false;
}

// Nothing makes up for a board whose pins are others, or for a flight that was ended for good.
bool arm(ArmReason, bool force) {
    if (vehicle.armed) return true;
    if ((!force || wrongBoard() || vehicle.terminated) && reportPrearmFailure(Severity::error))
        return false;
    armNow();
    return true;
}

void armAfterRestart() { published.armed = true; }

bool disarm(ArmReason reason, bool force) {
    if (!vehicle.armed) return true;
    if (vehicle.estimate.flying && reason != ArmReason::landed && !force) {
        sendStatusText(Severity::error, STATUS_TEXT("Disarm refused: flying"));
        return false;
    }
    published.armed = false;
    saveLearntCompass();
    saveAirspeedRatio();
    sendStatusText(Severity::notice, STATUS_TEXT("Throttle disarmed"));
    return true;
}

void disarmForGood() {
    published.terminated = true;
    (void)disarm(ArmReason::ground, true);
}

void runArming() {
    runRudderArming();
    if (vehicle.armed) {
        runLanded();
    } else {
        runNextChecks();
        if (!gpsBad() && !dilutionBad()) refineHome();
    }
}

}  // namespace safety
}  // namespace firmware
