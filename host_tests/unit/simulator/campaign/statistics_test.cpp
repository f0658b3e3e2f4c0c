// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/campaign/statistics.hpp"

#include <gmock/gmock.h>

using namespace simulator;
using testing::ElementsAre;
using testing::IsEmpty;

namespace {

CampaignResult flown(uint64_t seed, double crosstrack_m, double wind_mps = 0) {
    return {{"foam_trainer", "missions/box.waypoints", {wind_mps, 320}, seed},
            true,
            "",
            {{"crosstrack_rms_m", crosstrack_m}},
            100,
            {}};
}

constexpr char kWell[] =
    R"({"completed":true,"emulated_s":10,"frames":1000,"crosstrack_rms_m":0.5,"wind_mps":5,
        "airspeed_rms_mps":0.25,"loads":[1],"imu_samples_lost":0,"flash_bytes":null})";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
}

}  // namespace

TEST(Percentile, is_the_value_that_so_many_do_not_exceed) {
    const std::vector<double> values = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
    EXPECT_EQ(percentile(values, 0.5), 5);
    EXPECT_EQ(percentile(values, 0.95), 10);
    EXPECT_EQ(percentile(values, 0), 1);
    EXPECT_EQ(percentile({3}, 0.5), 3);
}

TEST(Spreads, keep_airplanes_winds_and_missions_apart_and_name_the_worst_seed) {
    const auto spreads = spreadsOf({flown(1, 0.5), flown(2, 0.9), flown(3, 0.4), flown(1, 2, 5)});

    ASSERT_EQ(spreads.size(), 2u);
    EXPECT_EQ(spreads[0].group, "foam_trainer box calm");
    EXPECT_EQ(spreads[0].flights, 3u);
    EXPECT_EQ(spreads[0].median, 0.5);
    EXPECT_EQ(spreads[0].worst, 0.9);
    EXPECT_EQ(spreads[0].worst_flight.seed, 2u);
    EXPECT_EQ(spreads[1].group, "foam_trainer box 5,320");
    EXPECT_EQ(spreads[1].worst, 2);
}

TEST(Spreads, leave_out_a_figure_that_a_group_does_not_have) {
    CampaignResult lost = flown(1, 0);
    lost.figures.clear();
    lost.failure = "crashed";
    EXPECT_THAT(spreadsOf({lost}), IsEmpty());
}

TEST(Result, has_the_touch_down_apart_from_the_figures) {
    const CampaignResult result =
        resultOf(flown(1, 1).flight,
                 replaced(kWell, "{", R"({"touchdown_long_m":3,"touchdown_right_m":-1,)"));
    ASSERT_TRUE(result.touchdown);
    EXPECT_EQ(result.touchdown->first, 3);
    EXPECT_EQ(result.figures.count("touchdown_long_m"), 0u);
}

TEST(Judged, a_flight_that_was_interrupted_was_not_flown) {
    const CampaignFlight flight = {"flying_wing", "a.waypoints", {}, 3};
    EXPECT_FALSE(resultOf(flight, R"({"completed":false,"reason":"interrupted"})").flown);
    EXPECT_TRUE(resultOf(flight, R"({"completed":false,"reason":"crashed"})").flown);
    EXPECT_TRUE(resultOf(flight, kWell).flown);
}

TEST(Replay, is_the_command_line_of_the_flight) {
    const CampaignFlight calm = {"flying_wing", "a b.waypoints", {}, 3};
    EXPECT_EQ(calm.replay(true),
              "toolchain/fly --native --airplane flying_wing --seed 3 'a b.waypoints'");
    const CampaignFlight windy = {"flying_wing", "m.waypoints", {5, 320}, 18};
    EXPECT_EQ(windy.replay(false),
              "toolchain/fly --airplane flying_wing --wind 5,320 --gusts --seed 18 m.waypoints");
}

TEST(Judgement, takes_the_figures_with_their_units_and_nothing_else) {
    const auto result = resultOf({}, kWell);
    EXPECT_EQ(result.failure, "");
    EXPECT_EQ(result.emulated_s, 10);
    std::vector<std::string> names;
    for (const auto& figure : result.figures) names.push_back(figure.first);
    EXPECT_THAT(names, ElementsAre("airspeed_rms_mps", "crosstrack_rms_m"));
}

TEST(Judgement, fails_a_flight_that_lost_its_mission_or_broke_a_frame) {
    const auto failure = [](const std::string& from, const std::string& to) {
        return resultOf({}, replaced(kWell, from, to)).failure;
    };
    EXPECT_EQ(failure("true", "false,\"reason\":\"crashed after item 3\""), "crashed after item 3");
    EXPECT_EQ(failure("\"frames\":1000", "\"frames\":900"), "only 900 of 995 frames were begun");
    EXPECT_EQ(failure("\"frames\"", "\"frame_overruns\":2,\"frames\""), "2 frames were late");
    EXPECT_EQ(failure("lost\":0", "lost\":4"), "4 inertial samples were lost");
    EXPECT_EQ(resultOf({}, "").failure, "no summary was written");
    EXPECT_EQ(resultOf({}, "[1]").failure, "no summary was written");
}
