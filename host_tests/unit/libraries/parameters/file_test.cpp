// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/file.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <string>
#include <vector>

namespace {

using core::Status;
using parameters::Table;

struct Fields {
    int8_t small = -5;
    int16_t middle = 1234;
    int32_t large = -100000;
    float real = 0.25f;
    int8_t many[40] = {};
};
Fields fields;

#define FOUR(slot, letter, i)                                                               \
    PARAMETER(slot, "MANY" letter "0", Fields, many[i], 0.0f, -100.0f, 100.0f),             \
        PARAMETER(slot + 1, "MANY" letter "1", Fields, many[i + 1], 0.0f, -100.0f, 100.0f), \
        PARAMETER(slot + 2, "MANY" letter "2", Fields, many[i + 2], 0.0f, -100.0f, 100.0f), \
        PARAMETER(slot + 3, "MANY" letter "3", Fields, many[i + 3], 0.0f, -100.0f, 100.0f)

// clang-format off
constexpr parameters::Row kRows[] = {
    PARAMETER(3,  "SMALL",            Fields, small,  1.0f,  -100.0f, 100.0f),
    PARAMETER(7,  "SMALLER",          Fields, middle, 300.0f, 0.0f,   30000.0f),
    PARAMETER(8,  "SMALL_2",          Fields, large,  -1.0f, -200000.0f, 1000000.0f),
    PARAMETER(9,  "SM",               Fields, small,  1.0f,  -100.0f, 100.0f),
    PARAMETER(12, "SIXTEEN_LETTERS_", Fields, real,   0.25f,  0.0f,   1.0f),
    PARAMETER(13, "SIXTEEN_LETTERS2", Fields, real,   0.25f,  0.0f,   1.0f),
    FOUR(20, "A", 0), FOUR(24, "B", 4), FOUR(28, "C", 8), FOUR(32, "D", 12), FOUR(36, "E", 16),
    FOUR(40, "F", 20), FOUR(44, "G", 24), FOUR(48, "H", 28), FOUR(52, "I", 32), FOUR(56, "J", 36),
};
// clang-format on
constexpr core::CodePair kPairs[] = {{'S', 'M'}, {0x80, 'A'}};
constexpr parameters::Packed<core::count(kRows), parameters::distinctNumbers(kRows),
                             parameters::nameCodes(kRows, kPairs), core::count(kPairs)>
    kPacked(kRows, kPairs);
const Table table(kPacked, &fields);

std::vector<uint8_t> read(uint16_t offset, uint8_t size, parameters::FileCursor& cursor) {
    std::vector<uint8_t> bytes(size);
    uint8_t read = size;
    while (parameters::readFile(table, cursor, offset, bytes.data(), read) == Status::busy)
        read = size;
    bytes.resize(read);
    return bytes;
}

std::vector<uint8_t> wholeFile(uint8_t chunk) {
    std::vector<uint8_t> file;
    parameters::FileCursor cursor;
    for (;;) {
        const auto part = read(static_cast<uint16_t>(file.size()), chunk, cursor);
        if (part.empty()) return file;
        file.insert(file.end(), part.begin(), part.end());
    }
}

struct Found {
    std::string name;
    uint8_t type;
    std::vector<uint8_t> value;
};

// By the description in ArduPilot's AP_Filesystem_Param.h, not by the code that is tested.
std::vector<Found> decode(const std::vector<uint8_t>& file) {
    std::vector<Found> found;
    std::string name;
    for (size_t at = 6; at < file.size();) {
        const uint8_t type = file[at] & 15;
        EXPECT_EQ(file[at] >> 4, 0) << "no flags: no defaults";
        const size_t common = file[at + 1] & 15u, letters = (file[at + 1] >> 4) + 1u;
        name = name.substr(0, common) +
               std::string(file.begin() + at + 2, file.begin() + at + 2 + letters);
        at += 2 + letters;
        const size_t width = type == 1 ? 1 : type == 2 ? 2 : 4;
        found.push_back({name, type, {file.begin() + at, file.begin() + at + width}});
        at += width;
    }
    return found;
}

TEST(ParameterFile, has_every_parameter_with_its_type_and_value) {
    const auto file = wholeFile(80);

    ASSERT_EQ(file.size(), parameters::fileSize(kRows));
    const uint8_t count = core::count(kRows);
    EXPECT_EQ(std::vector<uint8_t>(file.begin(), file.begin() + 6),
              (std::vector<uint8_t>{0x1B, 0x67, count, 0, count, 0}));
    const auto found = decode(file);
    ASSERT_EQ(found.size(), core::count(kRows));
    for (size_t i = 0; i < found.size(); ++i) EXPECT_EQ(found[i].name, kRows[i].name);
    EXPECT_EQ(found[0].type, 1);
    EXPECT_EQ(found[0].value, std::vector<uint8_t>{0xFB});
    EXPECT_EQ(found[1].type, 2);
    EXPECT_EQ(found[1].value, (std::vector<uint8_t>{0xD2, 0x04}));
    EXPECT_EQ(found[2].type, 3);
    EXPECT_EQ(found[2].value, (std::vector<uint8_t>{0x60, 0x79, 0xFE, 0xFF}));
    EXPECT_EQ(found[4].type, 4);
    EXPECT_EQ(found[4].value, (std::vector<uint8_t>{0, 0, 0x80, 0x3E}));
}

TEST(ParameterFile, is_the_same_in_parts_of_any_size) {
    const auto file = wholeFile(255);
    for (const int chunk : {1, 2, 5, 6, 7, 23, 82}) EXPECT_EQ(wholeFile(chunk), file) << chunk;
}

TEST(ParameterFile, is_the_same_from_any_place_after_any_other) {
    const auto file = wholeFile(255);
    parameters::FileCursor cursor;
    uint32_t random = 1;
    for (int i = 0; i < 2000; ++i) {
        random = random * 1664525 + 1013904223;
        const auto offset = static_cast<uint16_t>((random >> 8) % (file.size() + 20));
        const auto size = static_cast<uint8_t>(1 + (random >> 24) % 100);
        const size_t begin = std::min<size_t>(offset, file.size());
        const size_t end = std::min<size_t>(offset + size, file.size());
        ASSERT_EQ(read(offset, size, cursor),
                  std::vector<uint8_t>(file.begin() + begin, file.begin() + end))
            << offset << " " << size;
    }
}

// A frame must not wait while two hundred names are spelled.
TEST(ParameterFile, goes_no_further_than_some_entries_in_one_call) {
    const auto last = static_cast<uint16_t>(parameters::fileSize(kRows) - 1);
    parameters::FileCursor cursor;
    uint8_t byte = 0xEE, calls = 0;
    for (;;) {
        uint8_t size = 1;
        const uint8_t before = cursor.number;
        const Status status = parameters::readFile(table, cursor, last, &byte, size);
        ++calls;
        EXPECT_LE(cursor.number - before, 8);
        if (status == Status::ok) break;
        ASSERT_EQ(status, Status::busy);
        ASSERT_LT(calls, 10);
    }
    EXPECT_GT(calls, 2);
    EXPECT_EQ(byte, wholeFile(80).back());
}

}  // namespace
