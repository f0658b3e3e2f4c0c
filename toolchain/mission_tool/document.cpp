// SPDX-License-Identifier: GPL-3.0-or-later
#include "toolchain/mission_tool/document.hpp"

#include <algorithm>

#include "firmware/mission/command_table.hpp"
#include "toolchain/mission_tool/wrong_input.hpp"

namespace mission_tool {

using firmware::mission::kCommandTable;
using firmware::mission::MissionResult;

bool Entry::is(mission::Class kind) const { return good() && kCommandTable.kind(row) == kind; }

std::string Document::at(size_t index, const std::string& text) const {
    const Entry& entry = entries[index];
    const std::string item = "item " + std::to_string(index) + ": ";
    if (entry.line == 0) return name + ": " + item + text;
    return placed(name, entry.line, entry.column, (names_items ? item : "") + text);
}

MissionResult check(mission::Set set, size_t index, size_t count, Entry& entry) {
    const auto byte = [](size_t n) { return static_cast<uint8_t>(std::min<size_t>(n, 0xFF)); };
    entry.row = kCommandTable.find(set, entry.record.id);
    if (entry.row == mission::kNoRow) {
        entry.result = MissionResult::unsupported;
    } else if (!mission::fits(set, entry.record)) {
        entry.result = MissionResult::invalid;
    } else {
        entry.result = static_cast<MissionResult>(
            kCommandTable.valid(entry.row, entry.record, {byte(index), byte(count)}));
    }
    return entry.result;
}

const char* nameOf(const Entry& entry) {
    return entry.row == mission::kNoRow ? "?" : firmware::mission::commandName(entry.row);
}

bool hasPlace(const Entry& entry) {
    return entry.is(mission::Class::nav) &&
           (kCommandTable.traits(entry.row) & mission::kPlaced) != 0 &&
           (entry.record.p3 != 0 || entry.record.p4 != 0);
}

}  // namespace mission_tool
