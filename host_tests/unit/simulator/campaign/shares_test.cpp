// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/campaign/shares.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace simulator;

// Every figure at so many times its goal in wind.
CampaignResult flown(uint64_t seed, double times) {
    CampaignResult result{{"drawn", "box", {}, seed, true}, true, "", {}, 0, {}};
    for (const Goal& goal : goals()) result.figures[goal.figure] = goal.windy * times;
    return result;
}

TEST(Shares, count_the_flights_within_one_and_a_half_times_the_goal) {
    const auto shares = sharesOf({flown(1, 1.4), flown(2, 1.6), flown(3, 0.5)});
    ASSERT_EQ(shares.size(), goals().size());
    for (const Share& share : shares) {
        EXPECT_EQ(share.met, 2u) << share.figure;
        EXPECT_EQ(share.flights, 3u);
        EXPECT_EQ(share.worst_seed, 2u);
    }
}

TEST(Shares, count_a_figure_that_is_missing_as_not_met) {
    CampaignResult lost = flown(1, 1);
    lost.figures.erase(goals()[0].figure);
    EXPECT_EQ(sharesOf({lost})[0].met, 0u);
    EXPECT_EQ(sharesOf({lost})[1].met, 1u);
    EXPECT_TRUE(std::isinf(excessOf(lost)));
}

TEST(Shares, count_a_flight_that_failed_as_meeting_nothing_whole) {
    CampaignResult failed = flown(1, 0.1);
    failed.failure = "crashed after item 3";
    EXPECT_EQ(meetingAll({failed, flown(2, 1), flown(3, 2)}), 1u);
    EXPECT_NEAR(excessOf(flown(3, 3)), 2, 1e-9);
}

TEST(Shares, name_the_worst_flights_first_with_how_to_fly_them_again) {
    const std::string text = worstText({flown(1, 2), flown(2, 9), flown(3, 1)});
    EXPECT_NE(text.find("every limit is met by 1 of 3"), text.npos) << text;
    EXPECT_LT(text.find("--drawn 2-2"), text.find("--drawn 1-1")) << text;
    EXPECT_EQ(text.find("--drawn 3-3"), text.npos) << text;
}

}  // namespace
