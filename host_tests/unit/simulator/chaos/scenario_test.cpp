// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/chaos/scenario.hpp"

#include "simulator/chaos/generator.hpp"

namespace simulator::chaos {

constexpr char kSmall[] =
    "airplane flying_wing\nwind 3.5 120\ngusts 1\nseed 7\nbegins 12\nseconds 90\n"
    "item 16 0 0 0 0 0 47.3977000 8.5456000 488\n"
    "item 22 3 15 0 0 0 0.0000000 0.0000000 45.5\n"
    "zone in 0 47.3950000 8.5400000 47.4000000 8.5400000 47.4000000 8.5500000\n"
    "zone out 55.5 47.3980000 8.5470000\n"
    "return 47.3978000 8.5457000\n"
    "at 30.50 fault gps:lost 12.5\n"
    "at 31.00 param usb RLL2SRV_P nan\n";

TEST(Scenario, reads_back_the_text_it_writes) {
    EXPECT_EQ(textOf(parseScenario(kSmall)), kSmall);
    const auto parameters = readParameterRows(PARAMETERS);
    for (uint64_t seed = 1; seed <= 200; ++seed) {
        const std::string text = textOf(drawScenario(seed, parameters));
        EXPECT_EQ(textOf(parseScenario(text)), text) << seed;
    }
}

TEST(Scenario, reads_each_line_as_it_stands) {
    const Scenario scenario = parseScenario(kSmall);
    EXPECT_EQ(scenario.airplane, "flying_wing");
    EXPECT_EQ(scenario.wind_mps, 3.5);
    EXPECT_TRUE(scenario.gusts);
    EXPECT_EQ(scenario.seed, 7u);
    EXPECT_EQ(scenario.begins_s, 12);
    EXPECT_EQ(scenario.seconds, 90);
    ASSERT_EQ(scenario.mission.size(), 2u);
    EXPECT_EQ(scenario.mission[1].command, 22);
    EXPECT_EQ(scenario.mission[1].index, 1);
    EXPECT_EQ(scenario.mission[1].altitude_m, 45.5);
    ASSERT_EQ(scenario.fence.areas.size(), 2u);
    EXPECT_EQ(scenario.fence.areas[0].rim.size(), 3u);
    EXPECT_TRUE(scenario.fence.areas[0].inclusion);
    EXPECT_EQ(scenario.fence.areas[1].radius_m, 55.5);
    EXPECT_FALSE(scenario.fence.areas[1].inclusion);
    EXPECT_EQ(scenario.fence.way_back.value().longitude_deg, 8.5457);
    ASSERT_EQ(scenario.events.size(), 2u);
    EXPECT_EQ(scenario.events[1].at_s, 31);
    EXPECT_EQ(scenario.events[1].words[3], "nan");
}

TEST(Scenario, writes_a_line_only_for_what_is_unusual) {
    const Scenario scenario =
        parseScenario("tube 0\ndeclination -12.5\nitem 16 0 0 0 0 0 47 8 488\n");
    EXPECT_EQ(scenario.conditions.tube, 0);
    EXPECT_EQ(scenario.conditions.declination_deg, -12.5);
    EXPECT_EQ(scenario.conditions.gps_latency_s, 0.2);
    const std::string text = textOf(scenario);
    EXPECT_NE(text.find("\ntube 0\ndeclination -12.5\nitem"), std::string::npos) << text;
}

TEST(Scenario, sorts_events_and_leaves_comments_out) {
    const Scenario scenario =
        parseScenario("item 16 0 0 0 0 0 47 8 488\nat 9 usb on # later\n# nothing\nat 3 usb off\n");
    EXPECT_EQ(scenario.events[0].words[1], "off");
    EXPECT_EQ(scenario.events[1].words.size(), 2u);
}

std::string errorOf(const std::string& text) {
    try {
        parseScenario(text);
    } catch (const ScenarioError& error) {
        return error.what();
    }
    return "";
}

TEST(Scenario, reports_what_is_wrong_with_its_line) {
    const std::string item = "item 16 0 0 0 0 0 47 8 488\n";
    EXPECT_EQ(errorOf(item + "at 3 usb on\n"), "");
    EXPECT_EQ(errorOf(item + "at 3 hail\n"), "line 2: unknown event: hail");
    EXPECT_EQ(errorOf(item + "at 3 param usb X\n"), "line 2: too few words: param");
    EXPECT_EQ(errorOf(item + "at soon usb on\n"), "line 2: a value is missing");
    EXPECT_EQ(errorOf(item + "zone on 30 47 8\n"), "line 2: a zone is in or out");
    EXPECT_EQ(errorOf(item + "zone in 30 47 8 48 8\n"), "line 2: no circle and no polygon");
    EXPECT_EQ(errorOf(item + "zone in 0 47 8 48 8\n"), "line 2: no circle and no polygon");
    EXPECT_EQ(errorOf(item + "zone in 0 47 8 48\n"), "line 2: a value is missing");
    EXPECT_EQ(errorOf("rain 3\n"), "line 1: unknown: rain");
    EXPECT_EQ(errorOf("seed 3\n"), "line 1: there is no mission");
}

struct Promise {
    const char* events;
    bool survives;
};
TEST(Scenario, knows_which_events_must_not_crash_an_airplane) {
    const Promise all[] = {
        {"", true},
        {"at 60 fault gps:lost 20\n", true},
        {"at 30 fault gps:lost 20\n", false},  // in the take-off
        {"at 60 fault imu:lost 1\n", false},
        {"at 60 fault spi:noisy 1\n", false},  // the inertial sensor's bus
        {"at 60 fault gps:lost 20\nat 65 fault baro:stuck 20\n", true},
        {"at 60 fault gps:lost 20\nat 65 fault baro:stuck 9\nat 70 fault airspeed:lost 9\n", false},
        {"at 60 restart watchdog\n", true},
        {"at 60 restart button\n", false},
        {"at 60 restart watchdog\nat 70 fault gps:lost 5\n", false},
        {"at 20 transmitter off\nat 20 noise usb ffff\n", true},
        {"at 60 mode usb 0\n", false},
        {"at 60 sticks 1500 1500 1100 1500\n", false},
        {"at 60 param usb RLL2SRV_P 3\n", false},
    };
    for (const Promise& each : all) {
        const std::string text = std::string("item 16 0 0 0 0 0 47 8 488\n") + each.events;
        EXPECT_EQ(promisesToSurvive(parseScenario(text)), each.survives) << each.events;
        EXPECT_FALSE(promisesToSurvive(parseScenario("wind 7.1 0\n" + text)));
    }
}

}  // namespace simulator::chaos
