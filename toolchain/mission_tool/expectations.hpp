// SPDX-License-Identifier: GPL-3.0-or-later
// What a refusal of the firmware means to the author of a mission: which number is wrong and what
// it should have been.
#pragma once
#include <string>

#include "toolchain/mission_tool/document.hpp"

namespace mission_tool {

// 1..7 for MAV_MISSION_RESULT's invalid_param1 .. 7, where 5, 6, 7 are x, y, z; else 0.
int refusedParameter(firmware::mission::MissionResult result);

// What was expected there. Of a parameter that any value fits: a phrase that says where to read.
std::string expectation(mission::Set set, const Entry& entry);

std::string foundInstead(mission::Set set, const Entry& entry);

// Judges every record of a document that came from an image.
void checkAll(Document& document);

// The field of the record that the parameter is stored in: 1..4 for p1..p4; 0: none.
int fieldOf(mission::Set set, uint8_t row, int parameter);

}  // namespace mission_tool
