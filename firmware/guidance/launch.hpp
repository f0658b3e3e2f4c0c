// SPDX-License-Identifier: GPL-3.0-or-later
// The motor waits for the launch: it does not start on the ground because a mode was chosen.
// vehicle.progress.throttle_suppressed shows whether it waits.
#pragma once

namespace firmware {
namespace guidance {

void suppressThrottle();  // taking over: until proved to fly
void beginLaunch();       // with a take-off
void waitForLaunch();     // 20 Hz

}  // namespace guidance
}  // namespace firmware
