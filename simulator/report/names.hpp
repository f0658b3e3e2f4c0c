// SPDX-License-Identifier: GPL-3.0-or-later
// Names of commands, events, errors and failsafes, from web/src/source/names.json, which the page
// reads too.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "simulator/ground/waypoints.hpp"

namespace simulator {

std::string commandName(uint16_t command);       // "WAYPOINT"; "COMMAND 999" of one without
std::string itemText(const WaypointItem& item);  // "waypoint, 60 m, parameters 0 30 0 0"

// A failsafe by the status text that begins it and the one that ends it, or none does.
struct FailsafeTexts {
    std::string begins, ends;
};
const std::vector<FailsafeTexts>& failsafeTexts();

std::string logEventName(int id);  // of an EV: "armed"
// Of an ERR: "GPS: GPS lost: dead reckoning"; `ours`: of this firmware's log.
std::string logErrorName(int subsystem, int code, bool ours);
std::string logSubsystemName(int subsystem);  // "GPS"; empty: it has none

}  // namespace simulator
