// SPDX-License-Identifier: GPL-3.0-or-later
// The ground links: what goes out when, and what happens on what comes in. link0 is the USB port
// or the telemetry connector, link1 the second telemetry port; both speak MAVLink 1 until the
// other end has sent a MAVLink 2 frame.
#pragma once
#include <stdint.h>

namespace firmware {
namespace gcs {

void telemetryStart();  // after the parameters have been read
void sendBannerText();  // a text: what this is
void telemetrySend();   // 50 Hz: finds what is due
// In the rest of a frame: handles received bytes, then sends what is due, a little each call.
// False: nothing is left to do until an interrupt makes telemetryWaits true.
bool telemetryPump();
bool telemetryWaits();  // asked often: 60 cycles

}  // namespace gcs
}  // namespace firmware
