// SPDX-License-Identifier: GPL-3.0-or-later
#include "toolchain/mission_tool/table.hpp"

#include <algorithm>

#include "core/crc.hpp"
#include "firmware/mission/command_table.hpp"
#include "storage/lists.hpp"
#include "toolchain/mission_tool/board.hpp"
#include "toolchain/mission_tool/columns.hpp"
#include "toolchain/mission_tool/findings.hpp"
#include "toolchain/mission_tool/flight_order.hpp"
#include "toolchain/mission_tool/legs.hpp"

namespace mission_tool {
namespace {

using mission::Class;

std::string classOf(size_t index, const Entry& entry) {
    constexpr const char* kNames[] = {"NAV", "CONDITION", "DO", "jump"};
    if (index == 0) return "home";
    if (entry.row == mission::kNoRow) return "?";
    return kNames[static_cast<uint8_t>(firmware::mission::kCommandTable.kind(entry.row))];
}

std::string commandOf(const Entry& entry) {
    if (entry.row != mission::kNoRow) return nameOf(entry);
    return entry.command != 0 ? std::to_string(entry.command) : format("0x%02X", entry.record.id);
}

bool hasAltitude(const Document& document, size_t index) {
    const Entry& entry = document.entries[index];
    if (index == 0 || entry.is(Class::nav)) return true;
    const uint8_t id = entry.record.id;
    return document.set == mission::Set::apm1 ? id == 0x21 || id == 0x42 : id == 0x71 || id == 0xB3;
}

std::string altitudeOf(const Document& document, size_t index) {
    constexpr uint8_t kReturn = 0x14;
    if (!hasAltitude(document, index)) return "";
    const mission::Record& record = document.entries[index].record;
    if (index > 0 && record.id == kReturn && record.p2 == 0) return "ALT_HOLD_RTL";
    return format("%.2f m %s", record.p2 / 100.0,
                  aboveHome(document, index) ? "above home" : "above sea");
}

std::string degrees(int32_t e7) { return format("%.7f", e7 * 1e-7); }

std::string valuesOf(const Document& document, size_t index) {
    const Entry& entry = document.entries[index];
    const mission::Record& record = entry.record;
    const bool placed = index == 0 || hasPlace(entry);
    std::string text;
    const auto add = [&text](const std::string& value) {
        text += (text.empty() ? "" : " ") + value;
    };
    if (record.p1 != 0) add("p1 " + std::to_string(record.p1));
    if (record.p2 != 0 && !hasAltitude(document, index)) add("p2 " + std::to_string(record.p2));
    if (placed)
        return text + (text.empty() ? "" : " ") + degrees(record.p3) + " " + degrees(record.p4);
    if (record.p3 != 0) add("p3 " + std::to_string(record.p3));
    if (record.p4 != 0) add("p4 " + std::to_string(record.p4));
    if (text.empty() && entry.is(Class::nav) && document.set == mission::Set::apm2 &&
        (firmware::mission::kCommandTable.traits(entry.row) & mission::kPlaced) != 0)
        return "here";
    return text;
}

// The NAVs that it is flown beside; in brackets the one that it stands beside and is not reached.
std::string besideOf(const std::vector<size_t>& flown, size_t written) {
    std::string text;
    for (const size_t nav : flown) text += (text.empty() ? "" : ", ") + (nav == 0 ? "the end" : std::to_string(nav));
    if (!text.empty()) return text;
    return written == 0 ? "never run" : '(' + std::to_string(written) + ')';
}

Cells lineOf(const Document& document, size_t index, const Leg& leg, const std::string& beside) {
    const Entry& entry = document.entries[index];
    const bool alone = index == 0 || entry.is(Class::nav) || !entry.good();
    return {std::to_string(index),
            classOf(index, entry),
            index == 0 ? "" : commandOf(entry),
            alone ? "" : beside,
            altitudeOf(document, index),
            leg.known ? format("%s%.0f m", leg.about ? "~" : "", static_cast<double>(leg.length_m))
                      : "",
            leg.known ? format("%03ld", static_cast<long>((leg.bearing_cd + 50) / 100 % 360)) : "",
            valuesOf(document, index)};
}

// What the board answers as opaque_id once it has stored this.
std::string idOf(const Document& document) {
    uint16_t crc = core::kCrcStart;
    for (const Entry& entry : document.entries) {
        if (!entry.good()) return "none: not all items can be stored";
        uint8_t bytes[mission::kRecordSize];
        mission::pack(document.set, entry.record, bytes);
        crc = core::crc16(crc, bytes, sizeof bytes);
    }
    return format("%lu", static_cast<unsigned long>(storage::listId(
                             static_cast<uint8_t>(document.set),
                             static_cast<uint8_t>(document.entries.size()), crc)));
}

std::string summaryOf(const Document& document, const std::vector<Leg>& legs) {
    double length_m = 0;
    for (const Leg& leg : legs) length_m += static_cast<double>(leg.length_m);
    return format("%s set, %zu of %zu items, legs of %.1f km in all, id ",
                  document.set == mission::Set::apm1 ? "APM 1.0" : "APM 2.0",
                  document.entries.size(), kMaxItems, length_m / 1000) +
           idOf(document);
}

}  // namespace

std::string tableOf(const Document& document) {
    const std::vector<Leg> legs = legsOf(document);
    const std::vector<size_t> navs = accompaniedNavs(document);
    const FlightOrder order = flightOrder(document);
    const auto flown = flownBeside(document, order);
    std::vector<Cells> lines = {
        {"item", "class", "command", "beside NAV", "altitude", "leg", "bearing", "values"}};
    for (size_t i = 0; i < legs.size(); ++i) {
        const std::string beside = order.visits.empty() && navs[i] != 0
                                       ? std::to_string(navs[i])
                                       : besideOf(flown[i], navs[i]);
        lines.push_back(lineOf(document, i, legs[i], beside));
    }
    std::string text =
        inColumns(lines, {true, false, false, false, true, true, true, false}) + '\n' +
        summaryOf(document, legs) + '\n';
    if (std::any_of(legs.begin(), legs.end(), [](const Leg& leg) { return leg.about; }))
        text += "~ begins wherever the airplane is; reckoned from the place known last\n";
    return text;
}

}  // namespace mission_tool
