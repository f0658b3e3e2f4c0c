// SPDX-License-Identifier: GPL-3.0-or-later
// EEPROMs of ArduPlane: recognised, and those of 2.x boards carried over.
#include "toolchain/mission_tool/arduplane.hpp"
#include "mission_tool_rig.hpp"
#include "toolchain/mission_tool/waypoint_form.hpp"

namespace mission_tool {
namespace {

using testing::HasSubstr;
using Bytes = std::vector<uint8_t>;

// As such a board holds it: items of 15 bytes from 0x500 on, home first.
Image boardOf2(const std::vector<Bytes>& items) {
    Image image = blankImage();
    const Bytes mark = {0x50, 0x41, 6, 0};
    std::copy(mark.begin(), mark.end(), image.begin());
    for (size_t i = 0; i < items.size(); ++i)
        std::copy(items[i].begin(), items[i].end(),
                  image.begin() + static_cast<ptrdiff_t>(0x500 + 15 * i));
    return image;
}
const Bytes kHome = {0x10, 0,    0,    0x40, 0x9C, 0x00, 0x00, 0x80,
                     0xA1, 0x03, 0x1C, 0x00, 0xB4, 0xC4, 0x04};
// 60 m above home, radius 30 m
const Bytes kNorth = {0x10, 1,    30,   0x70, 0x17, 0x00, 0x00, 0x20,
                      0x28, 0x05, 0x1C, 0x00, 0xB4, 0xC4, 0x04};
// servo 6, 1900 us, 3 times, every 4 s
const Bytes kRepeatServo = {0xB8, 0, 6, 0x6C, 0x07, 0, 0, 3, 0, 0, 0, 4, 0, 0, 0};

class ArduPlane : public Tool {};

TEST_F(ArduPlane, images_are_recognised_and_the_option_to_read_them_is_named) {
    const std::string image = file("old.bin", rawOf(boardOf2({kHome, kNorth})));
    EXPECT_EQ(tool({"show", image}), 1);
    EXPECT_EQ(err_,
              image + ": ArduPlane's EEPROM: --records 15 reads the mission of a 2.x board\n");
    EXPECT_EQ(tool({"compile", file("m", kTwoWaypoints), "--onto", image, "-o", path("x.eep")}), 1);
    EXPECT_THAT(err_, HasSubstr("ArduPlane's EEPROM"));
}

// Behind the version, items of id, p1 of 16 bits, and 12 bytes that are each command's own.
Image boardOf3(const std::vector<Bytes>& items) {
    Image image = boardOf2({{0xAE, 0x65, 0, 0}});
    for (size_t i = 0; i < items.size(); ++i)
        std::copy(items[i].begin(), items[i].end(),
                  image.begin() + static_cast<ptrdiff_t>(0x504 + 15 * i));
    return image;
}
Bytes at3(uint8_t id, uint16_t p1, uint8_t options, int32_t altitude_cm) {
    const auto low = [](int32_t value) { return static_cast<uint8_t>(value); };
    return {id,
            low(p1),
            low(p1 >> 8),
            options,
            low(altitude_cm),
            low(altitude_cm >> 8),
            low(altitude_cm >> 16),
            0x80,
            0xA1,
            0x03,
            0x1C,
            0x00,
            0xB4,
            0xC4,
            0x04};
}
Bytes of3(uint8_t id, uint16_t p1, const Bytes& content) {
    Bytes item(15);
    item[0] = id;
    item[1] = static_cast<uint8_t>(p1);
    item[2] = static_cast<uint8_t>(p1 >> 8);
    std::copy(content.begin(), content.end(), item.begin() + 3);
    return item;
}

TEST_F(ArduPlane, a_later_version_is_distinguished) {
    const std::string image = file("3.bin", rawOf(boardOf3({})));
    EXPECT_EQ(tool({"show", image}), 1);
    EXPECT_THAT(err_, HasSubstr("3.0 or later: --records 15 reads its mission"));
    EXPECT_EQ(tool({"show", "--records", "15", image}), 1);
    EXPECT_THAT(err_, HasSubstr("no mission in it"));
    EXPECT_EQ(tool({"compile", "--records", "15", file("m", kTwoWaypoints), "--onto", image, "-o",
                    path("x.bin")}),
              1);
    EXPECT_THAT(err_, HasSubstr("only a ground station writes to it"));
}

TEST_F(ArduPlane, every_command_of_a_board_of_3_is_read) {
    const std::vector<std::pair<Bytes, std::string>> items = {
        {at3(16, 0, 0, 40000), "0\t16\t0\t0\t0\t0\t47.0000000\t8.0000000\t400"},
        {at3(22, 15, 1, 4000), "3\t22\t15\t0\t0\t0\t0.0000000\t0.0000000\t40"},
        {at3(16, 25, 1, -150), "3\t16\t0\t25\t0\t0\t47.0000000\t8.0000000\t-1.5"},
        {at3(17, 0, 5, 6000), "3\t17\t0\t0\t-1\t0\t47.0000000\t8.0000000\t60"},
        {at3(18, 0x5003, 1, 6000), "3\t18\t3\t0\t0\t0\t47.0000000\t8.0000000\t60"},
        {at3(19, 120, 1, 6000), "3\t19\t120\t0\t0\t0\t47.0000000\t8.0000000\t60"},
        {at3(20, 0, 1, 0), "3\t20\t0\t0\t0\t0\t47.0000000\t8.0000000\t0"},
        {at3(30, 0, 1, 8000), "3\t30\t0\t0\t0\t0\t47.0000000\t8.0000000\t80"},
        {at3(31, 1, 5, 8000), "3\t31\t1\t-1\t0\t0\t47.0000000\t8.0000000\t80"},
        {of3(112, 0, {0, 0, 0x40, 0x40}), "2\t112\t3\t"},
        {of3(113, 0, {1, 0x70, 0x17, 0, 0x90, 0x01, 0, 0}),
         "3\t113\t4\t0\t0\t0\t0.0000000\t0.0000000\t60"},
        {of3(114, 0, {0, 0, 0xC8, 0x42}), "2\t114\t100\t"},
        {of3(177, 0, {2, 0, 0xFF, 0xFF}), "2\t177\t2\t-1\t"},
        {of3(178, 0, {0, 0, 0, 0x60, 0x41, 0, 0, 0, 0}), "2\t178\t0\t14\t-1\t"},
        {at3(179, 0, 0, 41000), "0\t179\t0\t0\t0\t0\t47.0000000\t8.0000000\t410"},
        {of3(181, 0, {0, 1}), "2\t181\t0\t1\t"},
        {of3(182, 0, {0, 3, 0, 0, 0, 0, 0x40}), "2\t182\t0\t3\t2\t"},
        {of3(183, 0, {6, 0x6C, 0x07}), "2\t183\t6\t1900\t"},
        {of3(184, 0, {6, 0x6C, 0x07, 3, 0, 0, 0, 0x80, 0x40}), "2\t184\t6\t1900\t3\t4\t"},
        {at3(189, 0, 1, 3000), "3\t189\t0\t0\t0\t0\t47.0000000\t8.0000000\t30"},
        {at3(201, 3, 1, 0), "3\t201\t3\t0\t0\t0\t47.0000000\t8.0000000\t0"},
        {of3(203, 0, {1, 2, 3}), "2\t203\t0\t0\t0\t0\t"},
        {of3(205, 0, {0, 0, 0x40, 0x40}), "2\t205\t0\t0\t0\t0\t"},
        {of3(206, 0, {0, 0, 0x48, 0x41}), "2\t206\t12.5\t"},
        {of3(207, 1, {}), "2\t207\t1\t"},
        {of3(210, 0, {}), "2\t210\t0\t"},
        {at3(21, 0, 1, 0), "3\t21\t0\t0\t0\t0\t47.0000000\t8.0000000\t0"},
    };
    std::vector<Bytes> stored;
    for (const auto& item : items) stored.push_back(item.first);
    const std::string image = file("3.bin", rawOf(boardOf3(stored)));
    ASSERT_EQ(tool({"decode", "--records", "15", image}), 0) << err_;
    for (size_t i = 0; i < items.size(); ++i)
        EXPECT_THAT(out_, HasSubstr("\n" + std::to_string(i) + (i == 0 ? "\t1\t" : "\t0\t") +
                                    items[i].second));
}

TEST_F(ArduPlane, what_a_board_of_3_holds_and_this_one_cannot_do_names_its_item) {
    const std::string image =
        file("3.bin", rawOf(boardOf3({at3(16, 0, 0, 0), of3(208, 2, {}), at3(16, 0, 9, 0)})));
    ASSERT_EQ(tool({"show", "--records", "15", image}), 0);
    EXPECT_THAT(out_, HasSubstr("refused: item 1: expected a command of the APM 2.0 set"));
    EXPECT_THAT(out_, HasSubstr("refused: item 2: expected an altitude above the sea"));
}

TEST_F(ArduPlane, a_board_of_2_decodes_with_its_servo_repeats_in_our_order) {
    const std::string image = file("old.bin", rawOf(boardOf2({kHome, kRepeatServo, kNorth})));
    ASSERT_EQ(tool({"decode", "--records", "15", image}), 0) << err_;
    EXPECT_THAT(out_, HasSubstr("1\t0\t2\t184\t6\t1900\t3\t4\t"));
    EXPECT_THAT(out_, HasSubstr("2\t0\t3\t16\t0\t30\t0\t0\t47.0100000\t8.0000000\t60\t1\n"));
}

TEST_F(ArduPlane, a_board_of_2_is_carried_over_in_one_step) {
    const std::string image = file("old.bin", rawOf(boardOf2({kHome, kRepeatServo, kNorth})));
    ASSERT_EQ(tool({"compile", "--records", "15", image, "-o", path("new.eep")}), 0) << err_;
    const Document stored = storedMission(parseHex(readFile(path("new.eep")), ""), "");
    ASSERT_EQ(stored.entries.size(), 3u);
    EXPECT_EQ(stored.entries[1].record.p2, 3);
    EXPECT_EQ(stored.entries[1].record.p3, 4);
    EXPECT_EQ(stored.entries[1].record.p4, 1900);
}

TEST_F(ArduPlane, a_second_parameter_beyond_24_bits_refuses_the_image_and_names_the_item) {
    Bytes high = kNorth;
    high[6] = 1;
    const std::string image = file("old.bin", rawOf(boardOf2({kHome, kNorth, high})));
    EXPECT_EQ(tool({"decode", "--records", "15", image}), 1);
    EXPECT_EQ(err_, image +
                        ": item 2: expected a second parameter of at most 24 bits, found "
                        "16783216\n");
}

TEST_F(ArduPlane, the_count_that_the_board_knows_ends_the_mission_where_older_records_follow) {
    const std::string image = file("old.bin", rawOf(boardOf2({kHome, kNorth, kNorth, kNorth})));
    ASSERT_EQ(tool({"show", "--records", "15", image}), 0);
    EXPECT_THAT(out_, HasSubstr("4 of 171 items"));
    EXPECT_THAT(err_, HasSubstr("taken as 4 items"));
    ASSERT_EQ(tool({"show", "--records", "15", "--count", "2", image}), 0);
    EXPECT_THAT(out_, HasSubstr("2 of 171 items"));
    EXPECT_EQ(err_, "");
    EXPECT_EQ(tool({"show", "--records", "15", "--count", "178", image}), 1);
}

TEST_F(ArduPlane, writing_15_byte_records_gives_back_what_was_read) {
    const Image old = boardOf2({kHome, kRepeatServo, kNorth});
    const std::string image = file("old.bin", rawOf(old));
    ASSERT_EQ(tool({"decode", "--records", "15", image, "-o", path("text")}), 0) << err_;
    ASSERT_EQ(tool({"compile", "--records", "15", path("text"), "--onto", image, "-o",
                    path("again.bin")}),
              0)
        << err_;
    EXPECT_THAT(err_, HasSubstr("set CMD_TOTAL to 2"));
    const Image again = imageOf(readFile(path("again.bin")), "");
    EXPECT_EQ(again, old);
}

TEST_F(ArduPlane, boards_of_2_do_not_know_the_first_set) {
    const std::string text = file("m", apm1("0x10 0 6000 470100000 80000000\n"));
    EXPECT_EQ(tool({"compile", "--records", "15", text, "-o", path("x.bin")}), 1);
    EXPECT_THAT(err_, HasSubstr("APM 2.0 set only"));
}

}  // namespace
}  // namespace mission_tool
