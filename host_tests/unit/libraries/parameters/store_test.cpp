// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/store.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "fakes/clock.hpp"
#include "fakes/eeprom.hpp"
#include "storage/eeprom_map.hpp"

namespace {

using core::Status;
using parameters::Table;

struct Fields {
    int8_t small;
    int16_t middle;
    int32_t large;
    float real;
};
Fields fields;

// clang-format off
constexpr parameters::Row kRows[] = {
    PARAMETER(3,  "SMALL",            Fields, small,  1.0f,  -100.0f, 100.0f),
    PARAMETER(7,  "MIDDLE",           Fields, middle, 300.0f, 0.0f,   30000.0f),
    PARAMETER(8,  "LARGE",            Fields, large,  -1.0f, -1.0f,   1000000.0f),
    PARAMETER(12, "SIXTEEN_LETTERS_", Fields, real,   0.25f,  0.0f,   1.0f),
};
constexpr parameters::Row kSlotTwice[] = {
    PARAMETER(3, "A", Fields, small, 1.0f, -100.0f, 100.0f),
    PARAMETER(3, "B", Fields, middle, 1.0f, -100.0f, 100.0f),
};
constexpr parameters::Row kInitialOutside[] = {
    PARAMETER(3, "A", Fields, small, 101.0f, -100.0f, 100.0f),
};
// clang-format on
static_assert(parameters::slotsAreUnique(kRows), "");
static_assert(!parameters::slotsAreUnique(kSlotTwice), "");
constexpr uint8_t kRetiredElsewhere[] = {0, 4}, kRetiredHere[] = {9, 8};
static_assert(parameters::slotsAvoid(kRows, kRetiredElsewhere), "");
static_assert(!parameters::slotsAvoid(kRows, kRetiredHere), "");
constexpr uint8_t kFirstFour[] = {2, 0, 4, 1};
static_assert(parameters::lowestFreeSlot(kRows, kRetiredElsewhere) == 1, "");
static_assert(parameters::lowestFreeSlot(kRows, kFirstFour) == 5, "");
static_assert(parameters::initialsAreInRange(kRows), "");
static_assert(!parameters::initialsAreInRange(kInitialOutside), "");

constexpr uint8_t kSmall = 0, kMiddle = 1, kLarge = 2, kReal = 3;
constexpr core::CodePair kPairs[] = {{'A', 'L'}, {'E', 0x80}, {'T', 'E'}};
constexpr parameters::Packed<core::count(kRows), parameters::distinctNumbers(kRows),
                             parameters::nameCodes(kRows, kPairs), core::count(kPairs)>
    kPacked ROM(kRows, kPairs);
static_assert(parameters::distinctNumbers(kRows) == 9, "1, -1 and 0 come twice");
constexpr Table table ROM(kPacked, &fields);

void loadAll() {
    for (int i = 0; i < 100; ++i) {
        if (parameters::load(table) == Status::ok) return;
        fakes::advance_ms(10);
    }
    FAIL() << "never loaded";
}

struct ParameterStore : testing::Test {
    void SetUp() override {
        fakes::resetClock();
        fakes::resetEeprom();
        fields = {};
        loadAll();
    }
};

TEST(Table, a_value_of_each_width_is_the_field_s) {
    fields = {-100, 30000, 1000000, 0.75f};
    EXPECT_EQ(table.value(0), -100);
    EXPECT_EQ(table.value(1), 30000);
    EXPECT_EQ(table.value(2), 1000000);
    EXPECT_EQ(table.value(3), 0.75f);
}

TEST_F(ParameterStore, gives_a_blank_eeprom_the_initial_values) {
    EXPECT_EQ(fields.small, 1);
    EXPECT_EQ(fields.middle, 300);
    EXPECT_EQ(fields.large, -1);
    EXPECT_EQ(fields.real, 0.25f);
}

TEST_F(ParameterStore, reads_back_after_a_restart_what_was_saved) {
    ASSERT_EQ(parameters::save(table, kMiddle, 1234), Status::ok);
    ASSERT_EQ(parameters::save(table, kReal, 0.7f), Status::ok);

    fakes::restartEeprom();
    loadAll();

    EXPECT_EQ(fields.middle, 1234);
    EXPECT_EQ(fields.real, 0.7f);
    EXPECT_EQ(fields.small, 1);
}

TEST_F(ParameterStore, replaces_a_stored_value_out_of_range_by_the_initial_one) {
    const float wrong = 31000;
    uint8_t bytes[4];
    std::memcpy(bytes, &wrong, 4);
    for (int i = 0; i < 4; ++i) fakes::setEepromCell(storage::parameterAddress(7) + i, bytes[i]);

    loadAll();

    EXPECT_EQ(fields.middle, 300);
}

TEST_F(ParameterStore, saves_later_what_had_no_room_and_loses_none) {
    fakes::setEepromSlow(true);
    fields = {-5, 77, 4242, 0.5f};
    for (uint8_t i = 0; i < 4; ++i) parameters::saveLater(i);

    for (int i = 0; i < 200; ++i) {
        parameters::saveWaiting(table);
        fakes::advance_ms(10);
    }
    fakes::restartEeprom();
    fields = {};
    loadAll();

    EXPECT_EQ(fields.small, -5);
    EXPECT_EQ(fields.middle, 77);
    EXPECT_EQ(fields.large, 4242);
    EXPECT_EQ(fields.real, 0.5f);
}

TEST_F(ParameterStore, leaves_the_old_or_the_new_value_whenever_the_power_is_cut) {
    ASSERT_EQ(parameters::save(table, kReal, 0.125f), Status::ok);
    const auto before = fakes::eepromCells();
    bool old_seen = false;
    bool new_seen = false;

    for (uint32_t cut = 0; cut < 16; ++cut) {
        fakes::resetEeprom();
        fakes::setEepromCells(before);
        loadAll();
        fakes::cutPowerAfter(cut);
        ASSERT_EQ(parameters::save(table, kReal, 0.875f), Status::ok);
        fakes::restartEeprom();
        loadAll();
        ASSERT_TRUE(fields.real == 0.125f || fields.real == 0.875f) << cut << ": " << fields.real;
        old_seen |= fields.real == 0.125f;
        new_seen |= fields.real == 0.875f;
    }

    EXPECT_TRUE(old_seen);
    EXPECT_TRUE(new_seen);
}

TEST(ParameterTable, finds_a_name_of_all_sixteen_letters_and_no_other) {
    uint8_t index = 99;
    EXPECT_TRUE(table.findName(
        {'S', 'I', 'X', 'T', 'E', 'E', 'N', '_', 'L', 'E', 'T', 'T', 'E', 'R', 'S', '_'}, index));
    EXPECT_EQ(index, kReal);
    EXPECT_TRUE(table.findName({'L', 'A', 'R', 'G', 'E'}, index));
    EXPECT_EQ(index, kLarge);
    EXPECT_FALSE(table.findName({'L', 'A', 'R', 'G'}, index));
    EXPECT_FALSE(table.findName({'L', 'A', 'R', 'G', 'E', 'R'}, index));
}

TEST(ParameterTable, takes_only_finite_values_within_the_range) {
    EXPECT_TRUE(table.fits(kSmall, -100));
    EXPECT_FALSE(table.fits(kSmall, -100.5f));
    EXPECT_FALSE(table.fits(kSmall, std::nanf("")));
    EXPECT_FALSE(table.fits(kSmall, std::numeric_limits<float>::infinity()));
}

TEST(ParameterTable, rounds_to_the_type_of_the_field_and_says_what_it_holds) {
    EXPECT_EQ(table.assign(kSmall, -2.5f), -3);
    EXPECT_EQ(table.assign(kMiddle, 29999.6f), 30000);
    EXPECT_EQ(table.assign(kReal, 0.3f), 0.3f);
    EXPECT_EQ(table.value(kSmall), -3);
    EXPECT_EQ(table.type(kMiddle), parameters::Type::int16);
}

}  // namespace
