// SPDX-License-Identifier: GPL-3.0-or-later
#include "rig.hpp"

namespace param_tool {
namespace {

using testing::HasSubstr;

TEST_F(ParamTool, takes_the_dialects_of_mission_planner_and_mavproxy) {
    for (const char* text : {"WP_RADIUS,42\n", "WP_RADIUS 42\n", "WP_RADIUS        42.000000\n",
                             "WP_RADIUS\t42", "#NOTE: a plane\r\nWP_RADIUS,42\r\n",
                             "  WP_RADIUS , 42  # metres\n", "\n\n# nothing\nWP_RADIUS,+4.2e1\n"}) {
        EXPECT_EQ(errorsOf(text), "") << text;
        EXPECT_EQ(status_, 0) << text;
        EXPECT_THAT(out_, HasSubstr("the firmware takes it"));
        ASSERT_EQ(param({"compile", path("f.param"), "-o", path("f.bin")}), 0);
        EXPECT_EQ(valueIn(path("f.bin"), "WP_RADIUS"), "42") << text;
    }
}

TEST_F(ParamTool, says_where_it_is_wrong_and_what_was_expected) {
    struct Row {
        const char *text, *errors;
    };
    constexpr Row kRows[] = {
        {"WP_RADIUS\n",
         "f.param:1:10: expected a number behind the name, found the end of the line"},
        {"WP_RADIUS,\n",
         "f.param:1:11: expected a number behind the name, found the end of the line"},
        {"\nWP_RADIUS,x4\n", "f.param:2:11: expected a finite decimal number, found 'x4'"},
        {"WP_RADIUS,4x\n", "f.param:1:11: expected a finite decimal number, found '4x'"},
        {"WP_RADIUS,nan\n", "f.param:1:11: expected a finite decimal number, found 'nan'"},
        {"WP_RADIUS,-inf\n", "f.param:1:11: expected a finite decimal number, found '-inf'"},
        {"WP_RADIUS,0x10\n", "f.param:1:11: expected a finite decimal number, found '0x10'"},
        {"WP_RADIUS,1e999\n", "f.param:1:11: expected a finite decimal number, found '1e999'"},
        {"WP_RADIUS,1,2\n", "f.param:1:13: expected the end of the line, found '2'"},
        {"WP_RADIUS,,2\n", "f.param:1:11: expected a finite decimal number, found the end"},
        {",2\n", "f.param:1:1: expected the name of a parameter, found ','"},
        {"WP_RADIUS,0\n", "f.param:1:11: expected a number from 1 to 32767, found '0'"},
        {"WP_RADIUS,1e300\n", "f.param:1:11: expected a number from 1 to 32767, found 'inf'"},
        {"FLTMODE1,9\n",
         "f.param:1:10: expected a value that means something to this firmware, found '9'"},
        {"WP_RADIU,3\n", "f.param:1:1: expected a parameter of this firmware, found 'WP_RADIU'"},
        {"wp_radius,3\n", "f.param:1:1: expected a parameter of this firmware, found 'wp_radius'"},
        {"A_NAME_OF_MORE_THAN_16,3\n", "f.param:1:1: expected a parameter of this firmware"},
        {"WP_RADIUS,3\nWP_RADIUS,4\n", "f.param:2:1: WP_RADIUS stands in line 1 already"},
    };
    for (const Row& row : kRows) {
        EXPECT_THAT(errorsOf(row.text), testing::StartsWith(row.errors)) << row.text;
        EXPECT_EQ(status_, 1) << row.text;
        EXPECT_EQ(out_, "") << row.text;
    }
}

TEST_F(ParamTool, takes_a_file_as_any_editor_saves_it) {
    const std::string plain = "WP_RADIUS,42\r\n";
    std::string little = "\xFF\xFE", big = "\xFE\xFF";
    for (const char letter : plain) {
        little += {letter, '\0'};
        big += {'\0', letter};
    }
    for (const std::string& text : {"\xEF\xBB\xBF" + plain, little, big}) {
        ASSERT_EQ(param({"compile", file("f.param", text), "-o", path("f.bin")}), 0) << err_;
        EXPECT_EQ(valueIn(path("f.bin"), "WP_RADIUS"), "42");
    }
}

TEST_F(ParamTool, reports_an_empty_file_and_one_that_is_no_text) {
    EXPECT_EQ(errorsOf(""), "f.param: the file is empty\n");
    EXPECT_EQ(errorsOf("\r\n"), "f.param: the file is empty\n");
    EXPECT_EQ(errorsOf(std::string("\x7f"
                                   "ELF\0",
                                   5)),
              "f.param: not a text file\n");
    EXPECT_EQ(status_, 1);
}

TEST_F(ParamTool, prints_fifty_errors_and_how_many_more) {
    std::string text;
    for (int i = 0; i < 60; ++i) text += "WP_RADIUS,x\n";
    const std::string errors = errorsOf(text);
    EXPECT_EQ(std::count(errors.begin(), errors.end(), '\n'), 51);
    EXPECT_THAT(errors, testing::EndsWith("\nand 10 more\n"));
}

TEST_F(ParamTool, leaves_out_the_lengths_of_lists_that_travel_by_themselves) {
    EXPECT_THAT(errorsOf("FENCE_TOTAL,6\nRALLY_TOTAL,0\nWP_RADIUS,42\n"),
                testing::StartsWith("f.param:1:1: warning: FENCE_TOTAL is left out"));
    EXPECT_EQ(status_, 0);
    ASSERT_EQ(param({"compile", path("f.param"), "-o", path("f.bin")}), 0);
    EXPECT_EQ(valueIn(path("f.bin"), "WP_RADIUS"), "42");
}

TEST_F(ParamTool, reports_every_error_line_by_line) {
    const std::string errors = errorsOf("A,1\nTHR_MAX,x\nTHR_MIN,101\nWP_RADIUS,30.4\n");
    EXPECT_EQ(errors,
              "f.param:1:1: expected a parameter of this firmware, found 'A'\n"
              "f.param:2:9: expected a finite decimal number, found 'x'\n"
              "f.param:3:9: expected a number from 0 to 100, found '101'\n"
              "f.param:4:11: warning: a whole number: 30.4 becomes 30\n");
}

TEST_F(ParamTool, skips_parameters_of_other_vehicles_with_the_option) {
    const std::string arduplane = file("a.param", "Q_ENABLE,0\nWP_RADIUS,42\n");
    EXPECT_EQ(param({"compile", arduplane, "-o", path("a.bin")}), 1);
    EXPECT_FALSE(std::filesystem::exists(path("a.bin")));
    EXPECT_EQ(param({"compile", arduplane, "--skip-unknown", "-o", path("a.bin")}), 0);
    EXPECT_THAT(err_, HasSubstr("a.param:1:1: warning: expected a parameter of this firmware"));
    EXPECT_EQ(valueIn(path("a.bin"), "WP_RADIUS"), "42");
}

TEST_F(ParamTool, refuses_files_it_cannot_use) {
    EXPECT_EQ(param({"check", path("absent")}), 1);
    EXPECT_THAT(err_, HasSubstr("cannot be read"));
    EXPECT_EQ(param({"decode", file("t.param", "WP_RADIUS,3\n")}), 1);
    EXPECT_THAT(err_, HasSubstr("expected an image"));
    EXPECT_EQ(param({"compile", path("t.param"), "-o", path("t.txt")}), 1);
    EXPECT_THAT(err_, HasSubstr(".eep"));
    EXPECT_EQ(param({"compile", path("t.param"), "-o", path("no/such/t.bin")}), 1);
    EXPECT_THAT(err_, HasSubstr("cannot be written"));
    EXPECT_EQ(param({"compile", path("t.param"), "--onto", file("s.bin", std::string(4096, 'S')),
                     "-o", path("t.bin")}),
              1);
    EXPECT_THAT(err_, HasSubstr("not an EEPROM of this firmware"));
    EXPECT_EQ(param({"check"}), 2);
    EXPECT_EQ(param({"polish", "x"}), 2);
    EXPECT_EQ(param({"--help"}), 0);
    EXPECT_THAT(out_, HasSubstr("Mission Planner"));
}

}  // namespace
}  // namespace param_tool
