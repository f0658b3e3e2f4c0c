// SPDX-License-Identifier: GPL-3.0-or-later
// The campaign program as a user meets it.
#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "program_run.hpp"

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

// The first mission by the foam trainer in calm air.
Outcome firstFlights(const std::string& seeds, const fs::path& out) {
    return campaign(MISSIONS
                    "/first_flight.waypoints --airplane foam_trainer --wind calm --seeds " +
                    seeds + " --out " + out.string());
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
                    Wrong{"--wind 5,400", "'5,400'"}, Wrong{"--wind 31,10", "up to 30 m/s"},
                    Wrong{"--wind 0,10", "'0,10'"}, Wrong{"--wind nan,10", "'nan,10'"},
                    Wrong{"--jobs 0", "--jobs"}, Wrong{"--jobs x", "--jobs"},
                    Wrong{"--airplane biplane", "biplane"},
                    Wrong{"/no/such.waypoints", "/no/such.waypoints"},
                    Wrong{"--out /proc/nowhere", "/proc/nowhere"},
                    Wrong{"--out /dev/null", "--out /dev/null"},
                    Wrong{"--airplane /tmp", "/tmp: is a folder"}, Wrong{"--loud", "--loud"},
                    Wrong{"--drawn 3 --airplane foam_trainer",
                          "--drawn draws the airplane itself: no --airplane"},
                    Wrong{"--drawn 3 --wind calm", "--drawn draws the wind itself: no --wind"},
                    Wrong{"--drawn 3 --seeds 10", "--drawn draws the seeds itself: no --seeds"},
                    Wrong{"--seeds 10 --drawn 3", "--drawn draws the seeds itself: no --seeds"},
                    Wrong{"--drawn 3 my.waypoints", "--drawn draws the mission itself: no MISSION"},
                    Wrong{"--drawn ''", "--drawn: expected how many"},
                    Wrong{"--drawn 0", "--drawn: expected how many"},
                    Wrong{"--drawn 9-5", "--drawn: expected how many"},
                    Wrong{"--drawn 9000000", "--drawn: more than 1000000"}));

TEST(Campaign, names_every_option_in_its_help) {
    const Outcome run = campaign("--help");

    EXPECT_EQ(run.status, 0);
    for (const char* option : {"MISSION", "--airplane", "--wind", "--seeds", "--jobs", "--out"})
        EXPECT_THAT(run.output, HasSubstr(option));
}

TEST(Campaign, reports_a_failed_flight_and_how_to_repeat_it) {
    const fs::path mission = folder("short.waypoints"), out = folder("out");
    // no landing: a flight without an end to check
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
    EXPECT_THAT(contents(out / "campaign.html"), HasSubstr("1 flights, 1 failed"));
}

TEST(Campaign, shows_what_was_flown_in_a_table_and_on_a_page) {
    const fs::path out = folder("good");
    const Outcome run = firstFlights("4-5", out);

    EXPECT_EQ(run.status, 0) << run.output;
    EXPECT_THAT(run.output, HasSubstr("2/2  0 failed"));
    EXPECT_THAT(run.output, HasSubstr("crosstrack_rms_m"));
    const std::string page = contents(out / "campaign.html");
    EXPECT_THAT(page, HasSubstr("every flight completed"));
    EXPECT_THAT(page, Not(HasSubstr(" src=")));
    EXPECT_THAT(contents(out / "campaign.json"), HasSubstr("\"kind\": \"planned\""));
    EXPECT_TRUE(fs::exists(out / "flights/foam_trainer-first_flight-calm-4/summary.json"));
    EXPECT_FALSE(fs::exists(out / "flights/foam_trainer-first_flight-calm-4/flight.csv"));
}

TEST(Campaign, leaves_the_reports_of_the_ten_worst_flights) {
    const fs::path out = folder("reports");
    firstFlights("1-12", out);

    std::vector<double> reported, others;  // by how many times its goal the worst figure is
    const auto json = nlohmann::json::parse(contents(out / "campaign.json"));
    for (const auto& flight : json["flights"]) {
        double most = 0;
        for (const auto& goal : json["goals"])
            if (flight["figures"].contains(goal["figure"]))
                most = std::max(most,
                                flight["figures"][goal["figure"].get<std::string>()].get<double>() /
                                    goal["calm"].get<double>());
        const bool has = flight.contains("report");
        (has ? reported : others).push_back(most);
        if (has) {
            EXPECT_TRUE(fs::exists(out / flight["report"].get<std::string>())) << flight["report"];
        }
    }
    ASSERT_EQ(reported.size(), 10u);
    ASSERT_EQ(others.size(), 2u);
    EXPECT_GE(*std::min_element(reported.begin(), reported.end()),
              *std::max_element(others.begin(), others.end()));
}

TEST(Campaign, writes_of_drawn_worlds_what_was_drawn_and_leaves_the_report) {
    const fs::path out = folder("drawn");
    const Outcome run = campaign("--drawn 2-2 --out " + out.string());

    EXPECT_LE(run.status, 1) << run.output;
    EXPECT_THAT(run.output, HasSubstr("every limit is met by"));
    const auto json = nlohmann::json::parse(contents(out / "campaign.json"));
    EXPECT_EQ(json["kind"], "drawn");
    const auto& flight = json["flights"].at(0);
    EXPECT_EQ(flight["seed"], 2);
    EXPECT_GT(flight["world"]["mass_kg"], 0.5);
    EXPECT_EQ(flight["world"].size(), json["drawn"].size());
    EXPECT_EQ(flight["report"], "flights/drawn-2/report.html");
    EXPECT_TRUE(fs::exists(out / "flights/drawn-2/report.html"));
    EXPECT_FALSE(fs::exists(out / "flights/drawn-2/flight.csv"));
    EXPECT_THAT(contents(out / "campaign.html"), HasSubstr("\"kind\":\"drawn\""));
}

// A signal before the end: whatever was flown until then, the campaign is not reported as complete.
TEST(Campaign, says_that_it_was_interrupted_and_how_far_it_came) {
    const fs::path out = folder("interrupted");
    const Outcome run = program_run::runCommand(
        "timeout --preserve-status -s TERM 1 " CAMPAIGN_PROGRAM " --seeds 500 --jobs 1 --out " +
        out.string() + " 2>&1 </dev/null");

    EXPECT_EQ(run.status, 1) << run.output;
    EXPECT_THAT(run.output, testing::ContainsRegex("interrupted: [0-9]+ of 6000 flights"));
    const std::string page = contents(out / "campaign.html");
    EXPECT_THAT(page, testing::ContainsRegex("interrupted: [0-9]+ of 6000 flights"));
    EXPECT_THAT(page, Not(HasSubstr("every flight completed")));
}

// Ctrl-C goes to the flights too: one that was cut off is neither flown nor failed.
TEST(Campaign, does_not_count_a_flight_that_a_signal_has_cut_off) {
    const fs::path out = folder("cut");
    const Outcome run =
        program_run::runCommand("setsid -w timeout --preserve-status -s INT 1 " CAMPAIGN_PROGRAM
                                " --seeds 500 --jobs 2 --out " +
                                out.string() + " 2>&1 </dev/null");

    EXPECT_THAT(run.output, HasSubstr("flights were flown, 0 failed")) << run.output;
}

TEST(Campaign, keeps_its_verdict_and_says_so_when_the_page_cannot_be_written) {
    const fs::path out = folder("full");
    fs::create_directories(out);
    fs::create_symlink("/dev/full", out / "campaign.html");
    const Outcome run = firstFlights("4-4", out);

    EXPECT_EQ(run.status, 2) << run.output;
    EXPECT_THAT(run.output, HasSubstr("1 flights, 0 failed"));
    EXPECT_THAT(run.output, HasSubstr("campaign.html: cannot be written: No space left"));
    EXPECT_THAT(run.output, Not(HasSubstr("page: ")));
}

TEST(Campaign, fails_when_its_standard_output_is_lost) {
    const Outcome run = program_run::runOnFullDisk(CAMPAIGN_PROGRAM, "--help");

    EXPECT_EQ(run.status, 1);
    EXPECT_THAT(run.output, HasSubstr("campaign: the standard output cannot be written: No space"));
}
