// SPDX-License-Identifier: GPL-3.0-or-later
// Filling in the messages of the streams from the vehicle's state. A message comes zeroed; false:
// there is nothing to send now.
#pragma once
#include "mavlink/messages.hpp"

namespace firmware {
namespace gcs {

struct Link;

bool fillIn(const Link& link, mavlink::Heartbeat& to);
bool fillIn(const Link& link, mavlink::SysStatus& to);
bool fillIn(const Link& link, mavlink::PowerStatus& to);
bool fillIn(const Link& link, mavlink::BatteryStatus& to);
bool fillIn(const Link& link, mavlink::FenceStatus& to);
bool fillIn(const Link& link, mavlink::ExtendedSysState& to);
bool fillIn(const Link& link, mavlink::Hwstatus& to);
bool fillIn(const Link& link, mavlink::Meminfo& to);
bool fillIn(const Link& link, mavlink::EkfStatusReport& to);
bool fillIn(const Link& link, mavlink::SystemTime& to);
bool fillIn(const Link& link, mavlink::AutopilotVersion& to);
bool fillIn(const Link& link, mavlink::ProtocolVersion& to);

bool fillIn(const Link& link, mavlink::AvailableModes& to);
bool fillIn(const Link& link, mavlink::CurrentMode& to);

bool fillIn(const Link& link, mavlink::RawImu& to);
bool fillIn(const Link& link, mavlink::ScaledImu& to);
bool fillIn(const Link& link, mavlink::ScaledPressure& to);
bool fillIn(const Link& link, mavlink::GpsRawInt& to);
bool fillIn(const Link& link, mavlink::RcChannelsRaw& to);
bool fillIn(const Link& link, mavlink::RcChannels& to);
bool fillIn(const Link& link, mavlink::RcChannelsScaled& to);
bool fillIn(const Link& link, mavlink::ServoOutputRaw& to);
bool fillIn(const Link& link, mavlink::Vibration& to);

bool fillIn(const Link& link, mavlink::Attitude& to);
bool fillIn(const Link& link, mavlink::AttitudeQuaternion& to);
bool fillIn(const Link& link, mavlink::Ahrs& to);
bool fillIn(const Link& link, mavlink::GlobalPositionInt& to);
bool fillIn(const Link& link, mavlink::LocalPositionNed& to);
bool fillIn(const Link& link, mavlink::PositionTargetGlobalInt& to);
bool fillIn(const Link& link, mavlink::VfrHud& to);
bool fillIn(const Link& link, mavlink::Wind& to);
bool fillIn(const Link& link, mavlink::NavControllerOutput& to);
bool fillIn(const Link& link, mavlink::HomePosition& to);
bool fillIn(const Link& link, mavlink::MissionCurrent& to);
bool fillIn(const Link& link, mavlink::MissionItemReached& to);
bool fillIn(const Link& link, mavlink::CameraFeedback& to);

}  // namespace gcs
}  // namespace firmware
