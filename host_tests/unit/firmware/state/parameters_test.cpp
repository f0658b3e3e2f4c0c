// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/state/parameters.hpp"

#include <string.h>

#include <set>
#include <string>

#include "firmware/state/parameter_slots.hpp"
#include "firmware_bench.hpp"
#include "storage/owner.hpp"

namespace {

TEST(ParameterTable, no_two_parameters_have_one_name) {
    std::set<std::string> names;
    for (uint16_t i = 0; i < firmware::state::parameterCount(); ++i) {
        char name[16] = {};
        float value = 0;
        uint8_t type = 0;
        ASSERT_TRUE(firmware::state::parameterAt(i, name, value, type));
        const std::string text(name, strnlen(name, sizeof name));
        EXPECT_TRUE(names.insert(text).second) << text << " is the name of two rows";
    }
    EXPECT_GT(names.size(), 100u);
}

using Rigging = bench::Bench;

// What sticks and servos mean cannot be changed under way: elevator and ailerons the wrong way
// round are a crash within seconds.
TEST_F(Rigging, is_changed_while_disarmed_only) {
    using namespace firmware::state;
    while (storage::claim() == core::Status::busy) fakes::advance_ms(10);
    while (parametersLoad() != core::Status::ok) fakes::advance_ms(10);
    const struct {
        const char* name;
        float value;
    } kCases[] = {{"RC2_MAX", 1600},    {"RC2_MIN", 1400},    {"RC1_REV", -1},
                  {"RC8_DZ", 10},       {"RCMAP_PITCH", 4},   {"FLTMODE_CH", 5},
                  {"ELEVON_OUTPUT", 1}, {"VTAIL_OUTPUT", 2},  {"RC5_FUNCTION", 3},
                  {"RC8_FUNCTION", 2},  {"INS_ACCOFFS_X", 1}, {"INS_ACCSCAL_Z", 1.1f},
                  {"RUDDER_ONLY", 1}};
    for (const auto& each : kCases) {
        char name[16] = {};
        strncpy(name, each.name, sizeof name);
        uint16_t index = 0;
        ASSERT_TRUE(parameterFind(name, index)) << each.name;
        mutable_vehicle.armed = true;
        EXPECT_EQ(parameterSetAt(index, each.value), core::Status::denied) << each.name;
        mutable_vehicle.armed = false;
        core::Status status;
        while ((status = parameterSetAt(index, each.value)) == core::Status::busy) {
            parametersRun();
            fakes::advance_ms(10);
        }
        EXPECT_EQ(status, core::Status::ok) << each.name;
    }
    char name[16] = "LIM_ROLL_CD";
    uint16_t index = 0;
    ASSERT_TRUE(parameterFind(name, index));
    mutable_vehicle.armed = true;
    EXPECT_NE(parameterSetAt(index, 4000), core::Status::denied);
}

// At both ends of their rows: in range, but no mode and no function of this firmware.
TEST_F(Rigging, takes_no_mode_and_no_function_that_there_is_not) {
    using namespace firmware::state;
    while (storage::claim() == core::Status::busy) fakes::advance_ms(10);
    while (parametersLoad() != core::Status::ok) fakes::advance_ms(10);
    constexpr float kAvoid = 14, kNoFunction = 13;
    const struct {
        const char* name;
        float value;
    } kCases[] = {{"FLTMODE1", kAvoid},
                  {"INITIAL_MODE", kAvoid},
                  {"RC5_FUNCTION", kNoFunction},
                  {"RC8_FUNCTION", kNoFunction}};
    for (const auto& each : kCases) {
        char name[16] = {};
        strncpy(name, each.name, sizeof name);
        uint16_t index = 0;
        ParameterLimits limits;
        ASSERT_TRUE(parameterFind(name, index) && parameterLimits(index, limits)) << each.name;
        ASSERT_LE(each.value, limits.highest) << each.name;
        EXPECT_EQ(parameterSetAt(index, each.value), core::Status::bad_argument) << each.name;
    }
}

TEST_F(Rigging, is_not_changed_by_a_mission_either_while_armed) {
    using namespace firmware::state;
    const uint8_t trim = slot::ofChannel(2, slot::trim);
    mutable_vehicle.armed = true;
    const uint8_t kSlots[] = {trim, slot::ofChannel(2, slot::max), slot::rcmap_roll,
                              slot::elevon_output, slot::rc5_function};
    for (const uint8_t slot : kSlots) {
        float before, after;
        ASSERT_TRUE(parameterGet(slot, before));
        EXPECT_FALSE(parameterSet(slot, before)) << int(slot);
        ASSERT_TRUE(parameterGet(slot, after));
        EXPECT_EQ(after, before);
    }
    mutable_vehicle.armed = false;
    EXPECT_TRUE(parameterSet(trim, 1510));
    EXPECT_EQ(parameters.channel[1].trim_us, 1510);
}

TEST_F(Rigging, is_not_the_pulses_of_a_free_channel) {
    using namespace firmware::state;
    mutable_vehicle.armed = true;
    const uint8_t max = slot::ofChannel(5, slot::max);
    EXPECT_TRUE(parameterSet(max, 1800));
    EXPECT_FALSE(parameterSet(slot::ofChannel(5, slot::reverse), -1));
    EXPECT_FALSE(parameterSet(max, 1400)) << "below its trim";
    EXPECT_FALSE(parameterSet(slot::ofChannel(4, slot::max), 1800)) << "a stick's";
    for (int8_t* stick : {&parameters.map_roll, &parameters.map_pitch, &parameters.map_throttle,
                          &parameters.map_yaw}) {
        const int8_t was = *stick;
        *stick = 5;
        EXPECT_FALSE(parameterSet(max, 1850)) << "a stick's";
        *stick = was;
    }
    parameters.output_function[0] = 2;
    EXPECT_FALSE(parameterSet(max, 1850)) << "a servo's";
    EXPECT_EQ(parameters.channel[4].max_us, 1800);
}

// 1100, 1500 and 1900 us at first.
TEST_F(Rigging, leaves_every_stick_both_its_ways) {
    using namespace firmware::state;
    const struct {
        uint8_t channel;
        slot::ChannelPart part;
        int16_t us;
        bool taken;
    } kCases[] = {
        {2, slot::max, 1500, false},     {2, slot::max, 1501, true},   {2, slot::min, 1500, false},
        {2, slot::min, 1499, true},      {2, slot::trim, 1100, false}, {2, slot::trim, 1101, true},
        {2, slot::trim, 1900, false},    {2, slot::trim, 1899, true},  {8, slot::max, 1000, false},
        {3, slot::trim, 1100, true},     {3, slot::trim, 1099, false}, {3, slot::trim, 1900, false},
        {1, slot::dead_zone, 200, true},
    };
    for (const auto& each : kCases) {
        fakes::reset();
        while (parametersLoad() != core::Status::ok) fakes::advance_ms(10);
        const uint8_t number = slot::ofChannel(each.channel, each.part);
        EXPECT_EQ(parameterSet(number, each.us), each.taken) << int(number) << " " << each.us;
        uint16_t index;
        ASSERT_TRUE(parameterOfSlot(number, index));
        EXPECT_EQ(parameterSetAt(index, each.us) == core::Status::bad_argument, !each.taken);
    }
}

TEST_F(Rigging, is_not_all_that_a_mission_may_not_set) {
    using namespace firmware::state;
    for (const uint8_t number : {slot::serial_force, slot::sign_policy, slot::afs_term_action}) {
        float before = -1, after = -1;
        EXPECT_TRUE(parameterGet(number, before));
        EXPECT_FALSE(parameterSlotTakes(number, 1 - before)) << int(number);
        EXPECT_FALSE(parameterSet(number, 1 - before)) << int(number);
        EXPECT_TRUE(parameterGet(number, after));
        EXPECT_EQ(after, before) << int(number);
    }
}

}  // namespace
