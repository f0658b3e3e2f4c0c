// SPDX-License-Identifier: GPL-3.0-or-later
// QGroundControl's .plan (its "Plan File Format", file version 1, mission version 2): read and
// written; and Mission Planner's .mission and .plan, which are nearly the same, read. What a survey
// or a corridor scan flies is what the file stores of it; a landing pattern is expanded as
// QGroundControl does.
#pragma once
#include "simulator/ground/mission_file.hpp"

namespace simulator {

bool looksLikeJson(const std::string& text);  // as decodedText gives it

MissionFile readPlan(const std::string& text, const std::string& name);

// items[0] is home. Indices, lines and columns do not count.
std::string planOf(const MissionFile& mission, double cruise_mps);

}  // namespace simulator
