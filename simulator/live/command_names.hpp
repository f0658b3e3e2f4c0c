// SPDX-License-Identifier: GPL-3.0-or-later
// What the items of a mission are called on a page: MAV_CMD without NAV_ and DO_, and their
// numbers in a few words.
#pragma once
#include "simulator/ground/waypoints.hpp"

namespace simulator::live {

std::string commandName(uint16_t command);  // of an unknown one its number
std::string itemText(const WaypointItem& item);

}  // namespace simulator::live
