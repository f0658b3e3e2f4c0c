// SPDX-License-Identifier: GPL-3.0-or-later
// Commands for the board on the ground: calibration, storage, restart.
#include <string.h>

#include "core/rom.hpp"
#include "firmware/sensors/sensors.hpp"
#include "firmware/telemetry/commands.hpp"
#include "firmware/telemetry/commands_orders.hpp"
#include "firmware/telemetry/link.hpp"
#include "firmware/telemetry/text.hpp"
#include "firmware/vehicle.hpp"
#include "hal/clock.hpp"
#include "hal/eeprom.hpp"
#include "hal/watchdog.hpp"

namespace firmware {
namespace {

using mavlink::MavResult;

constexpr uint8_t kRebootTurns = 15;  // 0.3 s for the answer to get out
uint8_t turns_to_reboot;

// One that takes its time, and who is told how it went.
constexpr uint8_t kCalibration_s = 30;
struct {
    uint8_t left_s;  // 0: none runs
    uint8_t second;  // of the clock
    uint8_t link, system, component;
} calibration;

// Parameters are named by their slots, as stored missions name them.
constexpr uint8_t kCompassOffsets = 158, kLevelTrim = 168;
uint8_t trimSlot(int8_t channel) { return static_cast<uint8_t>(26 + 5 * channel); }

uint8_t setAll(uint8_t slot, const float* values, uint8_t count) {
    for (uint8_t i = 0; i < count; ++i)
        if (!parameterSlotTakes(static_cast<uint8_t>(slot + i), values[i]))
            return MavResult::failed;
    for (uint8_t i = 0; i < count; ++i) parameterSet(static_cast<uint8_t>(slot + i), values[i]);
    return MavResult::accepted;
}

// The sticks' present places become their centres.
uint8_t trimRadio() {
    if (vehicle.radio.lost || vehicle.radio.good_ms == 0) return MavResult::failed;
    const int8_t channels[] = {parameters.map_roll, parameters.map_pitch, parameters.map_yaw};
    for (const int8_t channel : channels)
        parameterSet(trimSlot(channel), vehicle.radio.pulse_us[channel - 1]);
    return MavResult::accepted;
}

// The board's present lie becomes the airplane's level; small angles add up.
uint8_t trimLevel() {
    if (!vehicle.attitude.aligned) return MavResult::failed;
    const float lie_rad[] = {parameters.level_trim_rad[0] + vehicle.attitude.roll_rad,
                             parameters.level_trim_rad[1] + vehicle.attitude.pitch_rad};
    return setAll(kLevelTrim, lie_rad, 2);
}

enum Wish : uint8_t { kGyros = 1, kPressures = 4, kRadio = 8, kLevel = 16 };

// A bit a parameter; false: there is something in it that cannot be had here.
bool wishesOf(const Order& order, uint8_t& wishes) {
    static constexpr uint8_t kValues[] ROM = {1, 0, 1, 1, 2, 0, 0};
    float param[7];
    memcpy(param, &order.item.param1, 4 * sizeof(float));
    param[4] = order.param5;
    param[5] = order.param6;
    param[6] = order.item.z;
    wishes = 0;
    for (uint8_t i = 0; i < core::count(kValues); ++i) {
        if (!isGiven(param[i])) continue;
        if (number(param[i]) != core::romRead(kValues[i])) return false;
        wishes = static_cast<uint8_t>(wishes | 1u << i);
    }
    return wishes != 0;
}

bool calibrated() { return vehicle.imu.calibrated && vehicle.baro.ground_pressure_pa > 0; }

void calibrationTurn() {
    if (calibration.left_s == 0) return;
    const bool done = calibrated();
    const uint8_t second = static_cast<uint8_t>(hal::now_ms() / 1024);
    if (!done && second == calibration.second && calibration.left_s > 1) return;
    if (second != calibration.second && calibration.left_s > 1) --calibration.left_s;
    calibration.second = second;
    Order order;
    order.command = mavlink::MavCmd::preflight_calibration;
    order.system = calibration.system;
    order.component = calibration.component;
    const uint8_t unfinished = calibration.left_s > 1 ? MavResult::in_progress : MavResult::failed;
    const uint8_t result = whenTrue(done, unfinished);
    if (acknowledge(links[calibration.link], order, result) && result != MavResult::in_progress)
        calibration.left_s = 0;
}

void rebootTurn() {
    if (turns_to_reboot == 0) return;
    if (turns_to_reboot > 1) {
        --turns_to_reboot;
    } else if (hal::eepromDrained()) {
        hal::reboot();
    }
}

}  // namespace

uint8_t calibrate(Link& link, Order& order) {
    uint8_t wishes;
    if (!wishesOf(order, wishes)) return MavResult::unsupported;
    if (vehicle.estimate.flying) return MavResult::denied;
    if (vehicle.armed) return MavResult::temporarily_rejected;
    uint8_t result = MavResult::accepted;
    if ((wishes & kRadio) != 0) result = trimRadio();
    if ((wishes & kLevel) != 0) result = trimLevel();
    if (result != MavResult::accepted || (wishes & (kGyros | kPressures)) == 0) return result;
    calibration.link = linkNumber(link);
    calibration.system = order.system;
    calibration.component = order.component;
    if (calibration.left_s != 0) return MavResult::in_progress;  // asked again
    calibration.left_s = kCalibration_s;
    if ((wishes & kGyros) != 0) calibrateGyros();
    if ((wishes & kPressures) != 0) calibratePressures();
    return MavResult::in_progress;
}

uint8_t setSensorOffsets(Link&, Order& order) {
    constexpr uint8_t kCompass = 2;
    if (order.item.param1 != kCompass) return MavResult::unsupported;
    const float offsets_mg[] = {order.item.param2, order.item.param3, order.item.param4};
    return setAll(kCompassOffsets, offsets_mg, 3);
}

// Values are stored as they are set: reading and writing "all" has nothing to do. Parameters may be
// reset alone, missions only with them: then everything is erased.
uint8_t resetStorage(Link&, Order& order) {
    constexpr uint8_t kReset = 2;
    const uint16_t action = number(order.item.param1);
    const bool missions = order.item.param2 == kReset;
    if (action != kReset) return whenTrue(action < kReset && !missions, MavResult::unsupported);
    return whenTrue(missions ? parametersErase() : parametersReset(),
                    MavResult::temporarily_rejected);
}

// After any reset the bootloader waits for a while for somebody to talk to it: all that 3 wants.
uint8_t reboot(Link&, Order& order) {
    constexpr uint8_t kRestart = 1, kToBootloader = 3;
    constexpr float kWhateverHappens = 20190226;
    const uint16_t action = number(order.item.param1);
    if (action == 0) return MavResult::accepted;
    if (action != kRestart && action != kToBootloader) return MavResult::denied;
    if (vehicle.armed && order.param6 != kWhateverHappens) return MavResult::temporarily_rejected;
    turns_to_reboot = kRebootTurns;
    return MavResult::accepted;
}

void commandsStart() { turns_to_reboot = calibration.left_s = 0; }

void commandsTurn() {
    calibrationTurn();
    rebootTurn();
}

}  // namespace firmware
