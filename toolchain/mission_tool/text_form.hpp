// SPDX-License-Identifier: GPL-3.0-or-later
// Missions as text, a stored record a line; docs/mission.md, "Text form of the APM 1.0 set".
#pragma once
#include "toolchain/mission_tool/document.hpp"

namespace mission_tool {

bool looksLikeRecords(const std::string& contents);

// Throws WrongInput for what cannot be read; what the firmware would refuse is in the entries.
Document parseRecords(const std::string& contents, const std::string& name);
std::string recordsAsText(const Document& document);

}  // namespace mission_tool
