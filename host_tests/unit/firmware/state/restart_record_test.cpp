// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/state/restart_record.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstring>

namespace {

using namespace firmware;
using namespace firmware::state;

FastRecord movingRecord(uint8_t number) {
    FastRecord record = {};
    record.position = {473977000, 85456000};
    record.at_ms = 1234;
    record.mode = 10;
    record.in_the_air = 1;
    record.number = number;
    updateChecksum(record);
    return record;
}

}  // namespace

// One of another layout must not be taken for one of this: the number changes with the records, and
// here.
TEST(Record, is_sealed_with_Fletchers_sums_that_begin_with_the_number_of_the_layout) {
    const FastRecord record = movingRecord(9);
    uint16_t sum = 0x5203, sum_of_sums = 0;
    uint16_t words[offsetof(FastRecord, checksum) / 2];
    std::memcpy(words, static_cast<const void*>(&record), sizeof words);
    for (const uint16_t word : words) {
        sum = static_cast<uint16_t>(sum + word);
        sum_of_sums = static_cast<uint16_t>(sum_of_sums + sum);
    }
    EXPECT_EQ(record.checksum, uint32_t{sum_of_sums} << 16 | sum);
}

TEST(Record, random_memory_is_no_record) {
    for (int value = 0; value < 256; ++value) {
        SlowRecord steady;
        FastRecord moving[2];
        std::memset(static_cast<void*>(&steady), value, sizeof steady);
        std::memset(static_cast<void*>(moving), value, sizeof moving);
        EXPECT_FALSE(isValid(steady)) << value;
        EXPECT_EQ(newest(moving), nullptr) << value;
    }
}

TEST(Record, any_bit_that_changes_breaks_the_seal) {
    FastRecord record = movingRecord(1);
    ASSERT_TRUE(isValid(record));
    unsigned char* bytes = reinterpret_cast<unsigned char*>(&record);
    for (size_t bit = 0; bit < 8 * offsetof(FastRecord, checksum); ++bit) {
        bytes[bit / 8] ^= 1 << bit % 8;
        EXPECT_FALSE(isValid(record)) << bit;
        bytes[bit / 8] ^= 1 << bit % 8;
    }
}

TEST(Record, a_reset_while_one_is_written_leaves_the_one_before) {
    FastRecord two[2] = {movingRecord(7), movingRecord(8)};
    EXPECT_EQ(newest(two), &two[1]);
    invalidate(two[0]);  // the older one is being written
    EXPECT_EQ(newest(two), &two[1]);
    two[0] = movingRecord(7);
    invalidate(two[1]);  // of both the newer one was hit
    EXPECT_EQ(newest(two), &two[0]);
    two[1] = movingRecord(8);
    two[0] = movingRecord(9);
    EXPECT_EQ(newest(two), &two[0]);
    invalidate(two[1]);
    EXPECT_EQ(newest(two), &two[0]);
    invalidate(two[0]);
    EXPECT_EQ(newest(two), nullptr);
}

TEST(Record, record_numbers_wrap) {
    const FastRecord two[2] = {movingRecord(255), movingRecord(0)};
    EXPECT_EQ(newest(two), &two[1]);
}

TEST(Record, a_changed_record_is_valid_only_after_it_is_sealed_again) {
    SlowRecord record = {};
    updateChecksum(record);
    EXPECT_TRUE(isValid(record));
    invalidate(record);
    EXPECT_FALSE(isValid(record));
    record.home_altitude_cm = 48800;
    EXPECT_FALSE(isValid(record));
    updateChecksum(record);
    EXPECT_TRUE(isValid(record));
}

TEST(Record, what_the_gyros_showed_belongs_to_one_record_and_no_other) {
    FastRecord record = movingRecord(1);
    HangGyroRecord hang = {};
    hang.turn = {{1, 2, 3}, 4};
    updateChecksum(hang, record);
    ASSERT_TRUE(isValid(hang, record));
    for (int bit = 0; bit < 32; ++bit) {
        record.checksum ^= 1u << bit;
        EXPECT_FALSE(isValid(hang, record)) << bit;
        record.checksum ^= 1u << bit;
    }
}

TEST(Record, in_the_air_means_armed_fast_and_high_or_over_the_ground) {
    struct {
        FlightSigns signs;
        bool in_the_air;
        const char* what;
    } const cases[] = {
        {{true, true, 14, 40}, true, "cruising"},
        {{true, true, 1, 40}, true, "against a wind as fast as it is"},
        {{true, true, 14, -30}, true, "below where it started, over a valley"},
        {{true, true, 12, 1}, true, "just off the ground"},
        {{true, true, 0, 5.1f}, true, "standing in the wind over the field"},
        {{true, true, 0, -5.1f}, true, "and beside a slope"},
        {{true, true, 5.1f, 0}, true, "slowly over the runway"},
        {{true, true, 5, 5}, false, "at the bounds of what a drift may show"},
        {{true, true, 5, -5}, false, "on either side"},
        {{true, true, 0, 0}, false, "standing armed in a gale"},
        {{true, false, 4, 0}, false, "rolling"},
        {{true, false, 0, 0}, false, "standing armed"},
        {{false, true, 14, 40}, false, "disarmed in the air"},
    };
    for (const auto& each : cases) EXPECT_EQ(inTheAir(each.signs), each.in_the_air) << each.what;
}

TEST(Record, the_time_lost_is_from_the_record_to_now_over_both_clocks) {
    EXPECT_NEAR(lost_s(1000, 1250, 80 + 60), 0.39f, 1e-4f);
    EXPECT_NEAR(lost_s(65500, 100, 0), 0.136f, 1e-4f) << "the lower half goes round";
    EXPECT_NEAR(lost_s(1000, 1000, 1165 + 80), 1.245f, 1e-4f) << "behind a bootloader that waits";
    EXPECT_NEAR(lost_s(1000, 900, 50), 3.0f, 1e-4f) << "nobody knows: the longest";
}
