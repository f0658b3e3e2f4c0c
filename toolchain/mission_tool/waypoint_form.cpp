// SPDX-License-Identifier: GPL-3.0-or-later
#include "toolchain/mission_tool/waypoint_form.hpp"

#include <charconv>
#include <cmath>
#include <cstring>

#include "firmware/mission/command_table.hpp"
#include "firmware/mission/item.hpp"
#include "firmware/state/parameters.hpp"
#include "simulator/ground/waypoints.hpp"
#include "toolchain/mission_tool/expectations.hpp"
#include "toolchain/mission_tool/wrong_input.hpp"

namespace mission_tool {
namespace {

using firmware::mission::MissionItem;
using firmware::mission::MissionResult;
using mission::Set;
using simulator::WaypointItem;

constexpr char kHeader[] = "QGC WPL 110";
constexpr uint8_t kAboveSea = 0, kAboveHome = 3;  // MAV_FRAME
enum Column : size_t { kFrame = 2, kCommand = 3, kParam1 = 4 };

MissionItem itemOf(const WaypointItem& from) {
    const auto e7 = [](double degrees) { return static_cast<int32_t>(std::lround(degrees * 1e7)); };
    const auto param = [&](size_t i) { return static_cast<float>(from.params[i]); };
    return {from.command,
            from.frame,
            param(0),
            param(1),
            param(2),
            param(3),
            e7(from.latitude_deg),
            e7(from.longitude_deg),
            static_cast<float>(from.altitude_m)};
}

size_t columnOf(MissionResult result) {
    if (const int parameter = refusedParameter(result)) {
        return kParam1 + static_cast<size_t>(parameter) - 1;
    }
    return result == MissionResult::unsupported_frame ? kFrame : kCommand;
}

std::string wordAt(const std::string& contents, int line, int column) {
    size_t begin = 0;
    for (int i = 1; i < line; ++i) begin = contents.find('\n', begin) + 1;
    begin += static_cast<size_t>(column) - 1;
    return contents.substr(begin, contents.find_first_of(" \t\r\n", begin) - begin);
}

Entry entryOf(const WaypointItem& from, Set set, size_t index, size_t count) {
    const auto byte = [](size_t n) { return static_cast<uint8_t>(std::min<size_t>(n, 0xFF)); };
    Entry entry;
    MissionItem item = itemOf(from);
    // the record of home in the 1.0 set has no room for its frame; it is above the sea in any case
    if (set == Set::apm1 && index == 0) {
        item.frame = firmware::state::parameters.altitude_absolute != 0 ? kAboveSea : kAboveHome;
    }
    firmware::mission::Notes notes = {};
    entry.result =
        firmware::mission::encodeItem(set, {byte(index), byte(count)}, item, entry.record, notes);
    if (entry.result == MissionResult::accepted) {
        entry.result = check(set, index, count, entry);
    } else {
        // what can be said of it although it has no record
        const bool is_byte = from.command <= 0xFF;
        if (!is_byte) entry.command = from.command;
        entry.record.id = is_byte ? static_cast<uint8_t>(from.command) : mission::kNoId;
        entry.row = firmware::mission::kCommandTable.find(set, entry.record.id);
    }
    if (notes.rounded) entry.notes.push_back("a value is rounded to what the record can hold");
    if (notes.dropped)
        entry.notes.push_back("a parameter that the command does not use is dropped");
    entry.line = from.line;
    entry.column = from.columns[0];
    return entry;
}

std::string shortest(float value) {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, value).ptr;
    return {text, end};
}

// Seven decimals, exactly.
std::string degrees(int32_t e7) {
    const int64_t size = std::llabs(e7);
    char text[24];
    std::snprintf(text, sizeof text, "%s%d.%07d", e7 < 0 ? "-" : "", int(size / 10000000),
                  int(size % 10000000));
    return text;
}

std::string lineOf(size_t index, const MissionItem& item) {
    std::string text = std::to_string(index) + (index == 0 ? "\t1\t" : "\t0\t") +
                       std::to_string(item.frame) + '\t' + std::to_string(item.command);
    for (float param : {item.param1, item.param2, item.param3, item.param4}) {
        text += '\t' + shortest(param);
    }
    return text + '\t' + degrees(item.x) + '\t' + degrees(item.y) + '\t' + shortest(item.z) +
           "\t1\n";
}

bool sameRecords(const Document& a, const Document& b) {
    if (a.entries.size() != b.entries.size()) return false;
    for (size_t i = 0; i < a.entries.size(); ++i) {
        uint8_t bytes[2][mission::kRecordSize];
        mission::pack(a.set, a.entries[i].record, bytes[0]);
        mission::pack(b.set, b.entries[i].record, bytes[1]);
        if (std::memcmp(bytes[0], bytes[1], sizeof bytes[0]) != 0) return false;
    }
    return true;
}

}  // namespace

bool looksLikeWaypoints(const std::string& contents) { return contents.rfind("QGC", 0) == 0; }

Document parseWaypointFile(const std::string& contents, const std::string& name, Set set) {
    const auto [items, errors] = simulator::readWaypointLines(contents, name);
    std::vector<LineProblem> problems;
    for (const auto& error : errors) problems.push_back({error.line, error.column, error.text});
    Document document;
    document.name = name;
    document.set = set;
    for (size_t i = 0; i < items.size(); ++i) {
        Entry entry = entryOf(items[i], set, i, items.size());
        if (entry.result != MissionResult::accepted) {
            entry.column = items[i].columns[columnOf(entry.result)];
            entry.problem =
                expected(expectation(set, entry), wordAt(contents, entry.line, entry.column));
        }
        document.entries.push_back(entry);
        if (items[i].readable && !entry.good())
            problems.push_back({entry.line, entry.column, document.at(i, entry.problem)});
    }
    if (!errors.empty()) throwProblems(problems);
    return document;
}

std::string itemsAsWaypoints(const std::vector<MissionItem>& items) {
    std::string text = std::string(kHeader) + '\n';
    for (size_t i = 0; i < items.size(); ++i) text += lineOf(i, items[i]);
    return text;
}

std::string recordsAsWaypoints(const Document& document) {
    if (document.set != Set::apm2) return "";
    std::vector<MissionItem> items(document.entries.size());
    for (size_t i = 0; i < items.size(); ++i)
        firmware::mission::decodeItem(document.set, static_cast<uint8_t>(i),
                                      document.entries[i].record, items[i]);
    const std::string text = itemsAsWaypoints(items);
    try {
        const Document again = parseWaypointFile(text, document.name, document.set);
        for (const Entry& entry : again.entries)
            if (!entry.good()) return "";
        return sameRecords(document, again) ? text : "";
    } catch (const WrongInput&) {
        return "";
    }
}

}  // namespace mission_tool
