// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/mission/lists.hpp"
#include "mission_tool_rig.hpp"
#include "toolchain/mission_tool/board.hpp"
#include "toolchain/mission_tool/table.hpp"

namespace mission_tool {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

constexpr char kHome2[] = "APM 2.0\n0x10 0 0 40000 470000000 80000000\n";
constexpr char kNear2[] = "0x10 1 0 6000 470010000 80000000\n";
constexpr char kNorth2[] = "0x10 1 0 6000 470100000 80000000\n";
constexpr char kNorth1[] = "0x10 0 6000 470100000 80000000\n";

std::string apm2(const std::string& lines) { return kHome2 + lines; }

TEST(Warnings, a_mission_as_it_should_be_has_none) { EXPECT_EQ(warningsOf(kTwoWaypoints), ""); }

TEST(Warnings, commands_behind_the_last_nav_of_the_second_set_are_never_run) {
    EXPECT_EQ(warningsOf(apm2(std::string(kNorth2) + "0x70 0 0 0 5 0\n0xB5 0 0 1 0 0\n")),
              "2: items 2 to 3 behind the last NAV: never run while MIS_TRAILING is 0\n");
}

TEST(Warnings, what_stands_before_a_jump_that_closes_a_loop_is_run) {
    const std::string closed = std::string(kNear2) + kNorth2 + "0xB5 0 0 1 0 0\n0xB1 0 1 0 3 0\n";
    EXPECT_EQ(warningsOf(apm2(closed)), "");
    EXPECT_EQ(warningsOf(apm2(closed + "0xB5 0 0 0 0 0\n")),
              "5: item 5 behind the last NAV: never run while MIS_TRAILING is 0\n");
}

TEST(Warnings, commands_before_the_first_nav_of_the_first_set_are_never_run) {
    EXPECT_EQ(warningsOf(apm1(std::string("0x81 1 0 0 0\n") + kNorth1 + "0x81 0 0 0 0\n")),
              "1: item 1 before the first NAV: never run\n");
    EXPECT_EQ(warningsOf(apm2(std::string("0xB5 0 0 1 0 0\n") + kNorth2)), "");
}

TEST(Warnings, a_mission_without_a_nav_cannot_be_flown) {
    EXPECT_THAT(warningsOf(apm2("0xB5 0 0 1 0 0\n")), HasSubstr("0: no NAV command"));
}

TEST(Warnings, a_jump_behind_the_last_nav_ends_the_mission) {
    EXPECT_THAT(
        warningsOf(apm2(std::string(kNear2) + "0xB1 0 4 0 1 0\n" + kNorth2 + "0xB5 0 0 1 0 0\n")),
        HasSubstr("2: no NAV follows item 4: this jump ends the mission"));
}

// Findings are one list: these are errors, for the board refuses the mission.
TEST(Warnings, jumps_that_go_round_without_a_nav_or_condition_are_refused) {
    const std::string round = "0xB1 0 2 0 -1 0\n0xB1 0 1 0 -1 0\n";
    EXPECT_THAT(warningsOf(apm2(round + kNorth2)), HasSubstr("error 1: jumps go round here"));
    EXPECT_EQ(warningsOf(apm2(std::string(kNorth2) + "0xB1 0 1 0 -1 0\n")), "");
    EXPECT_EQ(warningsOf(apm2("0x70 0 0 0 5 0\n0xB1 0 1 0 -1 0\n" + std::string(kNorth2))), "");
    EXPECT_THAT(warningsOf(apm1(std::string(kNorth1) + "0x81 1 0 0 0\n0x75 2 0 0 0\n")),
                HasSubstr("error 3: jumps go round here with neither NAV nor CONDITION"));
}

TEST(Warnings, what_holds_up_the_next_nav_is_refused) {
    std::string relays = kNear2;
    for (int i = 0; i < 145; ++i) relays += "0xB5 0 0 1 0 0\n";
    EXPECT_EQ(warningsOf(apm2(relays + kNorth2)), "");
    relays += "0xB5 0 0 1 0 0\n";
    EXPECT_EQ(warningsOf(apm2(relays + kNorth2)),
              "error 2: what is run from here on holds up the next NAV for more than 1.5 s\n");
}

TEST(Warnings, only_a_takeoff_follows_a_landing) {
    const std::string land = "0x15 1 0 0 470000000 80000000\n";
    EXPECT_THAT(warningsOf(apm2(kNorth2 + land + kNorth2)),
                HasSubstr("3: never flown: only a TAKEOFF can follow the LAND of item 2"));
    EXPECT_EQ(warningsOf(apm2(kNorth2 + land + "0x16 1 15 5000 0 0\n")), "");
}

TEST(Warnings, a_loiter_without_end_hides_what_follows) {
    const std::string loiter = "0x11 1 0 6000 470000000 80000000\n";
    EXPECT_THAT(warningsOf(apm2(loiter + kNorth2)), HasSubstr("1: never finishes"));
    const std::string left = "0x70 0 0 0 60 0\n0xB1 0 4 0 1 0\n" + loiter;
    EXPECT_EQ(warningsOf(apm2(kNear2 + left + kNorth2)).find("never finishes"), std::string::npos);
}

TEST(Warnings, short_and_far_legs_and_low_altitudes) {
    EXPECT_THAT(warningsOf(apm2(std::string(kNorth2) + "0x10 1 200 6000 470101000 80000000\n")),
                HasSubstr("2: the leg of 11 m is shorter than the acceptance radius of 200 m"));
    EXPECT_THAT(warningsOf(apm2("0x10 1 0 6000 80000000 470000000\n")), HasSubstr("1: a leg of "));
    EXPECT_THAT(warningsOf(apm2("0x10 1 0 0 470100000 80000000\n")),
                HasSubstr("1: its altitude is not above home"));
}

TEST(Warnings, what_is_rounded_or_dropped) {
    EXPECT_THAT(warningsOf(between("3 19 34 0 0 0 47.015 8 60")),
                HasSubstr("2: a value is rounded"));
    EXPECT_THAT(warningsOf(between("3 17 0 0 80 0 47.015 8 60")),
                HasSubstr("2: a parameter that the command does not use is dropped"));
}

TEST(Table, shows_which_nav_a_command_accompanies_in_either_set) {
    const std::string chain2 = std::string(kNear2) + "0xB5 0 0 1 0 0\n" + kNorth2;
    EXPECT_EQ(accompaniedNavs(loaded(apm2(chain2))), (std::vector<size_t>{0, 1, 3, 3}));
    const std::string chain1 = std::string(kNorth1) + "0x81 1 0 0 0\n" + kNorth1;
    EXPECT_EQ(accompaniedNavs(loaded(apm1(chain1))), (std::vector<size_t>{0, 1, 1, 3}));
}

std::string lineWith(const std::string& text, const std::string& part) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
        if (line.find(part) != std::string::npos) return line;
    return "";
}

TEST(Table, has_class_altitude_length_and_bearing_of_every_leg) {
    const std::string table =
        tableOf(loaded(apm2(std::string(kNorth2) + "0xB7 0 6 1900 0 0\n"
                                                   "0x12 0 3 50000 470100000 80131600\n"
                                                   "0x14 1 0 0 0 0\n")));
    EXPECT_THAT(lineWith(table, "WAYPOINT"), HasSubstr("NAV"));
    EXPECT_THAT(lineWith(table, "WAYPOINT"), HasSubstr("60.00 m above home  ~1112 m      000"));
    EXPECT_THAT(lineWith(table, "SET_SERVO"), HasSubstr("DO     SET_SERVO"));
    EXPECT_THAT(lineWith(table, "SET_SERVO"), HasSubstr("p1 6 p2 1900"));
    EXPECT_THAT(lineWith(table, "LOITER_TURNS"), HasSubstr("500.00 m above sea"));
    EXPECT_THAT(lineWith(table, "LOITER_TURNS"), HasSubstr("1001 m      090"));
    EXPECT_THAT(lineWith(table, "RETURN"), HasSubstr("ALT_HOLD_RTL   1496 m      222"));
    EXPECT_THAT(table, HasSubstr("APM 2.0 set, 5 of 171 items, legs of 3.6 km in all"));
}

TEST(Table, has_the_id_that_the_board_answers_with_once_it_has_stored_the_mission) {
    const Document document = loaded(apm2(std::string(kNear2) + kNorth2));
    boot(uploaded(document, blankImage(), ""), "");
    const uint32_t id = firmware::mission::listId(storage::ListKind::mission);
    EXPECT_NE(id, 0u);
    EXPECT_THAT(tableOf(document), HasSubstr("in all, id " + std::to_string(id) + '\n'));
}

TEST(Table, has_no_id_for_what_cannot_be_stored) {
    EXPECT_THAT(tableOf(loaded(apm2("0x10 1 0 6000 950000000 80000000\n"))),
                HasSubstr("id none: not all items can be stored"));
}

TEST(Table, has_no_leg_from_or_to_a_home_that_is_no_place) {
    const std::string table = tableOf(loaded("APM 2.0\n0x10 0 0 40000 2147483647 -2147483648\n" +
                                             std::string(kNorth2) + "0x14 1 0 0 0 0\n"));
    EXPECT_THAT(lineWith(table, "WAYPOINT"), Not(HasSubstr("~")));
    EXPECT_THAT(lineWith(table, "RETURN"), EndsWith("ALT_HOLD_RTL"));
    EXPECT_THAT(table, HasSubstr("legs of 0.0 km in all"));
}

class Show : public Tool {};

TEST_F(Show, prints_files_and_images_alike_and_what_would_be_refused) {
    const std::string good = file("good", kTwoWaypoints);
    ASSERT_EQ(tool({"compile", good, "-o", path("i.eep")}), 0) << err_;
    ASSERT_EQ(tool({"show", good}), 0);
    const std::string of_file = out_;
    ASSERT_EQ(tool({"show", path("i.eep")}), 0);
    EXPECT_EQ(out_, of_file);
    ASSERT_EQ(tool({"show", file("bad", between("3 202 0 0 0 0 0 0 0"))}), 0);
    EXPECT_THAT(out_, HasSubstr("0xCA"));
    ASSERT_EQ(tool({"show", file("wide", between("3 601 0 0 0 0 0 0 0"))}), 0);
    EXPECT_THAT(out_, HasSubstr(" 601\n"));
    EXPECT_THAT(out_, HasSubstr("refused: item 2: expected a command of the APM 2.0 set"));
}

}  // namespace
}  // namespace mission_tool
