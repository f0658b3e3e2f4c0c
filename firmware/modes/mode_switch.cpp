// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/modes/mode_switch.hpp"

#include <stdint.h>

#include "firmware/mission/mission.hpp"
#include "firmware/modes/modes.hpp"
#include "firmware/sensors/radio.hpp"
#include "firmware/state/parameters.hpp"

namespace firmware {
namespace modes {

using namespace state;
using namespace sensors;
using namespace mission;

namespace {

struct SwitchReading {
    uint8_t position;  // last seen
    uint8_t settled;   // seen twice
    uint8_t obeyed;
    bool restarts;  // RST_MISSION_CH was up
};
SwitchReading mode_switch;

}  // namespace

void runModeSwitch() {
    const bool restarts = switchIsUp(parameters.reset_mission_channel);
    if (restarts && !mode_switch.restarts) missionRestart();
    mode_switch.restarts = restarts;
    if (switchIsUp(parameters.reset_switch_channel)) mode_switch.obeyed = 0;
    const uint8_t position = modeSwitchPosition();
    if (position == mode_switch.position) mode_switch.settled = position;
    mode_switch.position = position;
    if (mode_switch.settled == 0 || mode_switch.settled == mode_switch.obeyed) return;
    // a mode set from the ground stays until the pilot moves the switch
    mode_switch.obeyed = mode_switch.settled;
    requestMode(static_cast<Mode>(parameters.switch_mode[mode_switch.settled - 1]),
                ModeReason::pilot);
}

}  // namespace modes
}  // namespace firmware
