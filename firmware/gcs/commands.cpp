// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/gcs/commands.hpp"

#include <math.h>
#include <stddef.h>

#include "core/rom.hpp"
#include "core/seldom.hpp"
#include "firmware/gcs/command_handlers.hpp"
#include "firmware/gcs/degrees.hpp"
#include "firmware/gcs/link.hpp"
#include "firmware/notify/status_text.hpp"
#include "firmware/state/parameters.hpp"

namespace firmware {
namespace gcs {

using namespace mission;
using namespace notify;
using namespace state;

namespace {

using mavlink::MavCmd;
using mavlink::MavResult;

struct CommandRow {
    uint16_t command;
    uint8_t (*carryOut)(Link& link, CommandRequest& request);
};

// clang-format off
constexpr CommandRow kCommands[] ROM = {
    {MavCmd::nav_loiter_unlim,               loiterHere},
    {MavCmd::nav_return_to_launch,           returnToLaunch},
    {MavCmd::nav_land,                       startLanding},
    {MavCmd::nav_takeoff,                    takeOffNow},
    {MavCmd::do_set_mode,                    doSetMode},
    {MavCmd::do_set_standard_mode,           doSetStandardMode},
    {MavCmd::do_change_speed,                changeSpeedNow},
    {MavCmd::do_set_home,                    doSetHome},
    {MavCmd::do_flighttermination,           terminate},
    {MavCmd::do_set_relay,                   actNow},
    {MavCmd::do_repeat_relay,                actNow},
    {MavCmd::do_set_servo,                   actNow},
    {MavCmd::do_repeat_servo,                actNow},
    {MavCmd::do_change_altitude,             changeAltitude},
    {MavCmd::do_land_start,                  startLanding},
    {MavCmd::do_go_around,                   goAround},
    {MavCmd::do_reposition,                  reposition},
    {MavCmd::do_digicam_control,             actNow},
    {MavCmd::do_set_cam_trigg_dist,          actNow},
    {MavCmd::do_inverted_flight,             actNow},
    {MavCmd::do_autotune_enable,             enableAutotune},
    {MavCmd::do_fence_enable,                enableFence},
    {MavCmd::do_aux_function,                doAuxFunction},
    {MavCmd::do_set_mission_current,         setCurrentItem},
    {MavCmd::preflight_calibration,          calibrate},
    {MavCmd::preflight_set_sensor_offsets,   setSensorOffsets},
    {MavCmd::preflight_storage,              resetStorage},
    {MavCmd::preflight_reboot_shutdown,      reboot},
    {MavCmd::mission_start,                  startMission},
    {MavCmd::component_arm_disarm,           armOrDisarm},
    {MavCmd::run_prearm_checks,              runPrearmChecks},
    {MavCmd::get_home_position,              homePosition},
    {MavCmd::get_message_interval,           getMessageInterval},
    {MavCmd::set_message_interval,           setMessageInterval},
    {MavCmd::request_message,                requestMessage},
    {MavCmd::request_protocol_version,       protocolVersion},
    {MavCmd::request_autopilot_capabilities, autopilotVersion},
    {MavCmd::do_start_mag_cal,               calibrateCompass},
    {MavCmd::do_accept_mag_cal,              acceptCompass},
    {MavCmd::do_cancel_mag_cal,              cancelCalibration},
    {MavCmd::accelcal_vehicle_pos,           sideIsReady},
    {MavCmd::do_send_banner,                 sendBanner},
    {MavCmd::guided_change_speed,            guidedSpeed},
    {MavCmd::guided_change_altitude,         guidedAltitude},
    {MavCmd::guided_change_heading,          guidedHeading},
};
// clang-format on

uint8_t carryOut(Link& link, CommandRequest& request) {
    for (const CommandRow& row : kCommands)
        if (core::romRead(row.command) == request.command)
            return core::romRead(row.carryOut)(link, request);
    return MavResult::unsupported;
}

// What lies off the globe must not be taken for a place left out.
SELDOM int32_t placeOf(float degrees) {
    const int32_t angle_e7 = degreesE7(degrees);
    return angle_e7 == kNoPlace && !isnan(degrees) ? INT32_MIN : angle_e7;
}

// All of them stand alike in both messages and in an item.
constexpr uint8_t kParameters = offsetof(mavlink::CommandInt, command);
static_assert(offsetof(MissionItem, z) + sizeof(float) - offsetof(MissionItem, param1) ==
                  kParameters,
              "an item has them in another order");
static_assert(offsetof(mavlink::CommandInt, x) == offsetof(mavlink::CommandLong, param5) &&
                  offsetof(mavlink::CommandInt, command) == offsetof(mavlink::CommandLong, command),
              "one is read as the other");

}  // namespace

uint16_t number(float param) {
    if (!(param >= 0 && param < kNoNumber)) return kNoNumber;
    const uint16_t whole = static_cast<uint16_t>(param);
    return static_cast<float>(whole) == param ? whole : kNoNumber;
}

bool mayForce(const Link& link) {
    if (parameters.force_everywhere != 0 || isUsb(link)) return true;
    sendStatusText(Severity::warning, STATUS_TEXT("Force refused: only over USB"));
    return false;
}

bool isGiven(float param) { return !isnan(param) && param != 0; }

uint8_t whenTrue(bool done, uint8_t otherwise) {
    constexpr uint8_t kAccepted = MavResult::accepted;
    return done ? kAccepted : otherwise;
}

bool acknowledge(Link& link, const CommandRequest& request, uint8_t result) {
    mavlink::CommandAck message = {};
    message.command = request.command;
    message.result = result;
    if (result == MavResult::in_progress) message.progress = UINT8_MAX;  // not known
    message.target_system = request.system;
    message.target_component = request.component;
    return send(link, message);
}

bool onCommand(Link& link, const mavlink::Frame& frame) {
    const auto message = frame.read<mavlink::CommandInt>();
    CommandRequest request;
    request.system = frame.system;
    request.component = frame.component;
    request.command = request.item.command = message.command;
    request.item.frame = message.frame;
    memcpy(&request.item.param1, &message, kParameters);
    request.param5 = static_cast<float>(message.x);
    request.param6 = static_cast<float>(message.y);
    request.has_frame = frame.id != mavlink::Wire<mavlink::CommandLong>::id;
    if (!request.has_frame) {
        memcpy(&request.param5, &message.x, sizeof request.param5);
        memcpy(&request.param6, &message.y, sizeof request.param6);
        request.item.x = placeOf(request.param5);
        request.item.y = placeOf(request.param6);
        request.item.frame = mavlink::MavFrame::global;
    }
    return acknowledge(link, request, carryOut(link, request));
}

bool onSetMode(Link& link, const mavlink::Frame& frame) {
    const auto message = frame.read<mavlink::SetMode>();
    CommandRequest request;
    request.command = mavlink::Wire<mavlink::SetMode>::id;
    request.system = frame.system;
    request.component = frame.component;
    return acknowledge(link, request, setModeOf(message.base_mode, message.custom_mode));
}

bool onAutopilotVersionRequest(Link& link, const mavlink::Frame&) {
    requestOnce(link, mavlink::Wire<mavlink::AutopilotVersion>::id);
    return true;
}

}  // namespace gcs
}  // namespace firmware
