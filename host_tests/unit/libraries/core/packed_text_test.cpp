// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/packed_text.hpp"

#include <gtest/gtest.h>

#include <string>

using core::CodePair;

namespace {

constexpr CodePair kPairs[] = {{'a', 'n'}, {0x80, 0x80}, {'b', 0x81}, {'s', ' '}};

std::string spelt(const uint8_t* codes, uint8_t size, const CodePair* pairs) {
    std::string letters;
    core::Unpacker from(codes, size, pairs);
    for (char letter; (letter = from.next()) != 0;) letters += letter;
    EXPECT_EQ(from.next(), 0) << "the end stays the end";
    return letters;
}

TEST(PackedText, is_spelt_as_it_was_written) {
    for (const char* text : {"", "a", "an", "banana", "bananas ananas anna", "aannaann", "#"}) {
        const core::Packing<50> packing(text, kPairs);
        EXPECT_EQ(spelt(packing.codes, 50, kPairs), text);
        EXPECT_EQ(spelt(packing.codes, uint8_t(packing.size), kPairs), text);
    }
}

TEST(PackedText, has_one_code_for_a_pair_of_pairs) {
    EXPECT_EQ(core::packedSize("banana", kPairs), 2U);  // (b(an an)) a
    EXPECT_EQ(core::packedSize("nab", kPairs), 3U);
    static_assert(core::packedSize("ananan", kPairs) == 2, "from left to right");
}

TEST(PackedText, ends_at_its_size_though_the_next_text_follows_at_once) {
    const uint8_t codes[] = {'b', 0x81, 'x', 'y'};
    EXPECT_EQ(spelt(codes, 2, kPairs), "banan");
    EXPECT_EQ(spelt(codes + 2, 2, kPairs), "xy");
}

TEST(PackedText, is_cut_off_where_there_is_no_room_and_has_zeros_where_there_is) {
    const uint8_t codes[] = {0x82, 'a', 0};
    char room[8];
    EXPECT_EQ(core::unpack({codes, 3, kPairs}, room, sizeof room), 6);
    EXPECT_EQ(std::string(room, 8), std::string("banana\0\0", 8));
    EXPECT_EQ(core::unpack({codes, 3, kPairs}, room, 4), 4);
    EXPECT_EQ(std::string(room, 8), std::string("banana\0\0", 8));
}

// The text is spelt with a check of how many codes wait.
TEST(PackedText, needs_the_room_that_is_worked_out_from_the_pairs) {
    static_assert(core::pairsDeep(kPairs) == 2, "n behind a, behind the second an");
    constexpr CodePair kOnTheRight[] = {{'a', 'b'}, {'c', 0x80}, {'d', 0x81}};
    static_assert(core::pairsDeep(kOnTheRight) == 1, "nothing waits behind what comes last");
    constexpr CodePair kOnTheLeft[] = {{'a', 'b'}, {0x80, 'c'}, {0x81, 'd'}};
    static_assert(core::pairsDeep(kOnTheLeft) == 3, "b, c and d wait for a");
    const uint8_t codes[] = {0x82, 0};
    EXPECT_EQ(spelt(codes, 2, kOnTheRight), "dcab");
    EXPECT_EQ(spelt(codes, 2, kOnTheLeft), "abcd");
}

TEST(PackedText, is_known_by_the_letter_it_begins_with) {
    EXPECT_EQ(core::firstLetter('x', kPairs), 'x');
    EXPECT_EQ(core::firstLetter(0x81, kPairs), 'a');
    EXPECT_EQ(core::firstLetter(0x82, kPairs), 'b');
}

}  // namespace
