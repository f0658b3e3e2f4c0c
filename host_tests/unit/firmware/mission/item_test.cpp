// SPDX-License-Identifier: GPL-3.0-or-later
// Items up and down: what is stored, what is read back, what is refused.
#include "mission_rig.hpp"

namespace firmware {
namespace {

class Item : public Rig {
protected:
    // The 14 bytes that item 1 became.
    static ::mission::Record record(const MissionItem& item) {
        EXPECT_EQ(upload({item, waypoint(100), waypoint(200)}), MissionResult::accepted);
        uint8_t bytes[::mission::kRecordSize];
        EXPECT_EQ(mission_store.read(1, bytes), core::Status::ok);
        return ::mission::unpack(missionSet(), bytes);
    }
    static void expectFields(const MissionItem& item, int options, int p1, int32_t p2, int32_t p3,
                             int32_t p4) {
        const ::mission::Record found = record(item);
        EXPECT_EQ(int(found.id), item.command);
        EXPECT_EQ(int(found.options), options) << item.command;
        EXPECT_EQ(int(found.p1), p1) << item.command;
        EXPECT_EQ(found.p2, p2) << item.command;
        EXPECT_EQ(found.p3, p3) << item.command;
        EXPECT_EQ(found.p4, p4) << item.command;
    }
};

constexpr int32_t kLatitude = 470900000, kLongitude = 80264000;
MissionItem at(uint16_t id, float p1 = 0, float p2 = 0, float p3 = 0, float p4 = 0) {
    return {id, kRelativeFrame, p1, p2, p3, p4, kLatitude, kLongitude, 123.45f};
}

TEST_F(Item, every_apm2_command_stands_in_its_fields_and_comes_back_as_it_went_up) {
    const MissionItem absolute = {16, kGlobalFrame, 0, 0, 0, 0, -kLatitude, -kLongitude, -12.5f};
    const MissionItem change_alt = {113, kGlobalFrame, 2.5f, 0, 0, 0, 0, 0, 80};
    const MissionItem fast_change = {113, kRelativeFrame, 4.5f, 0, 0, 0, 0, 0, 80};
    struct {
        MissionItem item;
        int options, p1;
        int32_t p2, p3, p4;
    } const cases[] = {
        {at(16), 1, 0, 12345, kLatitude, kLongitude},
        {at(16, 0, 25), 1, 25, 12345, kLatitude, kLongitude},
        {absolute, 0, 0, -1250, -kLatitude, -kLongitude},
        {at(17), 1, 0, 12345, kLatitude, kLongitude},
        {at(17, 0, 0, -1), 5, 0, 12345, kLatitude, kLongitude},
        {at(18, 3), 1, 3, 12345, kLatitude, kLongitude},
        {at(18, 255, 0, -1), 5, 255, 12345, kLatitude, kLongitude},
        {at(19, 120), 1, 12, 12345, kLatitude, kLongitude},
        {at(19, 2550), 1, 255, 12345, kLatitude, kLongitude},
        {at(20), 1, 0, 12345, kLatitude, kLongitude},
        {at(21), 1, 0, 12345, kLatitude, kLongitude},
        {{22, kRelativeFrame, 15, 0, 0, 0, 0, 0, 40}, 1, 15, 4000, 0, 0},
        {at(23, 0, 7), 1, 7, 12345, kLatitude, kLongitude},
        {command(112, 90), 0, 0, 0, 90, 0},
        {change_alt, 0, 250, 8000, 0, 0},
        {fast_change, 1, 255, 8000, 450, 0},
        {command(114, 300), 0, 0, 0, 300, 0},
        {command(177, 2, 5), 0, 2, 0, 5, 0},
        {command(177, 3, -1), 0, 3, 0, -1, 0},
        {command(178, 0, 14, 60), 0, 0, 14, 60, 0},
        {command(178, 0, 12.5f, -1), 0, 0, 13, -1, 1250},
        {command(178, 1, 9, -1), 0, 1, 9, -1, 0},
        {command(178, 0, -1, 0), 0, 0, -1, 0, 0},
        {{179, kGlobalFrame, 0, 0, 0, 0, kLatitude, kLongitude, 500},
         0,
         0,
         50000,
         kLatitude,
         kLongitude},
        {{179, kGlobalFrame, 1, 0, 0, 0, 0, 0, 0}, 0, 1, 0, 0, 0},
        {command(180, 134, 45), 0, 134, 45, 0, 0},
        {command(180, 102, 0.75f), 0, 102, 1, 0x3F400000, 0},
        {command(181, 0, 1), 0, 0, 1, 0, 0},
        {command(182, 0, 10, 4), 0, 0, 10, 4, 0},
        {command(183, 6, 1700), 0, 6, 1700, 0, 0},
        {command(183, 5, 1), 0, 5, 1, 0, 0},
        {command(184, 7, 1900, 3, 2), 0, 7, 3, 2, 1900},
    };
    for (const auto& c : cases) {
        expectFields(c.item, c.options, c.p1, c.p2, c.p3, c.p4);
        EXPECT_EQ(stored(1), c.item);
        EXPECT_EQ(statusTexts().find("rounded"), std::string::npos) << c.item.command;
    }
}

constexpr float kRetiredSlot = 13;  // no parameter has it, nor will have

struct Refusal {
    MissionItem item;
    MissionResult answer;
};
constexpr MissionResult wrong(int parameter) { return static_cast<MissionResult>(5 + parameter); }
MissionItem placedAt(int32_t latitude_e7, int32_t longitude_e7, float z) {
    return {16, kRelativeFrame, 0, 0, 0, 0, latitude_e7, longitude_e7, z};
}
MissionItem climbing(float rate_mps) { return {113, kRelativeFrame, rate_mps, 0, 0, 0, 0, 0, 0}; }

const Refusal kApm2Refusals[] = {
    {at(16, 0, 256), wrong(2)},
    {at(16, 0, -1), wrong(2)},
    {at(16, 0, INFINITY), wrong(2)},
    {placedAt(kLatitude, kLongitude, NAN), wrong(7)},
    {placedAt(kLatitude, kLongitude, 83887), wrong(7)},
    {placedAt(-900000001, kLongitude, 60), wrong(5)},
    {placedAt(kLatitude, 1800000001, 60), wrong(6)},
    {at(17, 0, 0, INFINITY), wrong(3)},
    {at(18, 256), wrong(1)},
    {at(18, -1), wrong(1)},
    {at(19, 2551), wrong(1)},
    {at(19, -10), wrong(1)},
    {at(22, 61), wrong(1)},
    {command(112, -1), wrong(1)},
    {command(112, 1e9f), wrong(1)},
    {climbing(0.1f), wrong(1)},
    {climbing(-2), wrong(1)},
    {command(114, -1), wrong(1)},
    {command(177, 0, 1), wrong(1)},
    {command(177, 4, 1), wrong(1)},
    {command(177, 1, 1), wrong(1)},
    {command(177, 2, 0), wrong(2)},
    {command(177, 2, -2), wrong(2)},
    {command(177, 2, 32768), wrong(2)},
    {command(178, 2, 12), wrong(1)},
    {command(178, 0, 0), wrong(2)},
    {command(178, 0, -2), wrong(2)},
    {command(178, 0, 5), wrong(2)},
    {command(178, 0, 23), wrong(2)},
    {command(178, 0, 12, 101), wrong(3)},
    {command(178, 0, 12, -2), wrong(3)},
    {command(179, 2), wrong(1)},
    {command(180, kRetiredSlot, 1), wrong(1)},
    {command(180, 256, 1), wrong(1)},
    {command(180, 134, 0), wrong(2)},
    {command(180, 102, INFINITY), wrong(2)},
    {command(181, 1, 1), wrong(1)},
    {command(181, 0, 2), wrong(2)},
    {command(182, 0, -1, 4), wrong(2)},
    {command(182, 0, 10, 61), wrong(3)},
    {command(182, 0, 10, 0), wrong(3)},
    {command(183, 4, 1500), wrong(1)},
    {command(183, 9, 1500), wrong(1)},
    {command(183, 5, 799), wrong(2)},
    {command(183, 5, 2201), wrong(2)},
    {command(184, 4, 1500, 1, 2), wrong(1)},
    {command(184, 5, 799, 1, 2), wrong(2)},
    {command(184, 5, 1500, -1, 2), wrong(3)},
    {command(184, 5, 1500, 1, 61), wrong(4)},
    {command(15, 0), MissionResult::unsupported},
    {at(30, 3), wrong(1)},
    {at(31, 2), wrong(1)},
    {at(31, 0, INFINITY), wrong(2)},
    {command(201, 5), wrong(1)},
    {command(203, 256), wrong(1)},
    {command(205, 361), wrong(1)},
    {command(205, 0, -361), wrong(2)},
    {command(205, 0, 0, 361), wrong(3)},
    {{205, kMissionFrame, 0, 0, 0, 0, 0, 0, 7}, wrong(7)},
    {{205, kMissionFrame, 0, 0, 0, 0, 0, 0, 256}, wrong(7)},
    {command(206, -1), wrong(1)},
    {command(206, 0.004f), wrong(1)},
    {command(206, 10001), wrong(1)},
    {command(206, INFINITY), wrong(1)},
    {command(207, 3), wrong(1)},
    {command(210, 2), wrong(1)},
    {command(190, 0), MissionResult::unsupported},
    {command(0x116, 0), MissionResult::unsupported},
    {command(0x40, 12), MissionResult::unsupported},
};

TEST_F(Item, every_apm2_command_refuses_what_is_out_of_range_and_names_the_parameter) {
    for (const Refusal& refusal : kApm2Refusals)
        EXPECT_EQ(answer(refusal.item), refusal.answer) << testing::PrintToString(refusal.item);
}

TEST_F(Item, only_frames_whose_altitude_is_understood_are_taken) {
    for (int frame = 0; frame < 20; ++frame) {
        MissionItem item = at(16);
        item.frame = static_cast<uint8_t>(frame);
        const bool known = frame == 0 || frame == 2 || frame == 3 || frame == 5 || frame == 6;
        EXPECT_EQ(answer(item), known ? MissionResult::accepted : MissionResult::unsupported_frame)
            << frame;
    }
}

TEST_F(Item, a_rounded_value_is_reported_and_reads_back_as_stored) {
    EXPECT_EQ(roundTrip(at(19, 44)).param1, 40);
    EXPECT_TRUE(hasStatusText("rounded"));
    EXPECT_EQ(roundTrip(at(19, 45)).param1, 50) << "halves away from zero";
    EXPECT_EQ(roundTrip(at(19, 1)).param1, 10) << "a time above 0 is at least one unit";
    EXPECT_EQ(roundTrip(at(18, 1.5f)).param1, 2);
    (void)statusTexts();
    EXPECT_EQ(roundTrip(command(112, 2.4f)).param1, 2);
    EXPECT_TRUE(hasStatusText("rounded"));
}

TEST_F(Item, a_parameter_without_a_field_is_stored_as_0_and_reported_once) {
    MissionItem hold = at(16, 30, 5, 0, 90);
    EXPECT_EQ(upload({hold, hold, hold}), MissionResult::accepted);
    EXPECT_EQ(stored(1).param1, 0);
    EXPECT_EQ(stored(1).param2, 5);
    EXPECT_EQ(stored(1).param4, 0);
    const std::string all = statusTexts();
    const size_t first = all.find("dropped");
    ASSERT_NE(first, std::string::npos);
    EXPECT_EQ(all.find("dropped", first + 1), std::string::npos);
    EXPECT_EQ(roundTrip(at(17, 0, 0, -80)).param3, -1) << "the direction stays, the radius goes";
}

TEST_F(Item, nan_means_unset) {
    MissionItem item = at(18, 2);
    item.param2 = item.param3 = item.param4 = NAN;
    MissionItem expected = at(18, 2);
    EXPECT_EQ(roundTrip(item), expected);
    const MissionItem speed = command(178, 0, NAN, NAN, NAN);
    EXPECT_EQ(roundTrip(speed).param2, -1);
    EXPECT_EQ(stored(1).param3, -1);
    EXPECT_FALSE(hasStatusText("dropped"));
}

TEST_F(Item, speeds_rates_and_parameter_values_are_exact_over_their_whole_range) {
    for (int cms = 900; cms <= 2200; ++cms) {
        ::mission::Record r;
        EncodeWarnings warnings = {};
        const MissionItem item = command(178, 0, cms / 100.0f, -1);
        ASSERT_EQ(encodeItem(::mission::Set::apm2, {1, 4}, item, r, warnings),
                  MissionResult::accepted);
        EXPECT_FALSE(warnings.rounded) << cms;
        MissionItem back;
        decodeItem(::mission::Set::apm2, 1, r, back);
        EXPECT_EQ(back.param2, item.param2);
    }
    for (int cms = 11; cms <= 2000; ++cms) {
        ::mission::Record r;
        EncodeWarnings warnings = {};
        MissionItem item = command(113, cms / 100.0f);
        item.frame = kRelativeFrame;
        ASSERT_EQ(encodeItem(::mission::Set::apm2, {1, 4}, item, r, warnings),
                  MissionResult::accepted);
        EXPECT_EQ(int(r.p1), cms > 255 ? 255 : cms);
        MissionItem back;
        decodeItem(::mission::Set::apm2, 1, r, back);
        EXPECT_EQ(back, item);
    }
}

// What an image may hold is read back and stored again to the same 14 bytes.
TEST_F(Item, every_valid_apm2_record_survives_the_way_down_and_up) {
    uint32_t seed = 7;
    const auto random = [&](uint32_t below) {
        seed = seed * 1664525u + 1013904223u;
        return static_cast<int32_t>((seed >> 8) % below);
    };
    int tried = 0;
    for (int i = 0; i < 400000; ++i) {
        static const uint8_t ids[] = {16,  17,  18,  19,  20,  21,  22,  23,  112, 113,
                                      114, 177, 178, 179, 180, 181, 182, 183, 184};
        ::mission::Record r = {ids[random(19)],
                               static_cast<uint8_t>(random(2) * 4 + random(2)),
                               static_cast<uint8_t>(random(4) == 0 ? random(256) : random(9)),
                               random(2) == 0 ? random(2200) - 1 : random(4000000),
                               random(3) == 0 ? random(200) - 1 : random(900000000),
                               random(2) == 0 ? 0 : random(2200)};
        const bool nav = r.id < 95 || r.id == 179;
        const bool loiter = r.id >= 17 && r.id <= 19;
        if (!loiter) r.options &= 1;
        if (r.id == 112 || r.id == 114) r.p3 %= 100000;
        if (!nav) r.p4 = r.id == 184 ? r.p4 : r.id == 178 && r.p2 != -1 ? r.p4 : 0;
        if (!nav && r.id != 113) r.p3 %= r.id == 180 ? 1 : 100000;
        if (nav && r.p2 > 100000) r.p2 %= 100000;  // beyond, a float has not room for every cm
        const uint8_t row = kCommandTable.find(::mission::Set::apm2, r.id);
        if (kCommandTable.valid(row, r, {1, 20}) != 0) continue;
        MissionItem item;
        decodeItem(::mission::Set::apm2, 1, r, item);
        ::mission::Record again;
        EncodeWarnings warnings = {};
        ASSERT_EQ(encodeItem(::mission::Set::apm2, {1, 20}, item, again, warnings),
                  MissionResult::accepted)
            << testing::PrintToString(item);
        MissionItem item_again;
        decodeItem(::mission::Set::apm2, 1, again, item_again);
        ASSERT_EQ(item, item_again);
        ++tried;
    }
    EXPECT_GT(tried, 50000);
}

// ---- APM 1.0

class Apm1Item : public Item {
protected:
    void SetUp() override {
        Item::SetUp();
        parameters.mission_set = 1;
    }
};

TEST_F(Apm1Item, every_command_stands_in_its_fields_and_comes_back_as_it_went_up) {
    struct {
        MissionItem item;
        int p1;
        int32_t p2, p3, p4;
    } const cases[] = {
        {at(0x10), 0, 12345, kLatitude, kLongitude},
        {at(0x10, 25), 25, 12345, kLatitude, kLongitude},
        {at(0x11), 0, 12345, kLatitude, kLongitude},
        {at(0x12, 3), 3, 12345, kLatitude, kLongitude},
        {at(0x13, 12), 12, 12345, kLatitude, kLongitude},
        {at(0x14), 0, 12345, kLatitude, kLongitude},
        {at(0x15), 0, 12345, kLatitude, kLongitude},
        {at(0x16, 15), 15, 12345, kLatitude, kLongitude},
        {command(0x20, 200), 200, 0, 0, 0},
        {command(0x21, 255, 8000, 300), 255, 8000, 300, 0},
        {command(0x30, 5), 5, 0, 0, 0},
        {command(0x32, 134), 134, 0, 0, 0},
        {command(0x33, 134), 134, 0, 0, 0},
        {command(0x34, 1), 1, 0, 0, 0},
        {command(0x40, 14), 14, 0, 0, 0},
        {command(0x41, 60), 60, 0, 0, 0},
        {{0x42, kGlobalFrame, 0, 0, 0, 0, kLatitude, kLongitude, 500},
         0,
         50000,
         kLatitude,
         kLongitude},
        {command(0x60, 0, 45000), 0, 45000, 0, 0},
        {command(0x61, 1, 4000), 1, 4000, 0, 0},
        {command(0x62, 1, 3000), 1, 3000, 0, 0},
        {command(0x64, 1, 50000), 1, 50000, 0, 0},
        {command(0x70, 4, 1510), 4, 1510, 0, 0},
        {command(0x71, 7, 1910), 7, 1910, 0, 0},
        {command(0x72, 0, 1090), 0, 1090, 0, 0},
        {command(0x73, 2, 960), 2, 960, 0, 0},
        {command(0x75, 0, 3), 0, 3, 0, 0},
        {command(0x75, 3), 3, 0, 0, 0},
        {command(0x80, 3, 1800, 5, 10), 3, 1800, 5, 10},
        {command(0x80, 6, 0, 3), 6, 0, 3, 0},
        {command(0x80, 10), 10, 0, 0, 0},
        {command(0x81, 1), 1, 0, 0, 0},
        {command(0x82, 6, 1234), 6, 1234, 0, 0},
    };
    for (const auto& c : cases) {
        expectFields(c.item, 0, c.p1, c.p2, c.p3, c.p4);
        EXPECT_EQ(stored(1), c.item);
    }
    const MissionItem first = command(0x31);
    EXPECT_EQ(upload({waypoint(100), first}), MissionResult::accepted);
    EXPECT_EQ(stored(2), first);
}

TEST_F(Apm1Item, every_command_refuses_what_is_out_of_range) {
    const Refusal cases[] = {
        {at(0x12, 256), wrong(1)},
        {at(0x12, 1.5f), wrong(1)},
        {at(0x16, 61), wrong(1)},
        {command(0x20, 256), wrong(1)},
        {command(0x21, 10, 8000), wrong(1)},
        {command(0x30, 99), wrong(1)},
        {command(0x31), MissionResult::invalid},
        {command(0x32, kRetiredSlot), wrong(1)},
        {command(0x34, 2), wrong(1)},
        {command(0x40, 5), wrong(1)},
        {command(0x41, 101), wrong(1)},
        {command(0x60, 8, 1), wrong(1)},
        {command(0x60, 3, 1), wrong(1)},
        {command(0x60, 0, 500000), wrong(2)},
        {command(0x60, 0, 16777218), wrong(2)},
        {command(0x60, 0, 0.5f), wrong(2)},
        {command(0x64, 2, 1), wrong(1)},
        {command(0x70, 8, 1500), wrong(1)},
        {command(0x70, 1, 799), wrong(2)},
        {command(0x73, 0, 1500), wrong(1)},
        {command(0x75), wrong(2)},
        {command(0x75, 0, 4), wrong(2)},
        {command(0x75, 0, 1), wrong(2)},
        {command(0x80, 7, 1500, 2), wrong(1)},
        {command(0x80, 1, 700, 2), wrong(2)},
        {command(0x80, 1, 1500, -1), wrong(3)},
        {command(0x80, 1, 1500, 2, -1), wrong(4)},
        {command(0x81, 2), wrong(1)},
        {command(0x82, 8, 1500), wrong(1)},
        {command(0x82, 4, 2001), wrong(2)},
        {command(177, 1, 1), MissionResult::unsupported},
        {at(0x17), MissionResult::unsupported},
    };
    for (const auto& c : cases)
        EXPECT_EQ(answer(c.item), c.answer) << testing::PrintToString(c.item);
}

TEST_F(Apm1Item, home_lies_above_the_sea_whatever_alt_abs_says) {
    const MissionItem home = {16, kGlobalFrame, 0, 0, 0, 0, kLatitude, kLongitude, 488.25f};
    for (const int8_t absolute : {0, 1}) {
        parameters.altitude_absolute = absolute;
        MissionItem flown = at(0x10);
        flown.frame = absolute != 0 ? kGlobalFrame : kRelativeFrame;
        EXPECT_EQ(uploadRaw({home, flown}), MissionResult::accepted) << int(absolute);
        EXPECT_EQ(stored(0), home);
        EXPECT_EQ(stored(1), flown);
    }
}

TEST_F(Apm1Item, a_frame_that_disagrees_with_alt_abs_is_refused) {
    MissionItem absolute = at(0x10);
    absolute.frame = kGlobalFrame;
    EXPECT_EQ(answer(absolute), MissionResult::unsupported_frame);
    EXPECT_EQ(answer(at(0x10)), MissionResult::accepted);
    parameters.altitude_absolute = 1;
    ::mission::Record r;
    EncodeWarnings warnings = {};
    EXPECT_EQ(encodeItem(::mission::Set::apm1, {1, 4}, absolute, r, warnings),
              MissionResult::accepted);
    EXPECT_EQ(encodeItem(::mission::Set::apm1, {1, 4}, at(0x10), r, warnings),
              MissionResult::unsupported_frame);
}

}  // namespace
}  // namespace firmware
