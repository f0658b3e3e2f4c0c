// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/report/provenance.hpp"

#include <gmock/gmock.h>
#include <unistd.h>

#include <fstream>
#include <nlohmann/json.hpp>

using namespace simulator;
using nlohmann::json;

TEST(Provenance, leaves_out_what_is_not_known) {
    const json made = json::parse(provenanceJson(Provenance()));

    EXPECT_FALSE(made.contains("command"));
    EXPECT_FALSE(made.contains("seed"));
    EXPECT_FALSE(made["firmware"].contains("commit"));
}

TEST(Provenance, keeps_no_faults_apart_from_unknown_ones) {
    Provenance none;
    none.faults.emplace();

    EXPECT_EQ(json::parse(provenanceJson(none))["faults"], json::array());
    EXPECT_FALSE(json::parse(provenanceJson(Provenance())).contains("faults"));
}

TEST(Provenance, takes_the_commit_from_the_file_of_the_build) {
    Provenance with, without;
    const auto file =
        std::filesystem::temp_directory_path() / ("commit_" + std::to_string(getpid()) + ".txt");
    std::ofstream(file) << "0123abc 2026-01-02T03:04:05+00:00\n";
    takeCommit(with, file);
    std::filesystem::remove(file);
    takeCommit(without, file);

    EXPECT_EQ(with.commit, "0123abc");
    EXPECT_EQ(with.date, "2026-01-02T03:04:05+00:00");
    EXPECT_EQ(without.commit, "");
}
