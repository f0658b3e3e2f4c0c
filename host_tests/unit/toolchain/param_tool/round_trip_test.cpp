// SPDX-License-Identifier: GPL-3.0-or-later
#include <random>

#include "rig.hpp"
#include "toolchain/mission_tool/board.hpp"

namespace param_tool {
namespace {

using testing::HasSubstr;

// A value other than the default that the firmware takes where the parameters before it are set.
float drawn(const Parameter& p, std::mt19937& random) {
    constexpr int kTries = 1000;
    std::uniform_real_distribution<float> share;
    for (int tries = 0; tries < kTries; ++tries) {
        float value = p.lowest + (p.highest - p.lowest) * share(random);
        if (p.whole) value = std::round(value);
        if (value == p.initial) continue;
        std::vector<Finding> refusals;
        set({{p.name, value, 1, 1, 1}}, "", {}, refusals);
        if (refusals.empty()) return value;
    }
    ADD_FAILURE() << "no value but the default is taken for " << p.name;
    return p.initial;
}

TEST_F(ParamTool, gives_back_what_was_compiled_in_every_form_of_image) {
    ASSERT_EQ(param({"show"}), 0);
    std::string text;
    std::mt19937 random(1);
    powerUp(mission_tool::blankImage(), "");
    for (const Parameter& p : parameters()) {
        if (!p.stored) continue;
        // FORMAT_VERSION has one value that does not take all the others back
        const float value = p.name == "FORMAT_VERSION" ? p.initial : drawn(p, random);
        text += p.name + ',' + spelled(value) + '\n';
    }
    const std::string all = file("all.param", text);
    for (const char* name : {"all.bin", "all.eep", "all.hex"}) {
        ASSERT_EQ(param({"compile", all, "-o", path(name)}), 0) << err_;
        ASSERT_EQ(param({"decode", path(name)}), 0) << err_;
        EXPECT_EQ(out_, text) << name;
        ASSERT_EQ(param({"decode", path(name), "-o", path("again.param")}), 0);
        ASSERT_EQ(param({"check", path("again.param")}), 0) << err_;
    }
}

TEST_F(ParamTool, keeps_the_mission_and_the_parameters_that_are_not_named) {
    using namespace mission_tool;
    ASSERT_EQ(param({"compile", file("a.param", "WP_LOITER_RAD,77\n"), "-o", path("a.bin")}), 0);
    ASSERT_EQ(tool({"compile", file("m.waypoints", kTwoWaypoints), "--onto", path("a.bin"), "-o",
                    path("board.eep")}),
              0)
        << err_;
    ASSERT_EQ(param({"compile", file("b.param", "WP_RADIUS,42\n"), "--onto", path("board.eep"),
                     "-o", path("new.eep")}),
              0)
        << err_;

    EXPECT_EQ(err_, "");
    EXPECT_EQ(valueIn(path("new.eep"), "WP_RADIUS"), "42");
    EXPECT_EQ(valueIn(path("new.eep"), "WP_LOITER_RAD"), "77");
    const auto stored = storedMission(imageOf(readFile(path("new.eep")), ""), "");
    EXPECT_EQ(stored.entries.size(), 3u);
}

TEST_F(ParamTool, says_that_a_whole_image_takes_the_mission_away) {
    ASSERT_EQ(param({"compile", file("a.param", "WP_RADIUS,42\n"), "-o", path("a.bin")}), 0);
    EXPECT_THAT(err_, HasSubstr("leaves no mission"));
}

TEST_F(ParamTool, makes_the_image_that_a_ground_station_would_leave) {
    ASSERT_EQ(param({"compile", file("a.param", "FORMAT_VERSION,0\n"), "-o", path("a.bin")}), 0);
    // the next start forgets: an image is read as the board that boots with it
    EXPECT_EQ(valueIn(path("a.bin"), "FORMAT_VERSION"), "1");
}

TEST_F(ParamTool, spells_every_number_so_that_it_is_read_back) {
    for (const float value :
         {0.0f, -0.0f, 1e-40f, 3.4e38f, -0.1745f, 100000.0f, 1.9936f, 16777216.0f, 0.30000001f}) {
        const std::string text = spelled(value);
        EXPECT_EQ(std::strtof(text.c_str(), nullptr), value) << text;
    }
    EXPECT_EQ(spelled(100000), "100000");
    EXPECT_EQ(spelled(1.9936f), "1.9936");
}

TEST_F(ParamTool, shows_what_differs_from_the_defaults) {
    ASSERT_EQ(param({"show", file("a.param", "WP_RADIUS,42\n")}), 0);
    EXPECT_THAT(out_, HasSubstr("\n* WP_RADIUS         42"));
    EXPECT_THAT(out_, HasSubstr("\n  WP_LOITER_RAD     60"));
    EXPECT_THAT(out_, HasSubstr("1 to 32767"));
    ASSERT_EQ(param({"show", path("a.param"), "--changed"}), 0);
    EXPECT_THAT(out_, HasSubstr("* WP_RADIUS"));
    EXPECT_THAT(out_, testing::Not(HasSubstr("WP_LOITER_RAD")));
    ASSERT_EQ(param({"show"}), 0);
    EXPECT_THAT(out_, testing::Not(HasSubstr("* ")));
}

}  // namespace
}  // namespace param_tool
