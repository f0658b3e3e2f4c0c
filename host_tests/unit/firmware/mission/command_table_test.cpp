// SPDX-License-Identifier: GPL-3.0-or-later
// Every row of both command tables: its class, the ranges of its fields, its way up and down.
#include <set>

#include "firmware/mission/handlers.hpp"
#include "mission_rig.hpp"
#include "samples.hpp"

namespace firmware {
using namespace mission;
namespace {

using ::mission::Class;
using ::mission::Set;

class Rows : public Rig {
protected:
    template <class Look>
    static void forEveryRow(Look look) {
        for (const Set set : {kSet1, kSet2})
            for (uint8_t row = 0; row < kCommandTable.count; ++row)
                if (kCommandTable.id(set, row) != ::mission::kNoId) look(set, row);
    }
};

TEST_F(Rows, have_a_valid_record_each_and_every_id_has_a_row) {
    forEveryRow([](Set set, uint8_t row) {
        const uint8_t id = kCommandTable.id(set, row);
        EXPECT_EQ(sampleOf(set, id).id, id) << "no sample";
        EXPECT_EQ(answerTo(set, sampleOf(set, id)), 0) << int(set) << " id " << int(id);
    });
    for (const Sample& sample : kSamples)
        EXPECT_NE(kCommandTable.find(sample.set, sample.record.id), ::mission::kNoRow);
}

// The two documents that name the sets, and what missions of this board hold besides.
TEST_F(Rows, outside_the_documents_are_marked_as_such) {
    std::set<int> beyond;
    forEveryRow([&](Set set, uint8_t row) {
        if ((kCommandTable.traits(row) & ::mission::kArduPlaneExtension) == 0) return;
        EXPECT_EQ(set, kSet2);
        beyond.insert(kCommandTable.id(set, row));
    });
    EXPECT_EQ(beyond, (std::set<int>{30,  31,  93,  115, 189, 191, 195, 197, 201, 203, 205,
                                     206, 207, 210, 212, 214, 240, 241, 242, 243, 244, 245}));
}

TEST_F(Rows, are_of_the_class_that_their_id_says) {
    forEveryRow([](Set set, uint8_t row) {
        const uint8_t id = kCommandTable.id(set, row);
        const bool nav = id < 0x20;
        const bool condition = set == kSet1 ? id >= 0x20 && id < 0x30 : id >= 0x70 && id < 0x80;
        const Class kind = kCommandTable.kind(row);
        EXPECT_EQ(kind == Class::nav, nav) << int(set) << " id " << int(id);
        EXPECT_EQ(kind == Class::condition, condition) << int(set) << " id " << int(id);
    });
}

// What a field takes and what it does not, as ids, fields and ends. A field without a row here
// takes all that there is room for.
struct Ends {
    Set set;
    uint8_t id;
    int field;
    Intervals taken;
    int answer_param;  // below and above: MAV_MISSION_INVALID_PARAM<n>; 0: INVALID
};
constexpr int32_t kMax = std::numeric_limits<int32_t>::max();
constexpr Interval kLatitudes = {-900000000, 900000000};
constexpr Interval kLongitudes = {-1800000000, 1800000000};

// clang-format off
const std::vector<Ends> kEnds = {
    {kSet2, 0x16, 1, {{0, 60}}, 1},
    {kSet2, 0x70, 3, {{0, 4000000}}, 1},
    {kSet2, 0x71, 1, {{11, 255}}, 1},
    {kSet2, 0x71, 3, {{0, 0}, {11, 10000}}, 1},
    {kSet2, 0x72, 3, {{0, kMax}}, 1},
    {kSet2, 0xB1, 1, {{1, 4}, {6, 19}}, 1},
    {kSet2, 0xB1, 3, {{-1, -1}, {1, 32767}}, 2},
    {kSet2, 0xB2, 1, {{0, 1}}, 1},
    {kSet2, 0xB2, 2, {{-1, -1}, {9, 22}}, 2},
    {kSet2, 0xB2, 3, {{-1, 100}}, 3},
    {kSet2, 0xB2, 4, {{0, 0}, {900, 2200}}, 2},
    {kSet2, 0xB3, 1, {{0, 1}}, 1},
    {kSet2, 0xB4, 2, {{1, 32767}}, 2},
    {kSet2, 0xB5, 1, {{0, 0}}, 1},
    {kSet2, 0xB5, 2, {{0, 1}}, 2},
    {kSet2, 0xB6, 1, {{0, 0}}, 1},
    {kSet2, 0xB6, 2, {{0, 32767}}, 2},
    {kSet2, 0xB6, 3, {{1, 60}}, 3},
    {kSet2, 0xB7, 1, {{5, 8}}, 1},
    {kSet2, 0xB7, 2, {{0, 1}, {800, 2200}}, 2},
    {kSet2, 0xB8, 1, {{5, 8}}, 1},
    {kSet2, 0xB8, 2, {{0, 32767}}, 3},
    {kSet2, 0xB8, 3, {{1, 60}}, 4},
    {kSet2, 0xB8, 4, {{0, 0}, {800, 2200}}, 2},
    {kSet2, 0x1E, 1, {{0, 2}}, 1},
    {kSet2, 0x1F, 1, {{0, 1}}, 1},
    {kSet2, 0xC9, 1, {{0, 4}}, 1},
    {kSet2, 0xCD, 1, {{0, 6}}, 7},
    {kSet2, 0xCD, 2, {{-360, 360}}, 1},
    {kSet2, 0xCD, 3, {{-360, 360}}, 2},
    {kSet2, 0xCD, 4, {{-360, 360}}, 3},
    {kSet2, 0xCE, 2, {{0, 10000}}, 1},
    {kSet2, 0xCE, 3, {{0, 1000000}}, 1},
    {kSet2, 0xCF, 1, {{0, 2}}, 1},
    {kSet2, 0xD2, 1, {{0, 1}}, 1},
    {kSet2, 0xD4, 1, {{0, 1}}, 1},
    {kSet2, 0xF1, 3, {{1, 1}}, 3},
    {kSet1, 0x16, 1, {{0, 60}}, 1},
    {kSet1, 0x21, 1, {{11, 255}}, 1},
    {kSet1, 0x21, 3, {{0, 0}, {11, 10000}}, 1},
    {kSet1, 0x34, 1, {{0, 1}}, 1},
    {kSet1, 0x40, 1, {{9, 22}}, 1},
    {kSet1, 0x41, 1, {{0, 100}}, 1},
    {kSet1, 0x70, 1, {{0, 7}}, 1},
    {kSet1, 0x70, 2, {{800, 2200}}, 2},
    {kSet1, 0x71, 1, {{0, 7}}, 1},
    {kSet1, 0x71, 2, {{800, 2200}}, 2},
    {kSet1, 0x72, 1, {{0, 7}}, 1},
    {kSet1, 0x72, 2, {{800, 2200}}, 2},
    {kSet1, 0x73, 1, {{2, 2}}, 1},
    {kSet1, 0x75, 2, {{1, 4}, {6, 19}}, 2},
    {kSet1, 0x80, 1, {{0, 6}, {10, 10}}, 1},
    {kSet1, 0x80, 2, {{800, 2200}}, 2},
    {kSet1, 0x80, 3, {{0, 65535}}, 3},
    {kSet1, 0x80, 4, {{0, 32767}}, 4},
    {kSet1, 0x81, 1, {{0, 1}}, 1},
    {kSet1, 0x82, 1, {{0, 7}}, 1},
    {kSet1, 0x82, 2, {{0, 2000}}, 2},
};
// clang-format on

// With the places, which are alike in all.
std::vector<Ends> everyEnd() {
    std::vector<Ends> ends = kEnds;
    for (const uint8_t id :
         {0x10, 0x11, 0x12, 0x13, 0x14, 0x15, 0x17, 0x1E, 0x1F, 0xB3, 0xBD, 0xC3, 0xC9}) {
        ends.push_back({kSet2, id, 3, {kLatitudes}, 5});
        ends.push_back({kSet2, id, 4, {kLongitudes}, 6});
    }
    for (const uint8_t id : {0x10, 0x11, 0x12, 0x13, 0x14, 0x15, 0x42}) {
        ends.push_back({kSet1, id, 3, {kLatitudes}, 5});
        ends.push_back({kSet1, id, 4, {kLongitudes}, 6});
    }
    return ends;
}

// Slots and modes, which are gaps and islands, and the ranges of parameters: tested by themselves.
bool isAsATableElsewhereSays(Set set, uint8_t id, int field) {
    if (set == kSet2) return id == 0xB4 && field != 2;
    return id == 0x30 || id == 0x32 || id == 0x33 || (id >= 0x60 && id <= 0x64) ||
           (id == 0x73 && field == 2);
}

std::string written(const Intervals& ranges) {
    std::string text;
    for (const Interval& each : ranges)
        text += std::to_string(each.lowest) + ".." + std::to_string(each.highest) + " ";
    return text;
}

TEST_F(Rows, take_the_whole_range_of_every_field_and_nothing_beyond) {
    const std::vector<Ends> ends = everyEnd();
    forEveryRow([&](Set set, uint8_t row) {
        const ::mission::Record sample = sampleOf(set, kCommandTable.id(set, row));
        for (int field = 1; field <= 4; ++field) {
            if (isAsATableElsewhereSays(set, sample.id, field)) continue;
            Intervals expected = {roomOf(set, field)};
            for (const Ends& each : ends)
                if (each.set == set && each.id == sample.id && each.field == field)
                    expected = each.taken;
            EXPECT_EQ(written(rangesOf(set, sample, field)), written(expected))
                << int(set) << " id " << std::hex << int(sample.id) << " p" << field;
        }
    });
}

TEST_F(Rows, name_the_parameter_that_is_out_of_range) {
    for (const Ends& each : everyEnd()) {
        const ::mission::Record sample = sampleOf(each.set, each.id);
        const Interval room = roomOf(each.set, each.field);
        const auto expected = static_cast<uint8_t>(5 + each.answer_param);
        for (const Interval& taken : each.taken) {
            for (const int64_t beyond : {taken.lowest - int64_t{1}, taken.highest + int64_t{1}}) {
                if (beyond < room.lowest || beyond > room.highest) continue;
                const auto value = static_cast<int32_t>(beyond);
                const uint8_t answer = answerTo(each.set, with(sample, each.field, value));
                EXPECT_EQ(answer, expected) << int(each.set) << " id " << std::hex << int(each.id)
                                            << " p" << each.field << " " << std::dec << value;
            }
        }
    }
}

TEST_F(Rows, a_ground_speed_may_be_up_to_200_mps_whatever_the_air_speeds_are) {
    ::mission::Record record = sampleOf(kSet2, 0xB2);
    record.p1 = 1;
    EXPECT_EQ(written(rangesOf(kSet2, record, 2)), "-1..-1 1..200 ");
    EXPECT_EQ(written(rangesOf(kSet2, record, 4)), "0..20000 ");
}

TEST_F(Rows, a_place_is_not_asked_for_where_home_is_set_here) {
    ::mission::Record record = sampleOf(kSet2, 0xB3);
    record.p1 = 1;
    record.p3 = kMax;
    EXPECT_EQ(answerTo(kSet2, record), 0);
}

TEST_F(Rows, the_index_of_apm1_may_stand_in_p1_where_p2_is_0_and_both_0_are_refused) {
    ::mission::Record record = sampleOf(kSet1, 0x75);
    record.p2 = 0;
    EXPECT_EQ(written(rangesOf(kSet1, record, 1)), "1..4 6..19 ");
    record.p2 = 3;
    EXPECT_EQ(written(rangesOf(kSet1, record, 1)), "0..255 ") << "p2 is the one that counts";
}

TEST_F(Rows, only_existing_modes_may_be_changed_to) {
    int modes = 0;
    for (int mode = 0; mode <= 255; ++mode) {
        const bool there = isMode(static_cast<uint8_t>(mode));
        EXPECT_EQ(answerTo(kSet1, with(sampleOf(kSet1, 0x30), 1, mode)), there ? 0 : 6) << mode;
        modes += there;
    }
    EXPECT_GE(modes, 8);
    EXPECT_FALSE(isMode(16));
}

TEST_F(Rows, a_variable_or_parameter_is_any_slot_that_is_used_and_no_other) {
    for (int slot = 0; slot <= 255; ++slot) {
        float value;
        const bool used = parameterGet(static_cast<uint8_t>(slot), value);
        for (const uint8_t id : {0x32, 0x33})
            EXPECT_EQ(answerTo(kSet1, with(sampleOf(kSet1, id), 1, slot)), used ? 0 : 6) << slot;
        if (used) continue;
        EXPECT_EQ(answerTo(kSet2, with(sampleOf(kSet2, 0xB4), 1, slot)), 6) << slot;
    }
}

TEST_F(Rows, every_gain_is_held_to_the_range_of_its_own_parameter) {
    int gains = 0;
    for (uint8_t id = 0x60; id <= 0x64; ++id) {
        for (int index = 0; index <= 255; ++index) {
            const uint8_t slot = gainSlot(id, static_cast<uint8_t>(index));
            ::mission::Record record = with(sampleOf(kSet1, id), 1, index);
            if (slot == kNoSlot) {
                EXPECT_EQ(answerTo(kSet1, record), 6) << int(id) << " " << index;
                continue;
            }
            ++gains;
            const Intervals taken = rangesOf(kSet1, record, 2);
            ASSERT_EQ(taken.size(), 1u) << int(id) << " " << index;
            const auto gainOf = [](int32_t p2) { return static_cast<float>(p2) / 100000.0f; };
            EXPECT_TRUE(parameterSlotTakes(slot, gainOf(taken[0].highest)));
            if (taken[0].highest != kMax) {
                EXPECT_FALSE(parameterSlotTakes(slot, gainOf(taken[0].highest + 1)));
                EXPECT_EQ(answerTo(kSet1, with(record, 2, taken[0].highest + 1)), 7);
            }
            EXPECT_EQ(answerTo(kSet1, with(record, 2, taken[0].lowest - 1)), 7);
        }
    }
    EXPECT_EQ(gains, 24);
}

TEST_F(Rows, survive_download_and_upload_unchanged) {
    for (const Sample& sample : kSamples) {
        MissionItem item;
        decodeItem(sample.set, kSamplePosition.index, sample.record, item);
        ::mission::Record again;
        EncodeWarnings warnings = {};
        ASSERT_EQ(encodeItem(sample.set, kSamplePosition, item, again, warnings),
                  MissionResult::accepted)
            << int(sample.set) << " id " << int(sample.record.id);
        uint8_t bytes[::mission::kRecordSize], expected[::mission::kRecordSize];
        ::mission::pack(sample.set, again, bytes);
        ::mission::pack(sample.set, sample.record, expected);
        EXPECT_EQ(memcmp(bytes, expected, sizeof bytes), 0)
            << int(sample.set) << " id " << int(sample.record.id);
        EXPECT_FALSE(warnings.rounded || warnings.dropped) << int(sample.record.id);
    }
}

TEST_F(Rows, above_terrain_is_refused_of_every_command_with_an_altitude) {
    for (const Sample& sample : kSamples) {
        if (sample.set == kSet1) continue;
        MissionItem item;
        decodeItem(kSet2, kSamplePosition.index, sample.record, item);
        const bool altitude = item.z != 0 && sample.record.id != 0xCD;  // a mount's z is a number
        ::mission::Record record = sample.record;
        record.options = ::mission::kAboveTerrain;
        EXPECT_EQ(answerTo(kSet2, record), altitude ? 2 : 0) << int(record.id);
    }
}

TEST_F(Rows, halves_of_a_centimetre_are_rounded_away_from_zero) {
    for (const float altitude_m : {0.125f, -0.125f}) {
        MissionItem item = waypoint(100, altitude_m);
        const int32_t expected_cm = altitude_m > 0 ? 13 : -13;
        ::mission::Record record;
        EncodeWarnings warnings = {};
        ASSERT_EQ(encodeItem(kSet2, kSamplePosition, item, record, warnings),
                  MissionResult::accepted);
        EXPECT_EQ(record.p2, expected_cm);
    }
}

}  // namespace
}  // namespace firmware
