// SPDX-License-Identifier: GPL-3.0-or-later
#include "mission/record.hpp"

#include <gtest/gtest.h>

#include <array>

namespace {

using mission::Record;
using mission::Set;
using Bytes = std::array<uint8_t, mission::kRecordSize>;

Bytes packed(Set set, const Record& record) {
    Bytes bytes;
    mission::pack(set, record, bytes.data());
    return bytes;
}

TEST(Record, the_apm1_layout_has_p1_at_1_and_p2_at_2_little_endian) {
    const Record record = {0x82, 0, 7, 0x01020304, 0x05060708, -2};
    EXPECT_EQ(packed(Set::apm1, record),
              (Bytes{0x82, 7, 4, 3, 2, 1, 8, 7, 6, 5, 0xFE, 0xFF, 0xFF, 0xFF}));
}

TEST(Record, the_apm2_layout_has_options_p1_and_a_24_bit_p2) {
    const Record record = {16, 5, 30, -100, 473977418, 85455939};
    EXPECT_EQ(packed(Set::apm2, record),
              (Bytes{16, 5, 30, 0x9C, 0xFF, 0xFF, 0x4A, 0x52, 0x40, 0x1C, 0x43, 0xF4, 0x17, 0x05}));
}

TEST(Record, what_is_packed_is_unpacked_in_both_layouts_to_the_ends_of_the_range) {
    const int32_t ends24[] = {0, 1, -1, 8388607, -8388608}, ends32[] = {0, INT32_MAX, INT32_MIN};
    for (int32_t p2 : ends24) {
        for (int32_t p3 : ends32) {
            const Record record = {22, 1, 255, p2, p3, -(p3 / 2)};
            const Record found = mission::unpack(Set::apm2, packed(Set::apm2, record).data());
            EXPECT_EQ(found.id, 22);
            EXPECT_EQ(found.options, 1);
            EXPECT_EQ(found.p1, 255);
            EXPECT_EQ(found.p2, p2);
            EXPECT_EQ(found.p3, p3);
            EXPECT_EQ(found.p4, -(p3 / 2));
        }
    }
    for (int32_t p2 : ends32) {
        const Record record = {0x60, 0, 255, p2, -7, 9};
        const Record found = mission::unpack(Set::apm1, packed(Set::apm1, record).data());
        EXPECT_EQ(found.options, 0);
        EXPECT_EQ(found.p1, 255);
        EXPECT_EQ(found.p2, p2);
        EXPECT_EQ(found.p3, -7);
        EXPECT_EQ(found.p4, 9);
    }
}

TEST(Record, every_14_bytes_survive_unpacking_and_packing) {
    uint32_t random = 1;
    for (int i = 0; i < 10000; ++i) {
        Bytes bytes;
        for (uint8_t& byte : bytes)
            byte = static_cast<uint8_t>((random = random * 1664525u + 1013904223u) >> 24);
        for (Set set : {Set::apm1, Set::apm2})
            ASSERT_EQ(packed(set, mission::unpack(set, bytes.data())), bytes);
    }
}

TEST(Record, a_value_beyond_24_bits_fits_apm1_only) {
    const Record high = {16, 0, 0, 8388608, 0, 0}, low = {16, 0, 0, -8388609, 0, 0};
    EXPECT_FALSE(fits(Set::apm2, high));
    EXPECT_FALSE(fits(Set::apm2, low));
    EXPECT_TRUE(fits(Set::apm1, high));
    EXPECT_TRUE(fits(Set::apm1, low));
    EXPECT_FALSE(fits(Set::apm1, Record{16, 1, 0, 0, 0, 0})) << "no byte for options";
}

}  // namespace
