// SPDX-License-Identifier: GPL-3.0-or-later
// MAV_CMD_DO_AUX_FUNCTION: what a switch of the transmitter would do by RCn_OPTION in ArduPlane, by
// the same numbers. Mission Planner has buttons for it.
#include "core/rom.hpp"
#include "firmware/gcs/command_handlers.hpp"
#include "firmware/modes/mode_switch.hpp"
#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace gcs {

using namespace state;

namespace {

using mavlink::MavCmd;
using mavlink::MavResult;

enum SwitchPosition : uint16_t { kLow, kMiddle, kHigh, kPositions };

struct ModeFunction {
    uint8_t function;
    Mode mode;
};
// clang-format off
constexpr ModeFunction kModeFunctions[] ROM = {
    {  4, Mode::rtl},       { 16, Mode::automatic}, { 51, Mode::manual}, { 52, Mode::acro},
    { 55, Mode::guided},    { 56, Mode::loiter},    { 68, Mode::stabilize},
    { 72, Mode::circle},    { 77, Mode::takeoff},   { 92, Mode::fbwa},
    {150, Mode::cruise},
};

// By the command that does it: with 1 in its last parameter that counts where the switch is high.
struct Function {
    uint8_t function;
    uint16_t command;
    uint8_t (*carryOut)(Link& link, CommandRequest& request);
};
constexpr Function kFunctions[] ROM = {
    {  9, MavCmd::do_digicam_control,   actNow},
    { 11, MavCmd::do_fence_enable,      enableFence},
    { 28, MavCmd::do_set_relay,         actNow},
    { 43, MavCmd::do_inverted_flight,   actNow},
    {153, MavCmd::component_arm_disarm, armOrDisarm},
};
// clang-format on

uint8_t enterOrLeave(Mode mode, uint16_t position) {
    if (position == kHigh)
        return setModeOf(mavlink::MavModeFlag::custom_mode_enabled, static_cast<uint8_t>(mode));
    if (position == kLow && vehicle.mode == mode) modes::resetModeSwitch();
    return MavResult::accepted;
}

uint8_t carryOut(const Function& function, uint16_t position, Link& link, CommandRequest& request) {
    if (position == kMiddle) return MavResult::accepted;
    const bool high = position == kHigh;
    const uint16_t command = core::romRead(function.command);
    if (command == MavCmd::do_digicam_control && !high) return MavResult::accepted;
    const bool relay = command == MavCmd::do_set_relay;
    request.item.command = command;
    request.item.param1 = high && !relay;
    request.item.param2 = high && relay;
    return core::romRead(function.carryOut)(link, request);
}

}  // namespace

uint8_t doAuxFunction(Link& link, CommandRequest& request) {
    const uint16_t wanted = number(request.item.param1), position = number(request.item.param2);
    if (position >= kPositions) return MavResult::denied;
    for (const ModeFunction& row : kModeFunctions)
        if (core::romRead(row.function) == wanted)
            return enterOrLeave(core::romRead(row.mode), position);
    for (const Function& row : kFunctions)
        if (core::romRead(row.function) == wanted) return carryOut(row, position, link, request);
    return MavResult::unsupported;
}

}  // namespace gcs
}  // namespace firmware
