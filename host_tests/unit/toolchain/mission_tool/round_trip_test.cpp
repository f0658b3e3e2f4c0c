// SPDX-License-Identifier: GPL-3.0-or-later
// What goes into an image comes out again, and the board boots with it.
#include <random>

#include "firmware/mission/command_table.hpp"
#include "firmware/mission/item.hpp"
#include "mission_tool_rig.hpp"
#include "toolchain/mission_tool/text_form.hpp"
#include "toolchain/mission_tool/waypoint_form.hpp"

namespace mission_tool {
namespace {

using mission::Set;

class RoundTrip : public Tool {
protected:
    // compile, decode, compile: the same image.
    void expectSame(const std::string& contents, const std::string& decoded_as) {
        const std::string first = path("first.eep"), text = path("text"),
                          second = path("second.eep");
        ASSERT_EQ(tool({"compile", file("mission", contents), "-o", first}), 0) << err_;
        ASSERT_EQ(tool({"decode", first, "-o", text}), 0) << err_;
        EXPECT_EQ(readFile(text).rfind(decoded_as, 0), 0u) << readFile(text);
        ASSERT_EQ(tool({"compile", text, "-o", second}), 0) << err_;
        EXPECT_EQ(readFile(first), readFile(second));
    }
};

TEST_F(RoundTrip, a_waypoint_file_gives_the_same_image_again) {
    expectSame(between("3 178 0 12.5 -1 0 0 0 0"), "QGC WPL 110");
    expectSame(between("3 112 7 0 0 0 0 0 0"), "QGC WPL 110");
    expectSame(between("3 18 2 0 -1 0 -47.1234567 -179.9999999 12.34"), "QGC WPL 110");
}

TEST_F(RoundTrip, altitudes_come_back_to_the_centimetre_over_all_that_a_record_holds) {
    for (const char* altitude : {"1310.73", "-0.01", "83885.99", "-83886"})
        expectSame(between(std::string("3 16 0 0 0 0 47.1 8.1 ") + altitude), "QGC WPL 110");
}

TEST_F(RoundTrip, the_text_form_gives_the_same_image_again) {
    expectSame(apm1("0x10 30 6000 470100000 80000000\n0x63 1 300000000 0 0\n"), "APM 1.0");
}

// Whole numbers that an item's floats could not carry.
TEST_F(RoundTrip, the_text_form_carries_every_value_of_a_record) {
    expectSame(apm1("0x10 30 2000000001 470100000 80000000\n"
                    "0x20 255 -2147483648 2147483647 -2147483647\n"),
               "APM 1.0");
}

TEST_F(RoundTrip, records_that_an_item_cannot_say_are_decoded_one_by_one) {
    const std::string text =
        "APM 2.0\n0x10 0 0 40000 470000000 80000000\n"
        "0x10 1 30 6000 470100000 80000000\n0x72 2 9 1 50 77\n";
    const std::string image = path("image.bin");
    ASSERT_EQ(tool({"compile", file("text", text), "-o", image}), 0) << err_;
    ASSERT_EQ(tool({"decode", image}), 0);
    EXPECT_EQ(out_.rfind("APM 2.0\n", 0), 0u) << out_;
    EXPECT_NE(out_.find("0x72\t2\t9\t1\t50\t77"), std::string::npos) << out_;
    expectSame(text, "APM 2.0");
}

TEST_F(RoundTrip, decode_writes_a_record_a_line_when_asked) {
    ASSERT_EQ(tool({"compile", file("m", kTwoWaypoints), "-o", path("i.hex")}), 0) << err_;
    ASSERT_EQ(tool({"decode", "--raw", path("i.hex")}), 0);
    EXPECT_NE(out_.find("0x10\t1\t30\t6000\t470200000\t80000000\t# 2 WAYPOINT"), std::string::npos)
        << out_;
}

TEST_F(RoundTrip, the_three_kinds_of_image_hold_the_same) {
    const std::string mission = file("m", kTwoWaypoints);
    for (const char* name : {"i.eep", "i.hex", "i.bin"})
        ASSERT_EQ(tool({"compile", mission, "-o", path(name)}), 0) << err_;
    EXPECT_EQ(readFile(path("i.bin")).size(), 4096u);
    EXPECT_EQ(readFile(path("i.eep")), readFile(path("i.hex")));
    EXPECT_EQ(imageOf(readFile(path("i.eep")), ""), imageOf(readFile(path("i.bin")), ""));
}

TEST_F(RoundTrip, a_full_mission_fits_and_one_item_more_is_refused) {
    std::string lines;
    for (int i = 0; i < 170; ++i) lines += "0x10 30 6000 470100000 80000000\n";
    expectSame(apm1(lines), "APM 1.0");
    EXPECT_EQ(refusalOf(apm1(lines + "0x10 30 6000 470100000 80000000\n")),
              "m:173:1: expected at most 171 items, home included, found 172");
}

TEST_F(RoundTrip, onto_an_image_everything_but_the_mission_stays) {
    Image board = compiled(kTwoWaypoints);
    board[storage::parameterAddress(200)] = 0x5A;
    board[storage::kRally.begin + 3] = 0xA5;
    const std::string onto = file("onto.bin", rawOf(board));
    const std::string longer = file("longer", between("3 112 7 0 0 0 0 0 0"));
    ASSERT_EQ(tool({"compile", longer, "--onto", onto, "-o", path("new.bin")}), 0) << err_;
    const Image result = imageOf(readFile(path("new.bin")), "");
    for (uint16_t at = 0; at < storage::kMissionHead.begin; ++at) EXPECT_EQ(result[at], board[at]);
    for (uint16_t at = storage::kFence.begin; at < storage::kSpare.end(); ++at)
        EXPECT_EQ(result[at], board[at]);
    EXPECT_EQ(storedMission(result, "").entries.size(), 4u);
}

TEST_F(RoundTrip, onto_a_board_with_a_full_mission_there_is_room) {
    std::string lines;
    for (int i = 0; i < 170; ++i) lines += "0x10 30 6000 470100000 80000000\n";
    const Image full = compiled(apm1(lines));
    const Image again = uploaded(loaded(apm1(lines)), full, "");
    EXPECT_EQ(storedMission(again, "").entries.size(), 171u);
}

// Every record that the firmware takes, of both sets: through the text and back.
TEST_F(RoundTrip, random_missions_of_both_sets_give_the_same_image_again) {
    std::mt19937 random(20120411);
    const auto upTo = [&](uint32_t most) { return random() % (most + 1); };
    const auto value = [&]() -> int32_t {
        constexpr int32_t kLikely[] = {0, 1, -1, 5, 8, 20, 60, 300, 1000, 1500, 2100, 470000000};
        if (upTo(3) != 0) return kLikely[upTo(11)];
        return static_cast<int32_t>(random()) >> upTo(31);
    };
    size_t taken = 0;
    for (int round = 0; round < 60; ++round) {
        Document document;
        document.set = round % 2 == 0 ? Set::apm2 : Set::apm1;
        document.name = "random";
        powerUp(blankImage());
        document.entries.resize(30);
        for (size_t i = 0; i < document.entries.size(); ++i) {
            Entry& entry = document.entries[i];
            do {
                const auto row =
                    static_cast<uint8_t>(upTo(firmware::mission::kCommandTable.count - 1u));
                entry.record = {firmware::mission::kCommandTable.id(document.set, row),
                                static_cast<uint8_t>(document.set == Set::apm2 ? upTo(7) : 0),
                                static_cast<uint8_t>(upTo(1) != 0 ? upTo(10) : upTo(255)),
                                value() % (mission::kLargestP2 + 1),
                                value(),
                                value()};
            } while (check(document.set, i, document.entries.size(), entry) !=
                         firmware::mission::MissionResult::accepted ||
                     entry.is(mission::Class::jump));  // drawn, they would go round
            ++taken;
        }
        const Image image = uploaded(document, blankImage(), "");
        Document stored = storedMission(image, "random");
        checkAll(stored);
        std::string text = recordsAsWaypoints(stored);
        if (text.empty()) text = recordsAsText(stored);
        EXPECT_EQ(compiled(text), image) << text;
    }
    EXPECT_EQ(taken, 60u * 30u);
}

// An item as a ground station writes it: what the file says is what the board answers.
TEST_F(RoundTrip, the_board_that_boots_with_the_image_answers_with_the_same_items) {
    powerUp(compiled(between("3 184 6 1900 3 4 0 0 0")));
    ASSERT_EQ(firmware::mission::missionCount(), 4);
    firmware::mission::MissionItem item = {};
    ASSERT_EQ(firmware::mission::missionItem(2, item), core::Status::ok);
    EXPECT_EQ(item.command, 184);
    EXPECT_EQ(item.param1, 6);
    EXPECT_EQ(item.param2, 1900);
    EXPECT_EQ(item.param3, 3);
    EXPECT_EQ(item.param4, 4);
}

std::string projectFile(const std::string& name) {
    std::string path = __FILE__;
    path.resize(path.rfind("host_tests/"));
    return path + name;
}

TEST_F(RoundTrip, every_mission_that_comes_with_the_simulator_gives_the_same_image_again) {
    int files = 0;
    for (const auto& entry :
         std::filesystem::directory_iterator(projectFile("simulator/missions"))) {
        if (entry.path().extension() != ".waypoints") continue;
        expectSame(readFile(entry.path()), "QGC WPL 110");
        ++files;
    }
    EXPECT_GT(files, 0);
}

TEST_F(RoundTrip, the_example_in_the_manual_is_a_mission_without_a_warning) {
    std::istringstream manual(readFile(projectFile("docs/mission.md")));
    std::string example;
    for (std::string line; std::getline(manual, line);)
        if (line.rfind("    ", 0) == 0 && (line == "    APM 1.0" || !example.empty()))
            example += line.substr(4) + '\n';
    EXPECT_EQ(loaded(example).entries.size(), 6u) << example;
    EXPECT_EQ(warningsOf(example), "");
    expectSame(example, "APM 1.0");
}

TEST_F(RoundTrip, a_waypoint_file_may_be_in_the_first_set) {
    const std::string text =
        "QGC WPL 110\n0 1 0 16 0 0 0 0 47 8 400 1\n1 0 3 16 30 0 0 0 47.01 8 60 1\n"
        "2 0 2 129 1 0 0 0 0 0 0 1\n";
    const std::string image = path("i.bin");
    ASSERT_EQ(tool({"compile", "--set", "apm1", file("m", text), "-o", image}), 0) << err_;
    ASSERT_EQ(tool({"decode", image}), 0);
    EXPECT_NE(out_.find("0x81\t1\t0\t0\t0\t# 2 SET_RELAY"), std::string::npos) << out_;
    EXPECT_EQ(out_.rfind("APM 1.0", 0), 0u);
}

}  // namespace
}  // namespace mission_tool
