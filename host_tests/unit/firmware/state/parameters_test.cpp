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
    } kCases[] = {{"RC2_MAX", 1600},    {"RC2_MIN", 1400},   {"RC1_REV", -1},
                  {"RC8_DZ", 10},       {"RCMAP_PITCH", 4},  {"FLTMODE_CH", 5},
                  {"ELEVON_OUTPUT", 1}, {"VTAIL_OUTPUT", 2}, {"RC5_FUNCTION", 3},
                  {"RC8_FUNCTION", 2}};
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
    EXPECT_TRUE(parameterSet(slot::ofChannel(2, slot::trim), 1510))
        << "a mission has been written so";
}

}  // namespace
