// SPDX-License-Identifier: GPL-3.0-or-later
// Any file the tool reads, by what is in it.
#pragma once
#include <functional>
#include <optional>

#include "toolchain/mission_tool/document.hpp"
#include "toolchain/mission_tool/image.hpp"

namespace mission_tool {

struct Reading {
    std::optional<mission::Set> set;  // expected; waypoint files are in the 2.0 set otherwise
    Image onto;                       // the board the mission is for: its parameters set the ranges
    std::string onto_name;
    bool records15 = false;
    std::function<void()> prepare;  // the board once it runs, for what is not an image
    size_t count = 0;               // of 15-byte records; 0: not given
};

std::string readFile(const std::string& path);  // throws WrongInput

// QGC WPL 110 or JSON, which the simulator reads too.
bool looksLikeGroundStations(const std::string& contents);
bool isImage(const std::string& contents);
Image imageOf(const std::string& contents, const std::string& name);  // throws WrongInput

// Throws WrongInput; what the firmware would refuse is in the entries.
Document load(const std::string& contents, const std::string& name, const Reading& reading);

}  // namespace mission_tool
