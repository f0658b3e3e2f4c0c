// SPDX-License-Identifier: GPL-3.0-or-later
// Commands for the board on the ground: calibration, storage, restart.
#include <string.h>

#include "core/file_state.hpp"
#include "core/maths.hpp"
#include "core/rom.hpp"
#include "firmware/gcs/calibration.hpp"
#include "firmware/gcs/command_handlers.hpp"
#include "firmware/gcs/commands.hpp"
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
    if (vehicle.radio.lost || !vehicle.radio.heard) return MavResult::failed;
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
    if (!still) sendStatusText(Severity::error, STATUS_TEXT("Level: keep it still"));
    if (!still || !vehicle.attitude.aligned) return MavResult::failed;
    const float lie_rad[] = {parameters.level_trim_rad[0] + vehicle.attitude.roll_rad.toFloat(),
                             parameters.level_trim_rad[1] + vehicle.attitude.pitch_rad.toFloat()};
    return whenTrue(parametersSetFrom(slot::ahrs_trim_x, lie_rad, 2), MavResult::failed);
}

// Bits of what a command asks for.
enum Part : uint8_t {
    kGyros = 1,
    kCompass = 2,
    kPressures = 4,
    kRadio = 8,
    kLevel = 16,
    kSixSides = 32,
    kOneSide = 64,
};
struct PartRow {
    uint8_t param, value;  // param 1: 0
    uint8_t part;
};
// clang-format off
constexpr PartRow kParts[] ROM = {
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

uint8_t partOf(uint8_t param, float value) {
    for (const PartRow& in_flash : kParts) {
        const PartRow row = core::romRead(in_flash);
        if (row.param == param && number(value) == row.value) return row.part;
    }
    return 0;
}

// False: there is something in it that cannot be had here.
bool partsOf(const CommandRequest& request, uint8_t& parts) {
    float param[kParams];
    memcpy(param, &request.item.param1, 4 * sizeof(float));
    param[4] = request.param5;
    param[5] = request.param6;
    param[6] = request.item.z;
    parts = 0;
    for (uint8_t i = 0; i < kParams; ++i) {
        if (!isGiven(param[i])) continue;
        const uint8_t part = partOf(i, param[i]);
        if (part == 0) return false;
        parts |= part;
    }
    // "ground start" of some ground stations: the compass needs more than standing still
    if ((parts & kGyros) != 0) parts &= static_cast<uint8_t>(~kCompass);
    return true;
}

// Accepted: it stands on the ground, disarmed.
uint8_t mayCalibrate() {
    if (!vehicle.armed && !vehicle.estimate.flying) return MavResult::accepted;
    sendStatusText(Severity::error, STATUS_TEXT("Calibration refused: disarm first"));
    if (vehicle.estimate.flying) return MavResult::denied;
    return MavResult::temporarily_rejected;
}

uint8_t begin(Calibrating what, Link& link, const CommandRequest& request, uint8_t answer) {
    if (calibrationBegin(what, {linkNumber(link), request.system, request.component}))
        return answer;
    sendStatusText(Severity::error, STATUS_TEXT("Calibration refused: another runs"));
    return MavResult::temporarily_rejected;
}

uint8_t beginRest(Link& link, const CommandRequest& request, uint8_t parts) {
    const bool again = vehicle.calibrating == Calibrating::rest;
    const uint8_t result = begin(Calibrating::rest, link, request, MavResult::in_progress);
    if (again || result != MavResult::in_progress) return result;
    if ((parts & kGyros) != 0) calibrateGyros();
    if ((parts & kPressures) != 0) calibratePressures();
    return result;
}

uint8_t beginCompass(Link& link, const CommandRequest& request) {
    if (!vehicle.compass.healthy) {
        sendStatusText(Severity::error, STATUS_TEXT("Calibration refused: no compass"));
        return MavResult::failed;
    }
    return begin(Calibrating::compass, link, request, MavResult::accepted);
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

uint8_t calibrate(Link& link, CommandRequest& request) {
    uint8_t parts;
    if (!partsOf(request, parts)) return MavResult::unsupported;
    if (parts == 0) {
        if (vehicle.calibrating == Calibrating::nothing) return MavResult::unsupported;
        return cancelCalibration(link, request);
    }
    uint8_t result = mayCalibrate();
    if (result != MavResult::accepted) return result;
    if (parts == kSixSides) return begin(Calibrating::sides, link, request, MavResult::accepted);
    if (parts == kOneSide) return begin(Calibrating::level, link, request, MavResult::in_progress);
    if (parts == kCompass) return beginCompass(link, request);
    if ((parts & (kSixSides | kOneSide | kCompass)) != 0) return MavResult::unsupported;
    if ((parts & kRadio) != 0) result = trimRadio();
    if ((parts & kLevel) != 0) result = trimLevel();
    if (result != MavResult::accepted || (parts & (kGyros | kPressures)) == 0) return result;
    return beginRest(link, request, parts);
}

uint8_t calibrateCompass(Link& link, CommandRequest& request) {
    const uint8_t result = mayCalibrate();
    return result == MavResult::accepted ? beginCompass(link, request) : result;
}

// What fits is kept without being asked.
uint8_t acceptCompass(Link&, CommandRequest&) { return MavResult::accepted; }

uint8_t cancelCalibration(Link&, CommandRequest&) {
    calibrationCancel();
    return MavResult::accepted;
}

uint8_t sideIsReady(Link&, CommandRequest& request) {
    return whenTrue(calibrationSideIsReady(number(request.item.param1)), MavResult::denied);
}

// A key that was pressed on the ground reaches the airplane as the answer to a command that never
// was: of number 0, 1 or how many keys have been.
bool onCommandAck(Link&, const mavlink::Frame& frame) {
    if (frame.read<mavlink::CommandAck>().command <= kSides) calibrationSideIsReady();
    return true;
}

uint8_t setSensorOffsets(Link&, CommandRequest& request) {
    constexpr uint8_t kCompass = 2;
    if (request.item.param1 != kCompass) return MavResult::unsupported;
    const float offsets_mg[] = {request.item.param2, request.item.param3, request.item.param4};
    return whenTrue(parametersSetFrom(slot::compass_ofs_x, offsets_mg, 3), MavResult::failed);
}

// Values are stored as they are set: reading and writing "all" has nothing to do, but damaged ones
// are accepted by writing. Parameters may be reset alone, missions only with them: then everything
// is erased.
uint8_t resetStorage(Link&, CommandRequest& request) {
    constexpr uint8_t kWrite = 1, kReset = 2;
    const uint16_t action = number(request.item.param1);
    const bool missions = request.item.param2 == kReset;
    if (action == kWrite && !parametersAccept()) return MavResult::temporarily_rejected;
    if (action != kReset) return whenTrue(action < kReset && !missions, MavResult::unsupported);
    return whenTrue(missions ? parametersErase() : parametersReset(),
                    MavResult::temporarily_rejected);
}

// After any reset the bootloader waits for a while for somebody to talk to it: all that 3 wants.
uint8_t reboot(Link& link, CommandRequest& request) {
    constexpr uint8_t kRestart = 1, kToBootloader = 3;
    constexpr float kWhateverHappens = 20190226;
    const uint16_t action = number(request.item.param1);
    if (action == 0) return MavResult::accepted;
    if (action != kRestart && action != kToBootloader) return MavResult::denied;
    if (vehicle.armed) {
        if (request.param6 != kWhateverHappens) return MavResult::temporarily_rejected;
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
