// SPDX-License-Identifier: GPL-3.0-or-later
// Wrong input: named by file, line and column, with what was expected there.
#include <cmath>

#include "firmware/mission/command_table.hpp"
#include "firmware/mission/forms.hpp"
#include "mission_tool_rig.hpp"

namespace mission_tool {
namespace {

using firmware::mission::MissionResult;
using mission::Set;
using testing::HasSubstr;

class Errors : public Tool {};

TEST(Refusals, name_file_line_column_and_what_was_expected) {
    const struct {
        const char *item, *refusal;
    } cases[] = {
        {"3 202 0 0 0 0 0 0 0", "m:4:7: expected a command of the APM 2.0 set, found '202'"},
        {"10 16 0 0 0 0 47 8 9",
         "m:4:5: expected an altitude above the sea or above home, not "
         "above terrain, found '10'"},
        {"3 181 0 9 0 0 0 0 0", "m:4:13: expected 0 or 1, found '9'"},
        {"3 177 2 1 0 0 0 0 0",
         "m:4:11: expected an item of this mission, not home and not itself, "
         "found '2': it jumps to itself"},
        {"3 16 0 0 0 0 47 8 90000",
         "m:4:23: expected an altitude of -83886.08 to 83886.07 m, "
         "found '90000'"},
        {"3 16 x 0 0 0 47 8 9", "m:4:10: expected a number as parameter, found 'x'"},
    };
    for (const auto& row : cases) EXPECT_EQ(refusalOf(between(row.item)), row.refusal);
}

TEST(Refusals, of_the_text_form_stand_at_the_field_that_holds_the_value) {
    const struct {
        const char *line, *refusal;
    } cases[] = {
        {"0x81 9 0 0 0", "m:3:6: expected 0 or 1, found '9'"},
        {"0xC9 0 0 0 0", "m:3:1: expected a command of the APM 1.0 set, found '0xC9'"},
        {"0x10 0 0 900000001 0",
         "m:3:10: expected a latitude of -900000000 to 900000000, "
         "found '900000001'"},
        {"0x31 0 0 0 0",
         "m:3:1: expected a command that can stand here, found '0x31': it jumps to "
         "itself"},
        {"0x70 1 99 0 0", "m:3:8: expected 800 to 2200 us, found '99'"},
        {"zz 0 0 0 0", "m:3:1: expected the id of a command, 0x00 to 0xFF, found 'zz'"},
        {"0x10 256 0 0 0", "m:3:6: expected p1, 0 to 255, found '256'"},
        {"0x10 0 0 0", "m:3:11: expected p4, -2147483648 to 2147483647, found the end of the line"},
        {"0x10 0 0 0 0 0", "m:3:14: expected the end of the line, found '0'"},
        {"0x10 0 2147483648 0 0",
         "m:3:8: expected p2, -2147483648 to 2147483647, found "
         "'2147483648'"},
    };
    for (const auto& row : cases) EXPECT_EQ(refusalOf(apm1(row.line)), row.refusal);
}

TEST(Refusals, a_file_of_no_known_kind_is_refused_with_the_kinds_there_are) {
    EXPECT_EQ(
        refusalOf("hello\n"),
        "m:1:1: expected 'QGC WPL 110', a .plan, 'APM 1.0', 'APM 2.0', Intel hex or a 4096-byte "
        "image, found 'hello'");
    EXPECT_EQ(refusalOf(""), "m: the file is empty");
    EXPECT_EQ(refusalOf(" \n\n"), "m: the file is empty");
    EXPECT_EQ(refusalOf(std::string("\x7f"
                                    "ELF\0\1",
                                    6)),
              "m: not a text file");
    EXPECT_THAT(refusalOf("\x1b]0;x\x07\n"), HasSubstr("found '?]0;x?'"));
    EXPECT_EQ(refusalOf("APM 3.0\n"), "m:1:1: expected 'APM 1.0' or 'APM 2.0', found 'APM 3.0'");
    EXPECT_EQ(refusalOf("APM 1.0\n# nothing\n"),
              "m:3:1: expected a command: home comes first, found the end of the line");
}

TEST(Refusals, of_intel_hex_name_the_byte) {
    EXPECT_EQ(refusalOf(":00000001FE\n"), "m:1:10: expected the line's checksum, found 'FE'");
    EXPECT_EQ(refusalOf(":0000000G\n"), "m:1:8: expected two hex digits, found '0G'");
    EXPECT_EQ(refusalOf(":01100000FFF0\n:00000001FF\n"),
              "m:1:4: expected an address within 4096 bytes, found '10'");
    EXPECT_EQ(refusalOf(":01000000FF00\n"),
              "m:2:1: expected the end record ':00000001FF', found the end of the line");
}

// Whatever the firmware refuses has words of its own; the table of words is complete.
TEST(Refusals, every_parameter_that_the_firmware_refuses_has_its_expectation) {
    powerUp(blankImage());
    for (const Set set : {Set::apm1, Set::apm2})
        for (uint8_t row = 0; row < firmware::mission::kCommandTable.count; ++row) {
            const uint8_t id = firmware::mission::kCommandTable.id(set, row);
            if (id == mission::kNoId) continue;
            for (const int32_t wild : {-2000000000, -7, 7, 77, 9999, 8000000, 2000000000})
                for (int field = 0; field < 4; ++field) {
                    Entry entry;
                    int32_t values[] = {1, 1000, 1, 0};
                    values[field] = wild;
                    entry.record = {id,        0,         static_cast<uint8_t>(values[0]),
                                    values[1], values[2], values[3]};
                    if (check(set, 2, 9, entry) == MissionResult::accepted) continue;
                    EXPECT_THAT(expectation(set, entry), Not(HasSubstr("docs/mission.md")))
                        << int(id) << " field " << field + 1 << " = " << wild;
                }
        }
}

TEST_F(Errors, are_all_reported_at_once) {
    const std::string mission =
        file("m", apm1("0x81 9 0 0 0\n0xC9 0 0 0 0\n0x10 0 6000 470000000 80000000\n"));
    EXPECT_EQ(tool({"check", mission}), 1);
    EXPECT_THAT(err_, HasSubstr(mission + ":3:6: expected 0 or 1"));
    EXPECT_THAT(err_, HasSubstr(mission + ":4:1: expected a command"));
    EXPECT_EQ(tool({"compile", mission, "-o", path("x.eep")}), 1);
    EXPECT_FALSE(std::filesystem::exists(path("x.eep")));
}

TEST_F(Errors, of_syntax_and_of_meaning_are_reported_together_in_the_order_of_the_file) {
    EXPECT_EQ(refusalOf("QGC WPL 110\n0 1 0 16 0 0 0 0 47 8 400 1\n"
                        "1 0 3 202 0 0 0 0 47 8 9 1\n"
                        "2 0 3 16 x 0 0 0 east 8 9 1\n"
                        "3 0 3 181 0 9 0 0 0 0 0 1\n"),
              "m:3:7: expected a command of the APM 2.0 set, found '202'\n"
              "m:4:10: expected a number as parameter, found 'x'\n"
              "m:4:18: expected a latitude, -90 to 90 degrees, found 'east'\n"
              "m:5:13: expected 0 or 1, found '9'");
    EXPECT_EQ(refusalOf(apm1("0x81 9 0 0 0\nzz 0 0 0 0\n0x10 256 0 0 0\n0xC9 0 0 0 0\n")),
              "m:3:6: expected 0 or 1, found '9'\n"
              "m:4:1: expected the id of a command, 0x00 to 0xFF, found 'zz'\n"
              "m:5:6: expected p1, 0 to 255, found '256'\n"
              "m:6:1: expected a command of the APM 1.0 set, found '0xC9'");
}

TEST_F(Errors, are_fifty_at_most_and_a_count) {
    std::string lines;
    for (int i = 0; i < 70; ++i) lines += "0x81 9 0 0 0\n";
    EXPECT_EQ(tool({"check", file("m", apm1(lines))}), 1);
    EXPECT_THAT(err_, HasSubstr(":52:6: expected 0 or 1"));
    EXPECT_THAT(err_, Not(HasSubstr(":53:6: expected 0 or 1")));
    EXPECT_THAT(err_, testing::EndsWith("\nand 20 more\n"));
    EXPECT_EQ(tool({"check", file("n", apm1(lines + "zz 0 0 0 0\n"))}), 1);
    EXPECT_EQ(std::count(err_.begin(), err_.end(), '\n'), 51);
    EXPECT_THAT(err_, testing::EndsWith("\nand 21 more\n"));
}

// Both forms, as editors save them.
TEST_F(Errors, marks_and_line_ends_of_an_editor_are_none) {
    for (const std::string& plain :
         {std::string(kTwoWaypoints), apm1("0x10 0 6000 470000000 80000000\n")}) {
        std::string lines, little = "\xFF\xFE", big = "\xFE\xFF";
        for (const char letter : plain) {
            lines += letter == '\n' ? "\r\n" : std::string(1, letter);
            little += {letter, '\0'};
            big += {'\0', letter};
        }
        for (const std::string& saved : {lines, "\xEF\xBB\xBF" + lines, little, big}) {
            EXPECT_EQ(refusalOf(saved), "");
            EXPECT_EQ(compiled(saved), compiled(plain));
        }
    }
    EXPECT_EQ(refusalOf("\xEF\xBB\xBF"
                        "APM 1.0\r\nzz 0 0 0 0\r\n"),
              "m:2:1: expected the id of a command, 0x00 to 0xFF, found 'zz'");
}

// Also one that happens to be as long as an EEPROM.
TEST_F(Errors, a_marked_text_of_4096_bytes_is_no_image) {
    std::string text = "\xEF\xBB\xBF" + std::string(kTwoWaypoints);
    text += "#" + std::string(4096 - text.size() - 1, 'x');
    EXPECT_EQ(refusalOf(text), "");
}

TEST_F(Errors, of_writing_name_the_file_and_the_reason) {
    const std::string mission = file("m", kTwoWaypoints);
    std::filesystem::create_symlink("/dev/full", path("full.bin"));
    EXPECT_EQ(tool({"compile", mission, "-o", path("full.bin")}), 1);
    EXPECT_EQ(err_, path("full.bin") + ": cannot be written: No space left on device\n");
    std::filesystem::create_directories(path("folder.bin"));
    EXPECT_EQ(tool({"compile", mission, "-o", path("folder.bin")}), 1);
    EXPECT_EQ(err_, path("folder.bin") + ": cannot be written: Is a directory\n");
    EXPECT_EQ(tool({"check", path("folder.bin")}), 1);
    EXPECT_EQ(err_, path("folder.bin") + ": cannot be read\n");
}

TEST_F(Errors, more_counted_jumps_than_counters_are_refused) {
    std::string text = "APM 2.0\n0x10 0 0 0 470000000 80000000\n0x10 1 0 6000 470100000 80000000\n";
    for (int i = 0; i < 16; ++i) text += "0xB1 0 1 0 2 0\n";
    EXPECT_THAT(refusalOf(text), HasSubstr("expected at most 15 jumps with a count, found 16"));
}

TEST_F(Errors, the_command_line_is_answered_with_2_and_one_line) {
    EXPECT_EQ(tool({}), 2);
    EXPECT_EQ(tool({"fly", "x"}), 2);
    EXPECT_EQ(tool({"check"}), 2);
    EXPECT_EQ(tool({"compile", file("m", kTwoWaypoints)}), 2);
    EXPECT_EQ(tool({"check", path("m"), "--set", "apm3"}), 2);
    EXPECT_EQ(tool({"check", path("m"), "--records", "16"}), 2);
    EXPECT_EQ(std::count(err_.begin(), err_.end(), '\n'), 1) << err_;
}

TEST_F(Errors, of_reading_and_writing_files_are_reported) {
    EXPECT_EQ(tool({"check", path("none")}), 1);
    EXPECT_EQ(err_, path("none") + ": cannot be read\n");
    const std::string mission = file("m", kTwoWaypoints);
    EXPECT_EQ(tool({"compile", mission, "-o", path("x.txt")}), 1);
    EXPECT_THAT(err_, HasSubstr(".eep or .hex"));
    EXPECT_EQ(tool({"compile", mission, "-o", path("no/folder.eep")}), 1);
    EXPECT_THAT(err_, HasSubstr("cannot be written"));
    EXPECT_EQ(tool({"decode", mission}), 1);
    EXPECT_THAT(err_, HasSubstr("expected an image"));
    EXPECT_EQ(tool({"check", "--set", "apm1", file("t", "APM 2.0\n0x10 0 0 0 0 0\n")}), 1);
    EXPECT_THAT(err_, HasSubstr("--set"));
}

TEST_F(Errors, images_without_a_mission_of_ours_say_why) {
    EXPECT_THAT(refusalOf(rawOf(blankImage())), HasSubstr("no mission is stored"));
    EXPECT_THAT(refusalOf(std::string(4096, 'x')), HasSubstr("not an EEPROM of this firmware"));
    Image image = compiled(kTwoWaypoints);
    image[storage::kMission.begin + 20] ^= 1;
    EXPECT_THAT(refusalOf(rawOf(image)), HasSubstr("damaged"));
    image[4] ^= 1;  // one of the two marks
    EXPECT_THAT(refusalOf(rawOf(image)), HasSubstr("damaged"));
    image[8 + 4] ^= 1;
    EXPECT_THAT(refusalOf(rawOf(image)), HasSubstr("not an EEPROM of this firmware"));
}

// The airplane's own parameters set the ranges.
TEST_F(Errors, ranges_are_those_of_the_board_that_the_mission_is_for) {
    const std::string fast = file("m", between("3 178 0 40 -1 0 0 0 0"));
    EXPECT_EQ(tool({"check", fast}), 1);
    Image board = compiled(kTwoWaypoints);
    const float highest = 60;
    for (uint16_t slot = 0; slot < 255; ++slot) {
        Image changed = board;
        std::memcpy(&changed[storage::parameterAddress(slot)], &highest, sizeof highest);
        const std::string onto = file("onto.bin", rawOf(changed));
        if (tool({"check", "--onto", onto, fast}) == 0) return;
    }
    FAIL() << "no parameter lets 40 m/s pass";
}

}  // namespace
}  // namespace mission_tool
