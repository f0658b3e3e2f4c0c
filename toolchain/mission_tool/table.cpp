// SPDX-License-Identifier: GPL-3.0-or-later
#include "toolchain/mission_tool/table.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>

#include "firmware/mission/command_table.hpp"
#include "toolchain/mission_tool/board.hpp"
#include "toolchain/mission_tool/findings.hpp"
#include "toolchain/mission_tool/legs.hpp"

namespace mission_tool {
namespace {

using mission::Class;

constexpr size_t kColumns = 8;
using Line = std::array<std::string, kColumns>;

template <class... Values>
std::string format(const char* how, Values... values) {
    char text[80];
    std::snprintf(text, sizeof text, how, values...);
    return text;
}

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

Line lineOf(const Document& document, size_t index, const Leg& leg, size_t nav) {
    const Entry& entry = document.entries[index];
    const bool alone = index == 0 || entry.is(Class::nav) || !entry.good();
    return {std::to_string(index),
            classOf(index, entry),
            index == 0 ? "" : commandOf(entry),
            alone      ? ""
            : nav == 0 ? "never run"
                       : std::to_string(nav),
            altitudeOf(document, index),
            leg.known ? format("%s%.0f m", leg.about ? "~" : "", static_cast<double>(leg.length_m))
                      : "",
            leg.known ? format("%03ld", static_cast<long>((leg.bearing_cd + 50) / 100 % 360)) : "",
            valuesOf(document, index)};
}

std::string aligned(const std::vector<Line>& lines) {
    constexpr bool kRight[kColumns] = {true, false, false, false, true, true, true, false};
    std::array<size_t, kColumns> widths{};
    for (const Line& line : lines)
        for (size_t c = 0; c < kColumns; ++c) widths[c] = std::max(widths[c], line[c].size());
    std::string text;
    for (const Line& line : lines) {
        std::string row;
        for (size_t c = 0; c < kColumns; ++c) {
            const std::string space(widths[c] - line[c].size(), ' ');
            row += (c == 0 ? "" : "  ") + (kRight[c] ? space + line[c] : line[c] + space);
        }
        row.erase(row.find_last_not_of(' ') + 1);
        text += row + '\n';
    }
    return text;
}

std::string summaryOf(const Document& document, const std::vector<Leg>& legs) {
    double length_m = 0;
    for (const Leg& leg : legs) length_m += static_cast<double>(leg.length_m);
    return format("%s set, %zu of %zu items, legs of %.1f km in all",
                  document.set == mission::Set::apm1 ? "APM 1.0" : "APM 2.0",
                  document.entries.size(), kMaxItems, length_m / 1000);
}

}  // namespace

std::string tableOf(const Document& document) {
    const std::vector<Leg> legs = legsOf(document);
    const std::vector<size_t> navs = accompaniedNavs(document);
    std::vector<Line> lines = {
        {"item", "class", "command", "beside NAV", "altitude", "leg", "bearing", "values"}};
    for (size_t i = 0; i < legs.size(); ++i) lines.push_back(lineOf(document, i, legs[i], navs[i]));
    std::string text = aligned(lines) + '\n' + summaryOf(document, legs) + '\n';
    if (std::any_of(legs.begin(), legs.end(), [](const Leg& leg) { return leg.about; }))
        text += "~ begins wherever the airplane is; reckoned from the place known last\n";
    return text;
}

}  // namespace mission_tool
