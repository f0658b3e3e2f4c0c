// SPDX-License-Identifier: GPL-3.0-or-later
// A mission as the tool holds it, whatever it was read from: stored records, each with its row of
// the firmware's command table and what the firmware says of it.
#pragma once
#include <string>
#include <vector>

#include "firmware/mission/mission.hpp"
#include "mission/command_table.hpp"
#include "simulator/ground/mission_file.hpp"

namespace mission_tool {

struct Entry {
    mission::Record record{};
    uint16_t command = 0;  // of an item whose command no record could hold; else 0
    uint8_t row = mission::kNoRow;
    firmware::mission::MissionResult result = firmware::mission::MissionResult::accepted;
    int line = 0, column = 0;        // of what is wrong, or of the line's first word; 0: an image
    std::string problem;             // empty: the firmware takes it
    std::vector<std::string> notes;  // what the firmware would report about it

    bool good() const { return problem.empty(); }
    bool is(mission::Class kind) const;  // of a good one
};

struct Document {
    std::string name;
    mission::Set set = mission::Set::apm2;
    std::vector<Entry> entries;  // entries[0] is home

    // Of a .plan.
    simulator::Fence fence;
    std::vector<simulator::RallyPlace> rally;
    std::vector<simulator::Remark> remarks;
    bool names_items = false;  // at() names the item: its line does not

    // "name:line:column: text", or "name: item 3: text" of an image.
    std::string at(size_t index, const std::string& text) const;
};

// Looks the record up and asks the firmware whether its values are in range. The firmware must have
// been started (board.hpp): some ranges are parameters.
firmware::mission::MissionResult check(mission::Set set, size_t index, size_t count, Entry& entry);

const char* nameOf(const Entry& entry);
bool hasPlace(const Entry& entry);  // of a good NAV

}  // namespace mission_tool
