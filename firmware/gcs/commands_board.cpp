// SPDX-License-Identifier: GPL-3.0-or-later
// Commands for the board on the ground: calibration, storage, restart.
#include <string.h>

#include "core/file_state.hpp"
#include "core/maths.hpp"
#include "core/rom.hpp"
#include "firmware/gcs/calibration.hpp"
#include "firmware/gcs/commands.hpp"
#include "firmware/gcs/commands_orders.hpp"
#include "firmware/gcs/link.hpp"
#include "firmware/gcs/parameter_guard.hpp"
#include "firmware/notify/status_text.hpp"
#include "firmware/sensors/accelerometer_fit.hpp"
#include "firmware/sensors/sensors.hpp"
#include "firmware/state/parameter_slots.hpp"
#include "firmware/state/vehicle.hpp"
#include "hal/eeprom.hpp"
#include "hal/watchdog.hpp"

namespace firmware {
namespace gcs {

using namespace notify;
using namespace state;
using namespace sensors;

namespace {

using mavlink::MavResult;

constexpr uint8_t kRebootTurns = 15;  // 0.3 s for the answer to get out
struct Restart {
    uint8_t turns_left;  // until it begins; 0: none is asked for
};
core::FileState<Restart> restart{};

// The sticks' present places become their centres.
uint8_t trimRadio() {
    if (vehicle.radio.lost || vehicle.radio.good_ms == 0) return MavResult::failed;
    const int8_t channels[] = {parameters.map_roll, parameters.map_pitch, parameters.map_yaw};
    bool set = true;
    for (const int8_t channel : channels)
        set = parameterSet(slot::ofChannel(static_cast<uint8_t>(channel), slot::trim),
                           vehicle.radio.pulse_us[channel - 1]) &&
              set;
    return set ? MavResult::accepted : MavResult::failed;
}

// The board's present lie becomes the airplane's level; small angles add up.
uint8_t trimLevel() {
    constexpr int16_t kStill = core::BodyRate(core::radians(4)).raw;
    const auto& rate = vehicle.attitude.rate_rads;
    const bool still =
        rate.x.raw < kStill && rate.x.raw > -kStill && rate.y.raw < kStill && rate.y.raw > -kStill;
    if (!still) sendStatusText(Severity::error, ROM_TEXT("Level: keep it still"));
    if (!still || !vehicle.attitude.aligned) return MavResult::failed;
    const float lie_rad[] = {parameters.level_trim_rad[0] + vehicle.attitude.roll_rad.toFloat(),
                             parameters.level_trim_rad[1] + vehicle.attitude.pitch_rad.toFloat()};
    return whenTrue(parametersSetFrom(slot::ahrs_trim_x, lie_rad, 2), MavResult::failed);
}

// Bits of what a command asks for.
enum Wish : uint8_t {
    kGyros = 1,
    kCompass = 2,
    kPressures = 4,
    kRadio = 8,
    kLevel = 16,
    kSixSides = 32,
    kOneSide = 64,
};
struct WishRow {
    uint8_t param, value;  // param 1: 0
    uint8_t wish;
};
// clang-format off
constexpr WishRow kWishes[] ROM = {
    {0, 1, kGyros},
    {1, 1, kCompass},
    {2, 1, kPressures},
    {3, 1, kRadio},
    {3, 2, kRadio},
    {4, 1, kSixSides},
    {4, 2, kLevel},
    {4, 4, kOneSide},
    {5, 2, kPressures},
};
// clang-format on
constexpr uint8_t kParams = 7;

uint8_t wishOf(uint8_t param, float value) {
    for (const WishRow& in_flash : kWishes) {
        const WishRow row = core::romRead(in_flash);
        if (row.param == param && number(value) == row.value) return row.wish;
    }
    return 0;
}

// False: there is something in it that cannot be had here.
bool wishesOf(const Order& order, uint8_t& wishes) {
    float param[kParams];
    memcpy(param, &order.item.param1, 4 * sizeof(float));
    param[4] = order.param5;
    param[5] = order.param6;
    param[6] = order.item.z;
    wishes = 0;
    for (uint8_t i = 0; i < kParams; ++i) {
        if (!isGiven(param[i])) continue;
        const uint8_t wish = wishOf(i, param[i]);
        if (wish == 0) return false;
        wishes |= wish;
    }
    // "ground start" of some ground stations: the compass needs more than standing still
    if ((wishes & kGyros) != 0) wishes &= static_cast<uint8_t>(~kCompass);
    return true;
}

// Accepted: it stands on the ground, disarmed.
uint8_t mayCalibrate() {
    if (!vehicle.armed && !vehicle.estimate.flying) return MavResult::accepted;
    sendStatusText(Severity::error, ROM_TEXT("Calibration refused: disarm first"));
    if (vehicle.estimate.flying) return MavResult::denied;
    return MavResult::temporarily_rejected;
}

uint8_t begin(Calibrating what, Link& link, const Order& order, uint8_t answer) {
    if (calibrationBegin(what, {linkNumber(link), order.system, order.component})) return answer;
    sendStatusText(Severity::error, ROM_TEXT("Calibration refused: another runs"));
    return MavResult::temporarily_rejected;
}

uint8_t beginRest(Link& link, const Order& order, uint8_t wishes) {
    const bool again = vehicle.calibrating == Calibrating::rest;
    const uint8_t result = begin(Calibrating::rest, link, order, MavResult::in_progress);
    if (again || result != MavResult::in_progress) return result;
    if ((wishes & kGyros) != 0) calibrateGyros();
    if ((wishes & kPressures) != 0) calibratePressures();
    return result;
}

uint8_t beginCompass(Link& link, const Order& order) {
    if (!vehicle.compass.healthy) {
        sendStatusText(Severity::error, ROM_TEXT("Calibration refused: no compass"));
        return MavResult::failed;
    }
    return begin(Calibrating::compass, link, order, MavResult::accepted);
}

void rebootTick() {
    if (restart.turns_left == 0) return;
    if (restart.turns_left > 1) {
        --restart.turns_left;
    } else if (hal::eepromDrained()) {
        hal::reboot();
    }
}

}  // namespace

uint8_t calibrate(Link& link, Order& order) {
    uint8_t wishes;
    if (!wishesOf(order, wishes)) return MavResult::unsupported;
    if (wishes == 0) {
        if (vehicle.calibrating == Calibrating::nothing) return MavResult::unsupported;
        return cancelCalibration(link, order);
    }
    uint8_t result = mayCalibrate();
    if (result != MavResult::accepted) return result;
    if (wishes == kSixSides) return begin(Calibrating::sides, link, order, MavResult::accepted);
    if (wishes == kOneSide) return begin(Calibrating::level, link, order, MavResult::in_progress);
    if (wishes == kCompass) return beginCompass(link, order);
    if ((wishes & (kSixSides | kOneSide | kCompass)) != 0) return MavResult::unsupported;
    if ((wishes & kRadio) != 0) result = trimRadio();
    if ((wishes & kLevel) != 0) result = trimLevel();
    if (result != MavResult::accepted || (wishes & (kGyros | kPressures)) == 0) return result;
    return beginRest(link, order, wishes);
}

uint8_t calibrateCompass(Link& link, Order& order) {
    const uint8_t result = mayCalibrate();
    return result == MavResult::accepted ? beginCompass(link, order) : result;
}

// What fits is kept without being asked.
uint8_t acceptCompass(Link&, Order&) { return MavResult::accepted; }

uint8_t cancelCalibration(Link&, Order&) {
    calibrationCancel();
    return MavResult::accepted;
}

uint8_t sideIsReady(Link&, Order& order) {
    return whenTrue(calibrationSideIsReady(number(order.item.param1)), MavResult::denied);
}

// A key that was pressed on the ground reaches the airplane as the answer to a command that never
// was: of number 0, 1 or how many keys have been.
bool onCommandAck(Link&, const mavlink::Frame& frame) {
    if (frame.read<mavlink::CommandAck>().command <= kSides) calibrationSideIsReady();
    return true;
}

uint8_t setSensorOffsets(Link&, Order& order) {
    constexpr uint8_t kCompass = 2;
    if (order.item.param1 != kCompass) return MavResult::unsupported;
    const float offsets_mg[] = {order.item.param2, order.item.param3, order.item.param4};
    return whenTrue(parametersSetFrom(slot::compass_ofs_x, offsets_mg, 3), MavResult::failed);
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
uint8_t reboot(Link& link, Order& order) {
    constexpr uint8_t kRestart = 1, kToBootloader = 3;
    constexpr float kWhateverHappens = 20190226;
    const uint16_t action = number(order.item.param1);
    if (action == 0) return MavResult::accepted;
    if (action != kRestart && action != kToBootloader) return MavResult::denied;
    if (vehicle.armed) {
        if (order.param6 != kWhateverHappens) return MavResult::temporarily_rejected;
        if (!mayForce(link)) return MavResult::denied;
    }
    restart.turns_left = kRebootTurns;
    return MavResult::accepted;
}

void commandsStart() {
    restart.turns_left = 0;
    calibrationReset();
}

void commandsTick() {
    calibrationTick();
    rebootTick();
    parameterGuardTick();
}

}  // namespace gcs
}  // namespace firmware
