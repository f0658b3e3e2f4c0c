// SPDX-License-Identifier: GPL-3.0-or-later
// The messages that are understood, and who handles each.
#include <stddef.h>

#include "core/rom.hpp"
#include "firmware/gcs/commands.hpp"
#include "firmware/gcs/ftp.hpp"
#include "firmware/gcs/housekeeping.hpp"
#include "firmware/gcs/legacy_points.hpp"
#include "firmware/gcs/link.hpp"
#include "firmware/gcs/logs.hpp"
#include "firmware/gcs/mission_transfer.hpp"
#include "firmware/gcs/parameter_transfer.hpp"
#include "firmware/gcs/signing.hpp"
#include "firmware/gcs/targets.hpp"
#include "firmware/mission/mission.hpp"

namespace firmware {
namespace gcs {

using namespace state;
using namespace mission;

namespace {

constexpr uint8_t kNotAddressed = 0xFF;
constexpr uint8_t kSystemOnly = 0x80;  // in Incoming::target: no component follows the system

struct Incoming {
    mavlink::Accepted accepted;
    uint8_t target;  // where in the payload the system and the component stand that are meant
    Handler handle;
    Handler refuse;  // says that it could not be done in time
};

// For messages that are never refused, or whose sender is asked again anyway.
bool ignoreTimeout(Link&, const mavlink::Frame&) { return true; }

// Of its payload, that which must find room.
template <class Message>
constexpr uint8_t longestPayload() {
    return sizeof(Message);
}
// The zeros behind the path are not sent, and the paths that we know are short.
template <>
constexpr uint8_t longestPayload<mavlink::FileTransferProtocol>() {
    return sizeof(FtpRequest);
}

template <class Message>
constexpr Incoming row(uint8_t target, Handler handle, Handler refuse) {
    static_assert(
        mavlink::kHeaderV2 + longestPayload<Message>() + mavlink::kChecksum <= kLongestQuestion,
        "longer than the parser's buffer");
    return {mavlink::accepts<Message>(), target, handle, refuse};
}

template <class Message>
constexpr uint8_t targetOf() {
    return offsetof(Message, target_system);
}
template <>
constexpr uint8_t targetOf<mavlink::SetMode>() {
    return kSystemOnly | offsetof(mavlink::SetMode, target_system);
}
template <>
constexpr uint8_t targetOf<mavlink::ManualControl>() {
    return kSystemOnly | offsetof(mavlink::ManualControl, target);
}

template <class Message>
constexpr Incoming toAll(Handler handle) {
    return row<Message>(kNotAddressed, handle, ignoreTimeout);
}

template <class Message>
constexpr Incoming toUs(Handler handle, Handler refuse = ignoreTimeout) {
    return row<Message>(targetOf<Message>(), handle, refuse);
}

// clang-format off
constexpr Incoming kIncoming[] ROM = {
    toAll<mavlink::Heartbeat>(onHeartbeat),
    toAll<mavlink::Ping>(onPing),
    toAll<mavlink::Timesync>(onTimesync),
    toAll<mavlink::RadioStatus>(onRadioStatus),
    toAll<mavlink::Radio>(onRadioStatus),  // the same fields under its older number
    toUs<mavlink::RcChannelsOverride>(onRcChannelsOverride),
    toUs<mavlink::ManualControl>(onManualControl),
    toUs<mavlink::SetPositionTargetLocalNed>(onPositionTarget),
    toUs<mavlink::SetPositionTargetGlobalInt>(onPositionTarget),
    toUs<mavlink::SetAttitudeTarget>(refuseTarget),
    toUs<mavlink::SetupSigning>(onSetupSigning, refuseSetupSigning),
    toUs<mavlink::RequestDataStream>(onRequestDataStream),
    toUs<mavlink::SetMode>(onSetMode),
    toUs<mavlink::CommandLong>(onCommand),
    toUs<mavlink::CommandInt>(onCommand),
    toAll<mavlink::CommandAck>(onCommandAck),
    toUs<mavlink::AutopilotVersionRequest>(onAutopilotVersionRequest),
    toUs<mavlink::ParamRequestList>(onParamRequestList),
    toUs<mavlink::ParamRequestRead>(onParamRequestRead),
    toUs<mavlink::ParamSet>(onParamSet, refuseParamSet),
    toUs<mavlink::MissionRequestList>(onMissionRequestList),
    toUs<mavlink::MissionRequestPartialList>(onMissionRequestPartialList, refuseMission),
    toUs<mavlink::MissionRequest>(onMissionRequest, refuseMission),
    toUs<mavlink::MissionRequestInt>(onMissionRequest, refuseMission),
    toUs<mavlink::MissionCount>(onMissionCount, refuseMission),
    toUs<mavlink::MissionWritePartialList>(onMissionWritePartialList, refuseMission),
    toUs<mavlink::MissionItem>(onMissionItem),
    toUs<mavlink::MissionItemInt>(onMissionItem),
    toUs<mavlink::MissionAck>(onMissionAck),
    toUs<mavlink::MissionClearAll>(onMissionClearAll, refuseMission),
    toUs<mavlink::MissionSetCurrent>(onMissionSetCurrent),
    toUs<mavlink::FencePoint>(refuseLegacyPoint),
    toUs<mavlink::FenceFetchPoint>(refuseLegacyPoint),
    toUs<mavlink::RallyPoint>(refuseLegacyPoint),
    toUs<mavlink::RallyFetchPoint>(refuseLegacyPoint),
    toUs<mavlink::FileTransferProtocol>(onFileTransfer),
    toUs<mavlink::LogRequestList>(onLogRequestList),
    toUs<mavlink::LogRequestData>(onLogRequestData),
    toUs<mavlink::LogErase>(onLogErase),
    toUs<mavlink::LogRequestEnd>(onLogRequestEnd),
};
// clang-format on

// Target 0 is everyone; what a MAVLink 2 sender left out is 0.
bool meantForUs(const mavlink::Frame& frame, const Incoming& row) {
    if (row.target == kNotAddressed) return true;
    const uint8_t at = row.target & ~kSystemOnly & 0xFF;
    const uint8_t system = at < frame.length ? frame.payload[at] : 0;
    if (system != 0 && system != static_cast<uint8_t>(parameters.system_id)) return false;
    if ((row.target & kSystemOnly) != 0) return true;
    const uint8_t next = static_cast<uint8_t>(at + 1);
    const uint8_t component = next < frame.length ? frame.payload[next] : 0;
    return component == mavlink::MavComponent::all || component == kComponent;
}

}  // namespace

uint8_t IncomingTable::find(uint16_t id, mavlink::Accepted& to) {
    for (uint8_t row = 0; row < core::count(kIncoming); ++row) {
        if (core::romRead(kIncoming[row].accepted.id) != id) continue;
        to = core::romRead(kIncoming[row].accepted);
        return row;
    }
    return mavlink::kNoRow;
}

bool handleFrame(Link& link, const mavlink::Frame& frame) {
    const Incoming row = core::romRead(kIncoming[frame.row]);
    if (!meantForUs(frame, row)) return true;
    if (row.target != kNotAddressed) radioHeard();
    return row.handle(link, frame);
}

void refuseFrame(Link& link, const mavlink::Frame& frame) {
    core::romRead(kIncoming[frame.row].refuse)(link, frame);
}

}  // namespace gcs
}  // namespace firmware
