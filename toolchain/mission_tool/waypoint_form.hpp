// SPDX-License-Identifier: GPL-3.0-or-later
// Missions as ground stations write them (QGC WPL 110, .plan), by the firmware's own mapping of
// items to records.
#pragma once
#include "toolchain/mission_tool/document.hpp"

namespace mission_tool {

bool looksLikeWaypoints(const std::string& contents);

// Throws WrongInput for what cannot be read; what the firmware would refuse is in the entries.
Document parseWaypointFile(const std::string& contents, const std::string& name, mission::Set set);
Document parsePlan(const std::string& contents, const std::string& name, mission::Set set);

// Of the 1.0 set: a waypoint file with the same NAVs under the same numbers, for who knows only
// MAVLink's commands. The others are in it as MAVLink's nearest, without their values.
std::string placesOf(const Document& document);

std::string itemsAsWaypoints(const std::vector<firmware::mission::MissionItem>& items);

// Only when reading it back would give the same records; else empty: some stored values have no
// place in an item.
std::string recordsAsWaypoints(const Document& document);
// The same, and with the document's fence and rally points.
std::string recordsAsPlan(const Document& document);

}  // namespace mission_tool
