// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of docs/mission.md are written from the command table, the ranges and the items of
// the code itself. MANUAL=write in the environment writes them anew.
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "mission_rig.hpp"
#include "samples.hpp"

namespace firmware {
using namespace mission;
namespace {

using ::mission::Set;

std::string manualPath() {
    std::string path = __FILE__;
    path.resize(path.rfind("host_tests/"));
    return path + "docs/mission.md";
}

class MissionManual : public Rig {
protected:
    // The part of the manual between the two marks is this.
    static void expectPart(const std::string& name, const std::string& right) {
        std::ifstream file(manualPath());
        std::stringstream text;
        text << file.rdbuf();
        std::string manual = text.str();
        const std::string from = "<!-- " + name + " begin -->\n", to = "<!-- " + name + " end -->";
        const size_t begin = manual.find(from), end = manual.find(to);
        ASSERT_TRUE(begin != std::string::npos && end != std::string::npos) << name;
        const size_t at = begin + from.size();
        const std::string listed = manual.substr(at, end - at);
        const char* value = std::getenv("MANUAL");
        if (value != nullptr && std::string(value) == "write") {
            manual.replace(at, end - at, right);
            std::ofstream(manualPath()) << manual;
            return;
        }
        EXPECT_EQ(listed, right) << "MANUAL=write firmware_mission_test writes it anew";
    }
};

std::string hex(uint8_t id) {
    char text[8];
    snprintf(text, sizeof text, "0x%02X", id);
    return text;
}

std::string idOf(Set set, uint8_t row) {
    const uint8_t number = kCommandTable.id(set, row);
    return number == ::mission::kNoId ? "" : hex(number) + " (" + std::to_string(number) + ")";
}

// Those of the two documents, or those beyond them.
std::string rowsAsTable(uint8_t beyond) {
    const char* const kinds[] = {"NAV", "CONDITION", "DO", "jump"};
    std::string table =
        "| command | APM 2.0 | APM 1.0 | class | |\n| --- | --- | --- | --- | --- |\n";
    for (uint8_t row = 0; row < kCommandTable.count; ++row) {
        const uint8_t traits = kCommandTable.traits(row);
        if ((traits & ::mission::kArduPlaneExtension) != beyond) continue;
        std::string notes;
        const auto note = [&](uint8_t trait, const char* text) {
            if ((traits & trait) != 0) notes += (notes.empty() ? "" : "; ") + std::string(text);
        };
        note(::mission::kPlaced, "0, 0 is here");
        note(::mission::kEndsFlight, "ends a flight");
        note(::mission::kBeginsFlight, "begins a flight");
        note(::mission::kEndsNowhere, "the next leg begins at the airplane");
        table += "| " + std::string(commandName(row)) + " | " + idOf(kSet2, row) + " | " +
                 idOf(kSet1, row) + " | " + kinds[static_cast<uint8_t>(kCommandTable.kind(row))] +
                 " | " + notes + " |\n";
    }
    return table;
}

// 900000000 as 900,000,000
std::string number(int64_t value) {
    std::string digits = std::to_string(value < 0 ? -value : value);
    for (size_t at = digits.size(); at > 3; at -= 3) digits.insert(at - 3, ",");
    return (value < 0 ? "-" : "") + digits;
}

std::string rangesAsText(Set set, const ::mission::Record& sample, int field) {
    const Interval room = roomOf(set, field);
    std::string text;
    for (const Interval& each : rangesOf(set, sample, field)) {
        text += text.empty() ? "" : ", ";
        if (each.highest == each.lowest + 1)
            text += number(each.lowest) + ", " + number(each.highest);
        else if (each.lowest == each.highest)
            text += number(each.lowest);
        else if (each.lowest < 0 && each.lowest == -each.highest)
            text += "±" + number(each.highest);
        else if (each.highest == room.highest && each.lowest == room.lowest && field != 1)
            text += "any";
        else if (each.highest == room.highest && field != 1)
            text += "from " + number(each.lowest);
        else
            text += number(each.lowest) + " to " + number(each.highest);
    }
    return text;
}

// Slots have gaps, and what a slot or a gain takes is its parameter's own range.
std::string rangeCell(Set set, const ::mission::Record& sample, int field) {
    const bool gain = set == kSet1 && sample.id >= 0x60 && sample.id <= 0x64;
    const bool slot = set == kSet2 ? sample.id == 0xB4 : sample.id == 0x32 || sample.id == 0x33;
    if (field == 1 && gain) return "those below";
    if (field == 1 && slot) return "those in use";
    const bool value = gain || (slot && set == kSet2) || (set == kSet1 && sample.id == 0x73);
    if (field > 1 && value) return "the parameter's";
    return rangesAsText(set, sample, field);
}

// What of an item a field comes from: the part that is another when the field is one more.
std::string sourceOf(Set set, const ::mission::Record& sample, int field) {
    ::mission::Record one = sample;
    if (set == kSet2 && field > 2 && sample.id == 0x71) one = with(one, field, 450);
    if (set == kSet2 && field > 2 && sample.id == 0xCE) one = with(one, field, 1250);
    if (set == kSet2 && field > 3 && sample.id == 0xB2) one = with(one, field, 1250);
    const int32_t before[] = {0, one.p1, one.p2, one.p3, one.p4};
    ::mission::Record other = with(one, field, before[field] + 1);
    MissionItem a, b;
    decodeItem(set, kSamplePosition.index, one, a);
    decodeItem(set, kSamplePosition.index, other, b);
    const struct {
        const char* name;
        double by;
    } parts[] = {{"param1", double(b.param1) - a.param1},
                 {"param2", double(b.param2) - a.param2},
                 {"param3", double(b.param3) - a.param3},
                 {"param4", double(b.param4) - a.param4},
                 {"x", double(b.x) - a.x},
                 {"y", double(b.y) - a.y},
                 {"z", double(b.z) - a.z}};
    std::string from;
    for (const auto& part : parts) {
        if (part.by == 0) continue;
        from += (from.empty() ? "" : " and ") + std::string(part.name);
        if (std::abs(part.by - 0.01) < 1e-4)
            from += " × 100";
        else if (part.by != 1)
            from += part.by > 1 ? " / " + std::to_string(std::lround(part.by)) : ", its bits";
    }
    return from;
}

std::string cell(Set set, const ::mission::Record& sample, int field, const char* meaning) {
    const std::string from = sourceOf(set, sample, field);
    const Intervals ranges = rangesOf(set, sample, field);
    if (meaning == nullptr) {
        EXPECT_FALSE(restricted(set, ranges, field)) << hex(sample.id) << " p" << field;
        EXPECT_TRUE(from.empty() || set == kSet1) << hex(sample.id) << " p" << field;
        return "";
    }
    EXPECT_NE(from, "") << hex(sample.id) << " p" << field;
    return std::string(meaning) + " (" + rangeCell(set, sample, field) + ") ← " + from;
}

std::string fieldsAsTable(Set set, uint8_t beyond) {
    std::string table =
        "| id | command | p1 | p2 | p3 | p4 | |\n| --- | --- | --- | --- | --- | --- | --- |\n";
    for (uint8_t row = 0; row < kCommandTable.count; ++row) {
        const uint8_t id = kCommandTable.id(set, row);
        if (id == ::mission::kNoId ||
            (kCommandTable.traits(row) & ::mission::kArduPlaneExtension) != beyond)
            continue;
        const Sample sample = commandOf(set, id);
        EXPECT_NE(sample.does, nullptr) << hex(id);
        if (sample.does == nullptr) continue;
        table += "| " + hex(id) + " | " + commandName(row);
        for (int field = 1; field <= 4; ++field)
            table += " | " + cell(set, sample.record, field, sample.field[field - 1]);
        table += " | " + std::string(sample.does) + " |\n";
    }
    return table;
}

// What stands where a gain has no counterpart.
std::string whyRefused(uint8_t id, uint8_t index) {
    constexpr uint8_t kKp = 0x60, kFeedForward = 0x64, kNavRoll = 3;
    if (id == kFeedForward) return "refused: throttle follows the energy that is demanded";
    if (index == kNavRoll)
        return id == kKp ? "refused: a time instead, NAVL1_PERIOD" : "refused: no integrator";
    return id == kKp ? "refused: a time instead, TECS_TIME_CONST"
                     : "refused: limited by the limits of pitch and throttle";
}

std::string partOf(uint8_t id, uint8_t index) {
    const uint8_t slot = gainSlot(id, index);
    return slot == kNoSlot ? whyRefused(id, index) : nameOfSlot(slot);
}

std::string gainsAsTable() {
    const char* const parts[] = {"servo roll",
                                 "servo pitch",
                                 "servo rudder",
                                 "nav roll",
                                 "nav pitch by airspeed",
                                 "nav pitch by altitude",
                                 "throttle by total energy",
                                 "throttle by altitude"};
    const char* const feedforward[] = {"pitch compensation", "rudder mix", "pitch to throttle"};
    std::string table =
        "| index | Kp | Ki | Kd | integrator max |\n| --- | --- | --- | --- | --- |\n";
    for (uint8_t index = 0; index < 8; ++index) {
        table += "| " + std::to_string(index) + " " + parts[index] + " |";
        for (uint8_t id = 0x60; id <= 0x63; ++id) table += " " + partOf(id, index) + " |";
        table += "\n";
    }
    table += "\n| index | Kff |\n| --- | --- |\n";
    for (uint8_t index = 0; index < 3; ++index)
        table += "| " + std::to_string(index) + " " + feedforward[index] + " | " +
                 partOf(0x64, index) + " |\n";
    return table;
}

TEST_F(MissionManual, lists_the_commands_of_the_table) {
    expectPart("rows", rowsAsTable(0));
    expectPart("beyond rows", rowsAsTable(::mission::kArduPlaneExtension));
}

TEST_F(MissionManual, has_meaning_range_and_origin_of_every_field_of_apm2) {
    expectPart("apm2", fieldsAsTable(kSet2, 0));
    expectPart("beyond", fieldsAsTable(kSet2, ::mission::kArduPlaneExtension));
}

TEST_F(MissionManual, has_meaning_range_and_origin_of_every_field_of_apm1) {
    expectPart("apm1", fieldsAsTable(kSet1, 0));
}

TEST_F(MissionManual, lists_the_parameters_that_the_gains_go_to) {
    expectPart("gains", gainsAsTable());
}

}  // namespace
}  // namespace firmware
