// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/telemetry/commands.hpp"

#include "core/maths.hpp"
#include "firmware/arming.hpp"
#include "firmware/home.hpp"
#include "firmware/mission/mission.hpp"
#include "firmware/modes.hpp"
#include "firmware/sensors/sensors.hpp"
#include "firmware/telemetry/degrees.hpp"
#include "firmware/telemetry/link.hpp"
#include "firmware/telemetry/text.hpp"
#include "firmware/vehicle.hpp"
#include "hal/eeprom.hpp"
#include "hal/watchdog.hpp"

namespace firmware {
namespace {

using mavlink::MavCmd;
using mavlink::MavResult;

// A command in one form, whichever message brought it.
struct Order {
    uint16_t command;
    float param1, param2, param3, param4, param5, param6;
    geo::Position position;  // parameters 5 and 6 as a place
    float altitude_m;        // parameter 7
};

uint8_t whenTrue(bool done, uint8_t otherwise) {
    constexpr uint8_t kAccepted = MavResult::accepted;
    return done ? kAccepted : otherwise;
}

// A parameter that is one of a few whole numbers.
bool is(float param, uint16_t number) { return param == static_cast<float>(number); }

uint8_t enterMode(uint32_t custom_mode) {
    if (custom_mode > 0xFF || !isMode(static_cast<uint8_t>(custom_mode))) return MavResult::denied;
    return whenTrue(setMode(static_cast<Mode>(custom_mode), ModeReason::ground),
                    MavResult::temporarily_rejected);
}

// The base modes of before there were custom modes (MAV_MODE).
uint8_t enterBaseMode(uint8_t base_mode) {
    struct Row {
        uint8_t base_mode;
        Mode mode;
    };
    static constexpr Row kRows[] ROM = {
        {64, Mode::manual}, {80, Mode::fbwa}, {92, Mode::automatic}};
    const uint8_t disarmed = base_mode & ~mavlink::MavModeFlag::safety_armed & 0xFF;
    for (const Row& in_flash : kRows) {
        const Row row = core::romRead(in_flash);
        if (row.base_mode == disarmed) return enterMode(static_cast<uint8_t>(row.mode));
    }
    return MavResult::denied;
}

uint8_t setModeOf(uint8_t base_mode, uint32_t custom_mode) {
    if ((base_mode & mavlink::MavModeFlag::custom_mode_enabled) != 0) return enterMode(custom_mode);
    return enterBaseMode(base_mode);
}

uint8_t doSetMode(Link&, const Order& order) {
    if (!(order.param1 >= 0 && order.param1 <= 255 && order.param2 >= 0 && order.param2 <= 255))
        return MavResult::denied;
    return setModeOf(static_cast<uint8_t>(order.param1), static_cast<uint8_t>(order.param2));
}

uint8_t returnToLaunch(Link&, const Order&) { return enterMode(static_cast<uint8_t>(Mode::rtl)); }
uint8_t loiter(Link&, const Order&) { return enterMode(static_cast<uint8_t>(Mode::loiter)); }
uint8_t missionStart(Link&, const Order&) {
    return enterMode(static_cast<uint8_t>(Mode::automatic));
}

uint8_t armOrDisarm(Link&, const Order& order) {
    constexpr uint16_t kForceArm = 2989, kForceDisarm = 21196;  // as MAVLink documents them
    if (is(order.param1, 1)) {
        const bool force = is(order.param2, kForceArm) || is(order.param2, kForceDisarm);
        return whenTrue(arm(ArmReason::ground, force), MavResult::failed);
    }
    if (!is(order.param1, 0)) return MavResult::denied;
    return whenTrue(disarm(ArmReason::ground, is(order.param2, kForceDisarm)), MavResult::failed);
}

uint8_t runPrearmChecks(Link&, const Order&) {
    const core::RomText why = prearmFailure();
    if (why == nullptr) return MavResult::accepted;
    tell(Severity::error, why);
    return MavResult::failed;
}

uint8_t setCurrentItem(Link& link, const Order& order) {
    if (!(order.param1 >= 0 && order.param1 < 32768.0f)) return MavResult::denied;
    if (!missionSetCurrent(static_cast<uint16_t>(order.param1))) return MavResult::denied;
    requestOnce(link, mavlink::Wire<mavlink::MissionCurrent>::id);
    return MavResult::accepted;
}

uint8_t doSetHome(Link&, const Order& order) {
    if (is(order.param1, 1)) return whenTrue(setHomeHere(), MavResult::temporarily_rejected);
    const geo::Position& place = order.position;
    const bool on_globe = place.latitude_e7 >= -900000000 && place.latitude_e7 <= 900000000 &&
                          place.longitude_e7 >= -1800000000 && place.longitude_e7 <= 1800000000;
    // 0, 0 is what a client sends that has no place to give
    if (!on_globe || (place.latitude_e7 == 0 && place.longitude_e7 == 0) ||
        !(fabsf(order.altitude_m) < 20000))
        return MavResult::denied;
    setHome(place, core::rounded(order.altitude_m * 100));
    return MavResult::accepted;
}

uint8_t calibrate(Link&, const Order& order) {
    const bool gyros = is(order.param1, 1), pressures = is(order.param3, 1);
    if (!gyros && !pressures) return MavResult::unsupported;
    if (vehicle.armed || vehicle.estimate.flying) return MavResult::temporarily_rejected;
    if (gyros) calibrateGyros();
    if (pressures) calibratePressures();
    return MavResult::accepted;
}

// Values are stored as they are set: reading and writing "all" has nothing to do. Parameters may be
// reset alone, missions only with them: then everything is erased.
uint8_t resetStorage(Link&, const Order& order) {
    constexpr uint16_t kReset = 2;
    const bool missions = is(order.param2, kReset);
    if (!is(order.param1, kReset)) {
        const bool nothing = !missions && (is(order.param1, 0) || is(order.param1, 1));
        return whenTrue(nothing, MavResult::unsupported);
    }
    return whenTrue(missions ? parametersErase() : parametersReset(),
                    MavResult::temporarily_rejected);
}

constexpr uint8_t kRebootTurns = 15;  // 0.3 s for the answer to get out
uint8_t turns_to_reboot;

uint8_t reboot(Link&, const Order& order) {
    constexpr float kEvenArmed = 20190226;
    if (is(order.param1, 0)) return MavResult::accepted;
    if (!is(order.param1, 1)) return MavResult::denied;  // the bootloader cannot be kept running
    if (vehicle.armed && order.param6 != kEvenArmed) return MavResult::temporarily_rejected;
    turns_to_reboot = kRebootTurns;
    return MavResult::accepted;
}

uint8_t homePosition(Link& link, const Order&) {
    if (!vehicle.home.set) return MavResult::temporarily_rejected;
    requestOnce(link, mavlink::Wire<mavlink::HomePosition>::id);
    return MavResult::accepted;
}

uint8_t rowOf(float message_id) {
    if (!(message_id >= 0 && message_id < 65536.0f)) return kNoMessage;
    return outgoingRow(static_cast<uint16_t>(message_id));
}

uint8_t requestMessage(Link& link, const Order& order) {
    const uint8_t row = rowOf(order.param1);
    if (row == kNoMessage) return MavResult::unsupported;
    const uint16_t id = static_cast<uint16_t>(order.param1);
    if (id == mavlink::Wire<mavlink::HomePosition>::id) return homePosition(link, order);
    requestOnce(link, id);
    return MavResult::accepted;
}

uint8_t setMessageInterval(Link& link, const Order& order) {
    const uint8_t row = rowOf(order.param1);
    if (row == kNoMessage) return MavResult::unsupported;
    if (!(order.param2 >= -1 && order.param2 < 1e9f)) return MavResult::denied;
    return whenTrue(setInterval(link, row, static_cast<int32_t>(order.param2)), MavResult::denied);
}

uint8_t getMessageInterval(Link& link, const Order& order) {
    if (!(order.param1 >= 0 && order.param1 < 65536.0f)) return MavResult::denied;
    const uint8_t row = rowOf(order.param1);
    mavlink::MessageInterval message = {};
    message.message_id = static_cast<uint16_t>(order.param1);
    if (row != kNoMessage) message.interval_us = interval_us(link, row);  // 0: unknown to us
    return whenTrue(send(link, message), MavResult::temporarily_rejected);
}

uint8_t autopilotVersion(Link& link, const Order&) {
    requestOnce(link, mavlink::Wire<mavlink::AutopilotVersion>::id);
    return MavResult::accepted;
}

uint8_t protocolVersion(Link& link, const Order&) {
    requestOnce(link, mavlink::Wire<mavlink::ProtocolVersion>::id);
    return MavResult::accepted;
}

struct CommandRow {
    uint16_t command;
    uint8_t (*carryOut)(Link& link, const Order& order);  // the MAV_RESULT
};

// clang-format off
constexpr CommandRow kCommands[] ROM = {
    {MavCmd::nav_loiter_unlim,               loiter},
    {MavCmd::nav_return_to_launch,           returnToLaunch},
    {MavCmd::do_set_mode,                    doSetMode},
    {MavCmd::do_set_home,                    doSetHome},
    {MavCmd::do_set_mission_current,         setCurrentItem},
    {MavCmd::preflight_calibration,          calibrate},
    {MavCmd::preflight_storage,              resetStorage},
    {MavCmd::preflight_reboot_shutdown,      reboot},
    {MavCmd::mission_start,                  missionStart},
    {MavCmd::component_arm_disarm,           armOrDisarm},
    {MavCmd::run_prearm_checks,              runPrearmChecks},
    {MavCmd::get_home_position,              homePosition},
    {MavCmd::get_message_interval,           getMessageInterval},
    {MavCmd::set_message_interval,           setMessageInterval},
    {MavCmd::request_message,                requestMessage},
    {MavCmd::request_protocol_version,       protocolVersion},
    {MavCmd::request_autopilot_capabilities, autopilotVersion},
};
// clang-format on

uint8_t carryOut(Link& link, const Order& order) {
    for (const CommandRow& row : kCommands)
        if (core::romRead(row.command) == order.command)
            return core::romRead(row.carryOut)(link, order);
    return MavResult::unsupported;
}

bool acknowledge(Link& link, const mavlink::Frame& frame, uint16_t command, uint8_t result) {
    mavlink::CommandAck message = {};
    message.command = command;
    message.result = result;
    message.target_system = frame.system;
    message.target_component = frame.component;
    return send(link, message);
}

template <class Message>
Order common(const Message& from) {
    Order order = {};
    order.command = from.command;
    order.param1 = from.param1;
    order.param2 = from.param2;
    order.param3 = from.param3;
    order.param4 = from.param4;
    return order;
}

}  // namespace

bool onCommandLong(Link& link, const mavlink::Frame& frame) {
    const auto message = frame.read<mavlink::CommandLong>();
    Order order = common(message);
    order.param5 = message.param5;
    order.param6 = message.param6;
    order.position = {degreesE7(message.param5), degreesE7(message.param6)};
    order.altitude_m = message.param7;
    return acknowledge(link, frame, order.command, carryOut(link, order));
}

bool onCommandInt(Link& link, const mavlink::Frame& frame) {
    const auto message = frame.read<mavlink::CommandInt>();
    Order order = common(message);
    order.param5 = static_cast<float>(message.x);
    order.param6 = static_cast<float>(message.y);
    order.position = {message.x, message.y};
    order.altitude_m = message.z;
    return acknowledge(link, frame, order.command, carryOut(link, order));
}

bool onSetMode(Link& link, const mavlink::Frame& frame) {
    const auto message = frame.read<mavlink::SetMode>();
    return acknowledge(link, frame, mavlink::Wire<mavlink::SetMode>::id,
                       setModeOf(message.base_mode, message.custom_mode));
}

bool onAutopilotVersionRequest(Link& link, const mavlink::Frame&) {
    requestOnce(link, mavlink::Wire<mavlink::AutopilotVersion>::id);
    return true;
}

void commandsStart() { turns_to_reboot = 0; }

void commandsTurn() {
    if (turns_to_reboot == 0) return;
    if (turns_to_reboot > 1) {
        --turns_to_reboot;
    } else if (hal::eepromDrained()) {
        hal::reboot();
    }
}

}  // namespace firmware
