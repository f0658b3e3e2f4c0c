// SPDX-License-Identifier: GPL-3.0-or-later
// The pilot's mode switch.
#pragma once

namespace firmware {
namespace modes {

// 10 Hz: sets FLTMODEn when the position has changed, or RST_SWITCH_CH is up; begins the mission
// anew when RST_MISSION_CH goes up.
void runModeSwitch();
// As if RST_SWITCH_CH had gone up: the next run sets the mode of the switch's position.
void resetModeSwitch();

}  // namespace modes
}  // namespace firmware
