// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/ground/text_file.hpp"

#include <gtest/gtest.h>

using namespace simulator;

namespace {

std::string bytes(std::initializer_list<int> all) {
    std::string text;
    for (const int byte : all) text += static_cast<char>(byte);
    return text;
}

}  // namespace

TEST(DecodedText, is_utf8_without_its_mark_and_with_plain_line_ends) {
    EXPECT_EQ(decodedText("a\r\nb\rc\n\r\n"), "a\nb\rc\n\n");
    EXPECT_EQ(decodedText("\xEF\xBB\xBF"
                          "a"),
              "a");
    EXPECT_EQ(decodedText(""), "");
}

TEST(DecodedText, comes_from_utf16_of_either_order) {
    const std::string expected =
        "A\xC3\xA4\xE2\x82\xAC\xF0\x9F\x9B\xA9";  // A, a umlaut, euro, plane
    EXPECT_EQ(decodedText(bytes({0xFF, 0xFE, 'A', 0, 0xE4, 0, 0xAC, 0x20, 0x3D, 0xD8, 0xE9, 0xDE})),
              expected);
    EXPECT_EQ(decodedText(bytes({0xFE, 0xFF, 0, 'A', 0, 0xE4, 0x20, 0xAC, 0xD8, 0x3D, 0xDE, 0xE9})),
              expected);
}

TEST(DecodedText, of_half_a_letter_is_the_sign_for_it) {
    EXPECT_EQ(decodedText(bytes({0xFF, 0xFE, 0x3D, 0xD8, 'A', 0})),
              "\xEF\xBF\xBD"
              "A");
    EXPECT_EQ(decodedText(bytes({0xFF, 0xFE, 0x3D, 0xD8})), "\xEF\xBF\xBD");
    EXPECT_EQ(decodedText(bytes({0xFF, 0xFE, 'A'})), "");  // an odd byte at the end
}

TEST(WhyNoText, names_empty_and_binary_files) {
    EXPECT_EQ(whyNoText(""), "the file is empty");
    EXPECT_EQ(whyNoText(" \r\n\t\n"), "the file is empty");
    EXPECT_EQ(whyNoText("\xEF\xBB\xBF"), "the file is empty");
    EXPECT_EQ(whyNoText(std::string("a\0b", 3)), "not a text file");
    EXPECT_EQ(whyNoText(bytes({0xFF, 0xFE, 'A', 0})), "");
    EXPECT_EQ(whyNoText("a"), "");
}

TEST(Printable, lets_no_control_character_out) {
    EXPECT_EQ(printable("a\x1b[31m\x7f\xc3\xa4"), "a?[31m???");
    EXPECT_EQ(printable(std::string(41, 'x')), std::string(40, 'x') + "...");
}

TEST(Listed, holds_fifty_lines_and_how_many_more) {
    EXPECT_EQ(listed({}), "");
    EXPECT_EQ(listed({"a", "b"}), "a\nb");
    const std::string many = listed(std::vector<std::string>(52, "x"));
    EXPECT_EQ(many.substr(many.size() - 14), "x\nx\nand 2 more");
}
