// SPDX-License-Identifier: GPL-3.0-or-later
// The table of all messages, for a peer that wants to understand everything.
// Written by toolchain/mavlink/generate.mjs from mavlink-mappings 1.0.22-20260311. Do not edit.
#pragma once

#include "core/rom.hpp"
#include "mavlink/messages.hpp"

// clang-format off
namespace mavlink {

constexpr Accepted kAllMessages[] ROM = {
    accepts<Heartbeat>(),
    accepts<SysStatus>(),
    accepts<SystemTime>(),
    accepts<Ping>(),
    accepts<SetMode>(),
    accepts<ParamRequestRead>(),
    accepts<ParamRequestList>(),
    accepts<ParamValue>(),
    accepts<ParamSet>(),
    accepts<GpsRawInt>(),
    accepts<RawImu>(),
    accepts<ScaledPressure>(),
    accepts<Attitude>(),
    accepts<GlobalPositionInt>(),
    accepts<RcChannelsRaw>(),
    accepts<ServoOutputRaw>(),
    accepts<MissionRequestPartialList>(),
    accepts<MissionWritePartialList>(),
    accepts<MissionItem>(),
    accepts<MissionRequest>(),
    accepts<MissionSetCurrent>(),
    accepts<MissionCurrent>(),
    accepts<MissionRequestList>(),
    accepts<MissionCount>(),
    accepts<MissionClearAll>(),
    accepts<MissionItemReached>(),
    accepts<MissionAck>(),
    accepts<MissionRequestInt>(),
    accepts<NavControllerOutput>(),
    accepts<RcChannels>(),
    accepts<RequestDataStream>(),
    accepts<ManualControl>(),
    accepts<RcChannelsOverride>(),
    accepts<MissionItemInt>(),
    accepts<VfrHud>(),
    accepts<CommandInt>(),
    accepts<CommandLong>(),
    accepts<CommandAck>(),
    accepts<RadioStatus>(),
    accepts<Timesync>(),
    accepts<LogRequestList>(),
    accepts<LogEntry>(),
    accepts<LogRequestData>(),
    accepts<LogData>(),
    accepts<LogErase>(),
    accepts<LogRequestEnd>(),
    accepts<PowerStatus>(),
    accepts<AutopilotVersion>(),
    accepts<Meminfo>(),
    accepts<FencePoint>(),
    accepts<FenceFetchPoint>(),
    accepts<FenceStatus>(),
    accepts<Ahrs>(),
    accepts<Hwstatus>(),
    accepts<Radio>(),
    accepts<Wind>(),
    accepts<RallyPoint>(),
    accepts<RallyFetchPoint>(),
    accepts<CameraFeedback>(),
    accepts<AutopilotVersionRequest>(),
    accepts<MagCalProgress>(),
    accepts<MagCalReport>(),
    accepts<HomePosition>(),
    accepts<MessageInterval>(),
    accepts<ExtendedSysState>(),
    accepts<Statustext>(),
    accepts<ProtocolVersion>(),
};

}  // namespace mavlink
// clang-format on
