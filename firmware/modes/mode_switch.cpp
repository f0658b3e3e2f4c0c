// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/modes/mode_switch.hpp"

#include <stdint.h>

#include "core/file_state.hpp"
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

constexpr uint8_t kAskAgain = 50;  // 0.1 s

struct SwitchReading {
    uint8_t position;  // last seen
    uint8_t settled;   // seen twice
    uint8_t asked;     // the position whose mode was asked for
    uint8_t refused;   // until it is asked for again, 0.1 s; 0: it was not refused
    uint8_t entries;   // vehicle.mode_entries when it was
    bool restarts;     // RST_MISSION_CH was up
};
core::FileState<SwitchReading> mode_switch{};

void ask() {
    mode_switch.asked = mode_switch.settled;
    const auto mode = static_cast<Mode>(parameters.switch_mode[mode_switch.settled - 1]);
    mode_switch.refused = requestMode(mode, ModeReason::pilot) ? 0 : kAskAgain;
    mode_switch.entries = vehicle.mode_entries;
}

// LOITER without a position may be possible a little later, as after a restart in the air. Another
// mode chosen meanwhile ends the waiting.
void askAgain() {
    if (mode_switch.entries != vehicle.mode_entries) mode_switch.refused = 0;
    if (mode_switch.refused != 0 && --mode_switch.refused == 0) ask();
}

}  // namespace

void resetModeSwitch() { mode_switch.asked = 0; }

void runModeSwitch() {
    const bool restarts = switchIsUp(parameters.reset_mission_channel);
    if (restarts && !mode_switch.restarts) missionRestart();
    mode_switch.restarts = restarts;
    if (switchIsUp(parameters.reset_switch_channel)) resetModeSwitch();
    const uint8_t position = modeSwitchPosition();
    if (position == mode_switch.position) mode_switch.settled = position;
    mode_switch.position = position;
    if (mode_switch.settled == 0 || vehicle.resuming) return;  // the restart reads it itself
    // a mode set from the ground stays until the pilot moves the switch
    if (mode_switch.settled != mode_switch.asked) return ask();
    askAgain();
}

}  // namespace modes
}  // namespace firmware
