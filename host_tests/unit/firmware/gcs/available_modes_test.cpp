// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/gcs/available_modes.hpp"

#include "firmware/state/mode_traits.hpp"
#include "ground.hpp"

using firmware::state::Mode;
using mavlink::MavCmd;
using mavlink::MavResult;

namespace {

constexpr uint16_t kAvailableModes = mavlink::Wire<mavlink::AvailableModes>::id;
constexpr uint16_t kCurrentMode = mavlink::Wire<mavlink::CurrentMode>::id;

struct Expected {
    Mode mode;
    const char* name;
    uint8_t standard;     // MAV_STANDARD_MODE
    uint32_t properties;  // MAV_MODE_PROPERTY: 2 not for the user to choose, 4 automatic
};
constexpr Expected kExpected[] = {
    {Mode::manual, "MANUAL", 0, 0},
    {Mode::circle, "CIRCLE", 0, 4},
    {Mode::stabilize, "STABILIZE", 0, 0},
    {Mode::training, "TRAINING", 0, 0},
    {Mode::acro, "ACRO", 0, 0},
    {Mode::fbwa, "FBWA", 0, 0},
    {Mode::fbwb, "FBWB", 4, 0},
    {Mode::cruise, "CRUISE", 3, 0},
    {Mode::autotune, "AUTOTUNE", 0, 0},
    {Mode::automatic, "AUTO", 6, 4},
    {Mode::rtl, "RTL", 5, 4},
    {Mode::loiter, "LOITER", 0, 4},
    {Mode::takeoff, "TAKEOFF", 8, 4},
    {Mode::guided, "GUIDED", 0, 4},
    {Mode::initialising, "INITIALISING", 0, 2},
};
constexpr size_t kModes = sizeof kExpected / sizeof *kExpected;

struct Modes : ground::Telemetry {
    uint8_t ask(float index) { return command(MavCmd::request_message, kAvailableModes, index); }
    std::vector<mavlink::AvailableModes> heard() {
        run_ms(1000);
        return station.all<mavlink::AvailableModes>();
    }
    static std::string nameOf(const mavlink::AvailableModes& mode) {
        return std::string(mode.mode_name, strnlen(mode.mode_name, sizeof mode.mode_name));
    }
    static void expectMode(const mavlink::AvailableModes& mode, size_t index) {
        const Expected& expected = kExpected[index - 1];
        EXPECT_EQ(mode.number_modes, kModes);
        EXPECT_EQ(mode.mode_index, index);
        EXPECT_EQ(mode.custom_mode, static_cast<uint32_t>(expected.mode));
        EXPECT_EQ(nameOf(mode), expected.name);
        EXPECT_EQ(mode.standard_mode, expected.standard) << expected.name;
        EXPECT_EQ(mode.properties, expected.properties) << expected.name;
    }
};

TEST_F(Modes, come_one_after_the_other_when_all_are_asked_for) {
    for (const float all : {0.0f, static_cast<float>(NAN)}) {
        EXPECT_EQ(ask(all), MavResult::accepted);
        const auto modes = heard();
        ASSERT_EQ(modes.size(), kModes);
        for (size_t i = 0; i < kModes; ++i) expectMode(modes[i], i + 1);
        EXPECT_TRUE(second.all<mavlink::AvailableModes>().empty());
        EXPECT_TRUE(heard().empty()) << "once";
    }
}

TEST_F(Modes, come_alone_when_one_is_asked_for) {
    for (size_t index = 1; index <= kModes; ++index) {
        EXPECT_EQ(ask(static_cast<float>(index)), MavResult::accepted);
        const auto modes = heard();
        ASSERT_EQ(modes.size(), 1u);
        expectMode(modes[0], index);
    }
}

TEST_F(Modes, that_are_not_there_are_denied) {
    for (const float none : {kModes + 1.0f, 255.0f, 256.0f, 257.0f, -1.0f, 1.5f, 1e9f})
        EXPECT_EQ(ask(none), MavResult::denied) << none;
    EXPECT_TRUE(heard().empty());
}

TEST_F(Modes, come_all_on_a_slow_line_that_streams_fill) {
    memset(&firmware::state::parameters.streams[0], 10,
           sizeof firmware::state::parameters.streams[0]);
    station.line().endless = false;
    ask(0);
    for (int i = 0; i < 6000; ++i) {  // 9600 baud
        station.line().room =
            static_cast<uint8_t>(std::min<double>(station.line().room + 9.6, hal::kLinkRoom));
        run_ms(10);
    }
    const auto modes = station.all<mavlink::AvailableModes>();
    ASSERT_EQ(modes.size(), kModes);
    for (size_t i = 0; i < kModes; ++i) EXPECT_EQ(modes[i].mode_index, i + 1);
}

TEST_F(Modes, are_asked_for_on_each_link_by_itself) {
    EXPECT_EQ(ask(0), MavResult::accepted);
    mavlink::CommandLong message = {};
    message.command = MavCmd::request_message;
    message.param1 = kAvailableModes;
    message.param2 = 3;
    second.send(message);
    EXPECT_EQ(heard().size(), kModes);
    const auto modes = second.all<mavlink::AvailableModes>();
    ASSERT_EQ(modes.size(), 1u);
    expectMode(modes[0], 3);
}

// Whatever the firmware can be in has a name, and can be chosen unless it says that it cannot.
TEST_F(Modes, are_those_of_the_firmware) {
    for (int number = 0; number <= 255; ++number) {
        const auto mode = static_cast<uint8_t>(number);
        size_t found = 0;
        for (const Expected& expected : kExpected)
            if (static_cast<uint8_t>(expected.mode) == mode && expected.properties != 2) ++found;
        EXPECT_EQ(found, firmware::state::isMode(mode) ? 1u : 0u) << number;
    }
}

TEST_F(Modes, have_the_same_standard_mode_while_they_are_flown) {
    for (const Expected& expected : kExpected) {
        firmware::state::mutable_vehicle.mode = expected.mode;
        EXPECT_EQ(command(MavCmd::request_message, kCurrentMode), MavResult::accepted);
        run_ms(100);
        const auto current = station.all<mavlink::CurrentMode>().at(0);
        EXPECT_EQ(current.custom_mode, static_cast<uint32_t>(expected.mode));
        EXPECT_EQ(current.intended_custom_mode, static_cast<uint32_t>(expected.mode));
        EXPECT_EQ(current.standard_mode, expected.standard) << expected.name;
    }
}

}  // namespace
