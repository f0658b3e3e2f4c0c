// SPDX-License-Identifier: GPL-3.0-or-later
// The small talk of the link: who is there, which streams, clocks, the radio's report, the
// ground station's sticks.
#pragma once
#include "mavlink/frame.hpp"

namespace firmware {
namespace gcs {

struct Link;

void housekeepingStart();  // nobody has been heard, no stick is held

bool onHeartbeat(Link& link, const mavlink::Frame& frame);
bool onPing(Link& link, const mavlink::Frame& frame);
bool onTimesync(Link& link, const mavlink::Frame& frame);
bool onRequestDataStream(Link& link, const mavlink::Frame& frame);
bool onRadioStatus(Link& link, const mavlink::Frame& frame);
bool onRcChannelsOverride(Link& link, const mavlink::Frame& frame);
bool onManualControl(Link& link, const mavlink::Frame& frame);

}  // namespace gcs
}  // namespace firmware
