// SPDX-License-Identifier: GPL-3.0-or-later
// The rudder, and the nose wheel with it, on the runway: in the take-off run it keeps the nose from
// swinging, from the flare on it holds the heading. In between nothing is asked of it.
#pragma once

namespace firmware {
namespace guidance {

void steerNowhere();
void steadyNose();                     // 20 Hz
void steerTowards(float heading_rad);  // 20 Hz

}  // namespace guidance
}  // namespace firmware
