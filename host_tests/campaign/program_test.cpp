// SPDX-License-Identifier: GPL-3.0-or-later
// The campaign program as a user meets it.
#include <gmock/gmock.h>

#include <algorithm>

#include "simulator/program_run.hpp"

using program_run::contents;
using program_run::Outcome;
using program_run::Wrong;
using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

namespace {

Outcome campaign(const std::string& arguments) {
    return program_run::run(CAMPAIGN_PROGRAM, arguments);
}

fs::path folder(const std::string& name) {
    return fs::temp_directory_path() / ("campaign_" + std::to_string(getpid()) + "_" + name);
}

class WrongCampaign : public testing::TestWithParam<Wrong> {};

}  // namespace

TEST_P(WrongCampaign, gets_one_line_and_exit_2_before_a_flight) {
    const Outcome run = campaign(GetParam().arguments);

    EXPECT_EQ(run.status, 2);
    EXPECT_EQ(std::count(run.output.begin(), run.output.end(), '\n'), 1) << run.output;
    EXPECT_THAT(run.output, HasSubstr(GetParam().says));
}

INSTANTIATE_TEST_SUITE_P(
    All, WrongCampaign,
    testing::Values(Wrong{"--seeds 0", "--seeds"}, Wrong{"--seeds 9-5", "'9-5'"},
                    Wrong{"--seeds many", "--seeds"}, Wrong{"--seeds -3", "--seeds"},
                    Wrong{"--seeds 99999999999999999999", "--seeds"},
                    Wrong{"--seeds 900000", "more than 1000000"}, Wrong{"--wind 5", "'5'"},
                    Wrong{"--wind 5,400", "'5,400'"}, Wrong{"--wind 0,10", "'0,10'"},
                    Wrong{"--wind nan,10", "'nan,10'"}, Wrong{"--jobs 0", "--jobs"},
                    Wrong{"--jobs x", "--jobs"}, Wrong{"--airplane biplane", "biplane"},
                    Wrong{"/no/such.waypoints", "/no/such.waypoints"},
                    Wrong{"--out /proc/nowhere", "/proc/nowhere"}, Wrong{"--loud", "--loud"}));

TEST(Campaign, names_every_option_in_its_help) {
    const Outcome run = campaign("--help");

    EXPECT_EQ(run.status, 0);
    for (const char* option : {"MISSION", "--airplane", "--wind", "--seeds", "--jobs", "--out"})
        EXPECT_THAT(run.output, HasSubstr(option));
}

TEST(Campaign, tells_a_flight_that_failed_and_how_to_fly_it_again) {
    const fs::path mission = folder("short.waypoints"), out = folder("out");
    // no landing: a flight without an end to judge
    std::ofstream(mission) << "QGC WPL 110\n"
                              "0 1 0 16 0 0 0 0 47.3977 8.5456 488 1\n"
                              "1 0 3 21 0 0 0 0 91e-9 0 0 1\n"
                              "2 0 3 16 0 0 0 0 47.3977 8.5456 488 1\n";
    const Outcome run =
        campaign(mission.string() + " --airplane foam_trainer --wind calm --seeds 7-7 --out " +
                 out.string());

    EXPECT_EQ(run.status, 1) << run.output;
    EXPECT_THAT(run.output, HasSubstr("1 flights, 1 failed"));
    EXPECT_THAT(run.output, HasSubstr("toolchain/fly --native --airplane foam_trainer --seed 7"));
    EXPECT_THAT(run.output, HasSubstr("toolchain/fly --airplane foam_trainer --seed 7"));
    EXPECT_THAT(contents(out / "campaign.html"), HasSubstr("1 flights failed"));
}

TEST(Campaign, shows_what_was_flown_in_a_table_and_on_a_page) {
    const fs::path out = folder("good");
    const Outcome run = campaign(MISSIONS
                                 "/first_flight.waypoints --airplane foam_trainer "
                                 "--wind calm --seeds 4-5 --out " +
                                 out.string());

    EXPECT_EQ(run.status, 0) << run.output;
    EXPECT_THAT(run.output, HasSubstr("2/2  0 failed"));
    EXPECT_THAT(run.output, HasSubstr("crosstrack_rms_m"));
    const std::string page = contents(out / "campaign.html");
    EXPECT_THAT(page, HasSubstr("every flight completed"));
    EXPECT_THAT(page, HasSubstr("<svg"));
    EXPECT_THAT(page, Not(HasSubstr("<script")));
    EXPECT_TRUE(fs::exists(out / "flights/foam_trainer-first_flight-calm-4/summary.json"));
    EXPECT_FALSE(fs::exists(out / "flights/foam_trainer-first_flight-calm-4/flight.csv"));
}
