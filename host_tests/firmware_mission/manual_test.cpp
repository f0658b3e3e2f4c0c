// SPDX-License-Identifier: GPL-3.0-or-later
// The manual's list of commands is the table's. On a difference the right list is printed.
#include <fstream>
#include <sstream>

#include "rig.hpp"

namespace firmware {
namespace {

std::string manual() {
    std::string path = __FILE__;
    path.resize(path.rfind("host_tests/"));
    std::ifstream file(path + "docs/mission.md");
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

std::string id(mission::Set set, uint8_t row) {
    const uint8_t number = kCommandTable.id(set, row);
    if (number == mission::kNoId) return "";
    char text[20];
    snprintf(text, sizeof text, "0x%02X (%d)", number, number);
    return text;
}

std::string rowsAsTable() {
    const char* const kinds[] = {"NAV", "CONDITION", "DO", "jump"};
    std::string table =
        "| command | APM 2.0 | APM 1.0 | class | |\n| --- | --- | --- | --- | --- |\n";
    for (uint8_t row = 0; row < kCommandTable.count; ++row) {
        const uint8_t traits = kCommandTable.traits(row);
        std::string notes;
        const auto note = [&](uint8_t trait, const char* text) {
            if ((traits & trait) != 0) notes += (notes.empty() ? "" : "; ") + std::string(text);
        };
        note(mission::kPlaced, "0, 0 is here");
        note(mission::kEndsFlight, "ends a flight");
        note(mission::kBeginsFlight, "begins a flight");
        note(mission::kEndsNowhere, "the next leg begins at the airplane");
        table += "| " + std::string(kCommandTable.rows[row].name) + " | " +
                 id(mission::Set::apm2, row) + " | " + id(mission::Set::apm1, row) + " | " +
                 kinds[static_cast<uint8_t>(kCommandTable.kind(row))] + " | " + notes + " |\n";
    }
    return table;
}

std::string part(const std::string& text, const std::string& from, const std::string& to) {
    const size_t begin = text.find(from) + from.size();
    return text.substr(begin, text.find(to, begin) - begin);
}

TEST(MissionManual, lists_the_commands_of_the_table) {
    const std::string listed = part(manual(), "<!-- rows begin -->\n", "<!-- rows end -->");
    EXPECT_EQ(listed, rowsAsTable());
}

TEST(MissionManual, explains_the_parameters_of_every_command_of_both_sets) {
    const std::string text = manual();
    const std::string apm2 = part(text, "## Parameters of the APM 2.0 set", "## Parameters of the");
    const std::string apm1 = part(text, "## Parameters of the APM 1.0 set", "## Events");
    for (uint8_t row = 0; row < kCommandTable.count; ++row) {
        const std::string name = kCommandTable.rows[row].name;
        for (mission::Set set : {mission::Set::apm1, mission::Set::apm2}) {
            const std::string number = id(set, row);
            if (number.empty()) continue;
            const std::string line = "| " + number.substr(0, 4) + " | " + name + " |";
            EXPECT_NE((set == mission::Set::apm1 ? apm1 : apm2).find(line), std::string::npos)
                << line;
        }
    }
}

}  // namespace
}  // namespace firmware
