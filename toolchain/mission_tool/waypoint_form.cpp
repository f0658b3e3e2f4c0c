// SPDX-License-Identifier: GPL-3.0-or-later
#include "toolchain/mission_tool/waypoint_form.hpp"

#include <charconv>
#include <cmath>
#include <cstring>
#include <utility>

#include "firmware/mission/command_table.hpp"
#include "firmware/mission/item.hpp"
#include "firmware/state/parameters.hpp"
#include "simulator/ground/plan_file.hpp"
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

std::string wordAt(const std::string& contents, const WaypointItem& item, int column) {
    const size_t begin = item.begins + static_cast<size_t>(column) - 1;
    return contents.substr(begin, contents.find_first_of(" \t\r\n", begin) - begin);
}

template <class Number>
std::string shortest(Number value) {
    char text[32];
    return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

// Of an item that has no columns: what would stand there.
std::string valueOf(const WaypointItem& item, size_t column) {
    if (column == kFrame) return std::to_string(item.frame);
    if (column == kCommand) return std::to_string(item.command);
    const double values[] = {item.params[0],    item.params[1],     item.params[2], item.params[3],
                             item.latitude_deg, item.longitude_deg, item.altitude_m};
    return shortest(values[column - kParam1]);
}

Entry entryOf(const WaypointItem& from, Set set, size_t index, size_t count) {
    const auto byte = [](size_t n) { return static_cast<uint8_t>(std::min<size_t>(n, 0xFF)); };
    Entry entry;
    MissionItem item = itemOf(from);
    // the record of home in the 1.0 set has no room for its frame; it is above the sea in any case
    if (set == Set::apm1 && index == 0) {
        item.frame = firmware::state::parameters.altitude_absolute != 0 ? kAboveSea : kAboveHome;
    }
    firmware::mission::EncodeWarnings warnings = {};
    entry.result =
        firmware::mission::encodeItem(set, {byte(index), byte(count)}, item, entry.record, warnings);
    if (entry.result == MissionResult::accepted) {
        entry.result = check(set, index, count, entry);
    } else {
        // what can be said of it although it has no record
        entry.record.id = firmware::mission::idOf(from.command);
        if (entry.record.id == mission::kNoId) entry.command = from.command;
        entry.row = firmware::mission::kCommandTable.find(set, entry.record.id);
    }
    if (warnings.rounded) entry.notes.push_back("a value is rounded to what the record can hold");
    if (warnings.dropped)
        entry.notes.push_back("a parameter that the command does not use is dropped");
    entry.line = from.line;
    entry.column = from.columns[0];
    return entry;
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

// The items as entries; `found`: gives the word that is refused in this column. Throws WrongInput
// for what could not be read.
template <class Found>
void fill(Document& document, simulator::MissionFile& mission, Found found) {
    std::vector<LineProblem> problems;
    for (const auto& error : mission.errors)
        problems.push_back({error.line, error.column, error.text});
    const size_t count = mission.items.size();
    for (size_t i = 0; i < count; ++i) {
        WaypointItem& item = mission.items[i];
        Entry entry = entryOf(item, document.set, i, count);
        if (entry.result != MissionResult::accepted) {
            const std::string word = found(item, entry, columnOf(entry.result));
            entry.problem = expected(expectation(document.set, entry), word);
        }
        document.entries.push_back(entry);
        if (item.readable && !entry.good())
            problems.push_back({entry.line, entry.column, document.at(i, entry.problem)});
    }
    if (!mission.errors.empty()) throwProblems(problems);
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

std::vector<MissionItem> itemsOf(const Document& document) {
    std::vector<MissionItem> items(document.entries.size());
    for (size_t i = 0; i < items.size(); ++i)
        firmware::mission::decodeItem(document.set, static_cast<uint8_t>(i),
                                      document.entries[i].record, items[i]);
    return items;
}

struct Nearest {
    uint8_t id;  // of the 1.0 set
    uint16_t command;
};
// MAV_CMD; DO_SET_PARAMETER for what sets a gain, a channel, or reports a parameter.
constexpr uint16_t kSetParameter = 180, kChangeSpeed = 178;
constexpr uint8_t kCruiseAirspeed = 0x40, kFirstNotNav = 0x20;
constexpr Nearest kNearest[] = {
    {0x20, 112}, {0x21, 113}, {0x30, 176}, {0x31, 177}, {kCruiseAirspeed, kChangeSpeed},
    {0x41, kChangeSpeed}, {0x42, 179}, {0x75, 177}, {0x80, 184}, {0x81, 181}, {0x82, 183},
};

MissionItem nearest(const MissionItem& from) {
    if (from.command < kFirstNotNav) return from;
    MissionItem item = {};
    item.command = kSetParameter;
    for (const Nearest& each : kNearest)
        if (each.id == from.command) item.command = each.command;
    if (item.command == kChangeSpeed)
        item.param2 = from.command == kCruiseAirspeed ? from.param1 : -1;
    return item;
}

// As short as a float may be written.
double asWritten(float value) { return std::isfinite(value) ? std::strtod(shortest(value).c_str(), nullptr) : value; }

WaypointItem fileItemOf(const MissionItem& from) {
    WaypointItem item;
    item.command = from.command;
    item.frame = from.frame;
    item.params = {asWritten(from.param1), asWritten(from.param2), asWritten(from.param3),
                   asWritten(from.param4)};
    item.latitude_deg = from.x / 1e7;
    item.longitude_deg = from.y / 1e7;
    item.altitude_m = asWritten(from.z);
    return item;
}

// Does reading give the document's records again?
template <class Parse>
bool readBack(const Document& document, Parse parse) {
    try {
        const Document again = parse();
        for (const Entry& entry : again.entries)
            if (!entry.good()) return false;
        return sameRecords(document, again);
    } catch (const WrongInput&) {
        return false;
    }
}

}  // namespace

bool looksLikeWaypoints(const std::string& contents) { return contents.rfind("QGC", 0) == 0; }

Document parseWaypointFile(const std::string& contents, const std::string& name, Set set) {
    auto [items, errors] = simulator::readWaypointLines(contents, name);
    simulator::MissionFile mission;
    mission.items = std::move(items);
    mission.errors = std::move(errors);
    Document document;
    document.name = name;
    document.set = set;
    fill(document, mission, [&](WaypointItem& item, Entry& entry, size_t column) {
        entry.column = item.columns[column];
        return wordAt(contents, item, entry.column);
    });
    return document;
}

Document parsePlan(const std::string& contents, const std::string& name, Set set) {
    simulator::MissionFile mission = simulator::readPlan(contents, name);
    Document document;
    document.name = name;
    document.set = set;
    document.names_items = true;
    fill(document, mission, [](const WaypointItem& item, const Entry&, size_t column) {
        return valueOf(item, column);
    });
    document.fence = mission.fence;
    document.rally = mission.rally;
    document.remarks = mission.remarks;
    return document;
}

std::string itemsAsWaypoints(const std::vector<MissionItem>& items) {
    std::string text = std::string(kHeader) + '\n';
    for (size_t i = 0; i < items.size(); ++i) text += lineOf(i, items[i]);
    return text;
}

std::string placesOf(const Document& document) {
    std::vector<MissionItem> items = itemsOf(document);
    for (MissionItem& item : items) item = nearest(item);
    return itemsAsWaypoints(items);
}

std::string recordsAsWaypoints(const Document& document) {
    if (document.set != Set::apm2) return "";
    const std::string text = itemsAsWaypoints(itemsOf(document));
    return readBack(document, [&] { return parseWaypointFile(text, document.name, document.set); })
               ? text
               : "";
}

std::string recordsAsPlan(const Document& document) {
    if (document.set != Set::apm2) return "";
    simulator::MissionFile mission;
    for (const MissionItem& item : itemsOf(document)) mission.items.push_back(fileItemOf(item));
    mission.fence = document.fence;
    mission.rally = document.rally;
    const std::string text =
        simulator::planOf(mission, firmware::state::parameters.cruise_speed_cms * 0.01);
    return readBack(document, [&] { return parsePlan(text, document.name, document.set); }) ? text
                                                                                            : "";
}

}  // namespace mission_tool
