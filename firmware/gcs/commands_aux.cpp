// SPDX-License-Identifier: GPL-3.0-or-later
// What a switch of the transmitter does by RCn_OPTION, and MAV_CMD_DO_AUX_FUNCTION in its place: by
// ArduPlane's numbers. Mission Planner has buttons for the command.
#include "core/file_state.hpp"
#include "core/rom.hpp"
#include "firmware/gcs/aux_switches.hpp"
#include "firmware/gcs/command_handlers.hpp"
#include "firmware/gcs/link.hpp"
#include "firmware/modes/mode_switch.hpp"
#include "firmware/modes/modes.hpp"
#include "firmware/sensors/radio.hpp"
#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace gcs {

using namespace state;

namespace {

using mavlink::MavCmd;
using mavlink::MavResult;

using sensors::SwitchPosition;

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

struct Wanted {
    uint16_t function;
    SwitchPosition position;
    ModeReason reason;
};

uint8_t enterOrLeave(Mode mode, const Wanted& wanted) {
    if (wanted.position == SwitchPosition::high)
        return whenTrue(modes::requestMode(mode, wanted.reason), MavResult::temporarily_rejected);
    if (wanted.position == SwitchPosition::low && vehicle.mode == mode) modes::resetModeSwitch();
    return MavResult::accepted;
}

uint8_t carryOut(const Function& function, SwitchPosition position, Link& link,
                 CommandRequest& request) {
    if (position == SwitchPosition::middle) return MavResult::accepted;
    const bool high = position == SwitchPosition::high;
    const uint16_t command = core::romRead(function.command);
    if (command == MavCmd::do_digicam_control && !high) return MavResult::accepted;
    const bool relay = command == MavCmd::do_set_relay;
    request.item.command = command;
    request.item.param1 = high && !relay;
    request.item.param2 = high && relay;
    return core::romRead(function.carryOut)(link, request);
}

uint8_t carryOut(const Wanted& wanted, Link& link, CommandRequest& request) {
    for (const ModeFunction& row : kModeFunctions)
        if (core::romRead(row.function) == wanted.function)
            return enterOrLeave(core::romRead(row.mode), wanted);
    for (const Function& row : kFunctions)
        if (core::romRead(row.function) == wanted.function)
            return carryOut(row, wanted.position, link, request);
    return MavResult::unsupported;
}

constexpr uint8_t kFirstChannel = 5;
struct AuxSwitches {
    SwitchPosition last[core::count(Parameters{}.switch_option)];
};
core::FileState<AuxSwitches> switches{};

}  // namespace

uint8_t doAuxFunction(Link& link, CommandRequest& request) {
    const uint16_t position = number(request.item.param2);  // of MAVLink: 0 low, 1 middle, 2 high
    if (position > 2) return MavResult::denied;
    return carryOut({number(request.item.param1), static_cast<SwitchPosition>(position + 1),
                     ModeReason::ground},
                    link, request);
}

void runAuxSwitches() {
    for (uint8_t i = 0; i < core::count(switches.last); ++i) {
        const SwitchPosition position = sensors::switchPosition(kFirstChannel + i);
        const SwitchPosition last = switches.last[i];
        if (position == SwitchPosition::unknown || position == last) continue;
        switches.last[i] = position;
        if (last == SwitchPosition::unknown) continue;  // where it stands when it is first received
        CommandRequest request = {};
        (void)carryOut(
            {static_cast<uint16_t>(parameters.switch_option[i]), position, ModeReason::pilot},
            links[0], request);
    }
}

}  // namespace gcs
}  // namespace firmware
