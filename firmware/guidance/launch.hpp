// SPDX-License-Identifier: GPL-3.0-or-later
// The motor waits for the launch: it does not start on the ground because a mode was chosen.
// vehicle.progress.throttle_suppressed shows whether it waits.
#pragma once

namespace firmware {
namespace guidance {

// 20 Hz, in every mode: remembers how high the ground is where the airplane stands armed, at arming
// and when a flight ends. Where it stands is not evidence of a launch, wherever home is.
void noteGround();
void suppressThrottle();  // taking over: until proved to fly
void beginLaunch();       // with a take-off
void waitForLaunch();     // 20 Hz

}  // namespace guidance
}  // namespace firmware
