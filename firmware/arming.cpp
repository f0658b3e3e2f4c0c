// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/arming.hpp"

#include "firmware/fence.hpp"
#include "firmware/home.hpp"
#include "firmware/mission/mission.hpp"
#include "firmware/modes.hpp"
#include "firmware/parameters.hpp"
#include "firmware/sensors/sensors.hpp"
#include "firmware/telemetry/text.hpp"
#include "firmware/vehicle.hpp"
#include "hal/clock.hpp"

namespace firmware {
namespace {

// ARMING_CHECK: bit 0 asks for all of them
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
};

bool inertialBad() { return !vehicle.imu.healthy || !vehicle.imu.calibrated; }
bool attitudeBad() { return !vehicle.attitude.aligned; }
bool barometerBad() { return !vehicle.baro.healthy; }
bool compassBad() { return parameters.compass_use != 0 && !vehicle.compass.healthy; }
bool gpsBad() { return vehicle.gps.fix != GpsFix::three_d || !vehicle.estimate.known; }
bool radioBad() { return vehicle.radio.lost || vehicle.radio.good_ms == 0; }
bool throttleUp() { return !radioBad() && vehicle.radio.throttle_pct > 3; }
bool airspeedBad() {
    return parameters.airspeed_enable != 0 && parameters.airspeed_use != 0 &&
           !vehicle.airspeed.healthy;
}
// the MPXV7002 and the servos want their 5 V: 4.3 .. 5.8 V
bool boardVoltageBad() {
    return vehicle.battery.board_mv < 4300 || vehicle.battery.board_mv > 5800;
}
// a pack that is there (over 6 V) and below 3.3 V a cell of three
bool batteryBad() {
    return parameters.battery_monitor != 0 && vehicle.battery.voltage_mv > 6000 &&
           vehicle.battery.voltage_mv < 9900;
}

struct Check {
    uint16_t bit;
    bool (*fails)();
    char reason[25];
};

// clang-format off
constexpr Check kChecks[] ROM = {
    {kInertial,     inertialBad,     "PreArm: gyros not ready"},
    {kInertial,     attitudeBad,     "PreArm: attitude"},
    {kBarometer,    barometerBad,    "PreArm: barometer"},
    {kCompass,      compassBad,      "PreArm: compass"},
    {kGps,          gpsBad,          "PreArm: no GPS fix"},
    {kAirspeed,     airspeedBad,     "PreArm: airspeed sensor"},
    {kRadio,        radioBad,        "PreArm: no radio"},
    {kRadio,        throttleUp,      "PreArm: throttle is up"},
    {kBoardVoltage, boardVoltageBad, "PreArm: board voltage"},
    {kBattery,      batteryBad,      "PreArm: battery low"},
    {kParameters,   fenceBad,        "PreArm: fence not fit"},
};
// clang-format on

constexpr uint32_t kRudderArms_ms = 3000;
constexpr int16_t kFullRudder_cd = 4000;
constexpr uint32_t kRemind_ms = 30000;

uint32_t rudder_since_ms;
uint32_t reminded_ms;
uint32_t landed_ms;

void armNow() {
    vehicle.armed = true;
    if (!setHomeHere()) tell(Severity::warning, ROM_TEXT("Armed without a home"));
    tell(Severity::notice, ROM_TEXT("Throttle armed"));
}

// Right rudder for three seconds with the throttle closed, in a mode where the pilot has it.
void runRudderArming() {
    const bool asks = !vehicle.armed && !vehicle.radio.lost && !autoThrottle() &&
                      vehicle.radio.throttle_pct == 0 && vehicle.radio.yaw_cd > kFullRudder_cd;
    const uint32_t now_ms = hal::now_ms();
    if (!asks) {
        rudder_since_ms = now_ms;
    } else if (now_ms - rudder_since_ms >= kRudderArms_ms) {
        rudder_since_ms = now_ms;
        arm(ArmReason::pilot, false);
    }
}

void remind() {
    const core::RomText why = prearmFailure();
    const uint32_t now_ms = hal::now_ms();
    if (why == nullptr || now_ms - reminded_ms < kRemind_ms) return;
    reminded_ms = now_ms;
    tell(Severity::warning, why);
}

// After a landing of AUTO: the motor is off and the airplane lies still for LAND_DISARMDELAY;
// 0: it stays armed.
void runLanded() {
    const bool down = vehicle.demand.path == Path::land && vehicle.progress.flaring &&
                      vehicle.mode == Mode::automatic && !vehicle.estimate.flying;
    const uint32_t now_ms = hal::now_ms();
    if (!down) landed_ms = now_ms;
    const uint8_t delay_s = static_cast<uint8_t>(parameters.land_disarm_delay_s);
    if (delay_s != 0 && now_ms - landed_ms > delay_s * 1000UL) disarm(ArmReason::landed, false);
}

}  // namespace

core::RomText prearmFailure() {
    for (const Check& check : kChecks) {
        const uint16_t bit = core::romRead(check.bit);
        if ((parameters.arming_check & (bit | kAll)) == 0) continue;
        if (core::romRead(check.fails)()) return check.reason;
    }
    return nullptr;
}

bool prearmOk() { return prearmFailure() == nullptr; }

bool arm(ArmReason, bool force) {
    if (vehicle.armed) return true;
    const core::RomText why = prearmFailure();
    if (why != nullptr && !force) {
        tell(Severity::error, why);
        return false;
    }
    armNow();
    return true;
}

bool disarm(ArmReason reason, bool force) {
    if (!vehicle.armed) return true;
    if (vehicle.estimate.flying && reason != ArmReason::landed && !force) {
        tell(Severity::error, ROM_TEXT("Disarm refused: flying"));
        return false;
    }
    vehicle.armed = false;
    tell(Severity::notice, ROM_TEXT("Throttle disarmed"));
    return true;
}

void runArming() {
    if (vehicle.armed) {
        runLanded();
        return;
    }
    runRudderArming();
    remind();
}

}  // namespace firmware
