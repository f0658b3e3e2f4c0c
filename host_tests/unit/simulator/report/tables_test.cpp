// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/report/tables.hpp"

#include <gmock/gmock.h>

#include <algorithm>

#include "simulator/report/goals.hpp"

using namespace simulator;

static const Deviation* named(const std::vector<Deviation>& all, const std::string& name) {
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const Deviation& each) { return each.name == name; });
    return found == all.end() ? nullptr : &*found;
}

TEST(Deviations, are_held_to_the_goals_of_the_air_they_were_flown_in) {
    Summary calm, windy;
    calm.crosstrack_rms_m = windy.crosstrack_rms_m = 1.5;
    windy.wind_mps = 5;

    EXPECT_FALSE(named(deviationsOf(calm), "Crosstrack, RMS")->met());
    EXPECT_TRUE(named(deviationsOf(windy), "Crosstrack, RMS")->met());
}

TEST(Deviations, have_the_processors_budget_of_their_board) {
    Summary summary;
    summary.figures.cpu_load = 0.36;
    summary.board = "apm1";
    EXPECT_TRUE(named(deviationsOf(summary), "Processor load")->met());
    summary.board = "apm2";
    EXPECT_FALSE(named(deviationsOf(summary), "Processor load")->met());
}

TEST(Deviations, leave_out_what_is_not_known) { EXPECT_TRUE(deviationsOf(Summary()).empty()); }

TEST(Deviations, of_a_log_have_no_goals) {
    Summary summary;
    summary.from_log = true;
    summary.crosstrack_rms_m = 90;

    EXPECT_FALSE(named(deviationsOf(summary), "Crosstrack, RMS")->goal);
}

TEST(Tables, of_a_foreign_firmware_are_the_sensors_errors_alone) {
    const auto tables = tablesOf(Summary());

    ASSERT_EQ(tables.size(), 1u);
    EXPECT_EQ(tables[0].title, "Sensor errors of this flight");
    EXPECT_GT(tables[0].rows.size(), 10u);
}

TEST(Goals, are_stricter_in_calm_air) {
    ASSERT_GE(goals().size(), 10u);
    for (const Goal& goal : goals()) EXPECT_LE(goal.calm, goal.windy) << goal.figure;
    EXPECT_FALSE(goalOf("flight_time_s", true, true));
}

TEST(Goals, of_the_heading_are_those_of_a_calibrated_compass) {
    EXPECT_TRUE(goalOf("yaw_error_rms_deg", true, true));
    EXPECT_FALSE(goalOf("yaw_error_rms_deg", true, false));
    EXPECT_TRUE(goalOf("crosstrack_rms_m", true, false));
}
