// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/flight_folder.hpp"

#include <gmock/gmock.h>
#include <unistd.h>

#include <fstream>

#include "simulator/output_file.hpp"

using namespace simulator;
using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

namespace {

class Folders : public testing::Test {
protected:
    Folders() { fs::remove_all(root); }
    ~Folders() override { fs::remove_all(root); }
    std::string flown(const std::string& mission, const std::string& result = "mission completed") {
        const FlightFolder folder(flights, newest, mission);
        std::ofstream(folder.path() / "report.html") << mission;
        folder.enter({"2026-11-23T10:00:00Z", "foam_trainer", mission, "apm2", result, true});
        return folder.path().filename();
    }
    static std::string contents(const fs::path& path) {
        std::ifstream file(path);
        return std::string(std::istreambuf_iterator<char>(file), {});
    }
    const fs::path root = fs::temp_directory_path() / ("flights_" + std::to_string(getpid()));
    const fs::path flights = root / "flights", newest = root / "flight";
};

}  // namespace

TEST_F(Folders, are_numbered_and_named_after_their_missions) {
    EXPECT_EQ(flown("box_600.waypoints"), "1-box_600");
    EXPECT_EQ(flown("a b/../<x>.plan"), "2-_x_");
    fs::create_directories(flights / "41-x");
    EXPECT_EQ(flown("served"), "42-served");
}

TEST_F(Folders, are_listed_in_an_index_with_links) {
    flown("one.plan");
    flown("two.plan", "crashed <hard> after item 3");
    const std::string index = contents(flights / "index.html");

    EXPECT_THAT(index, HasSubstr("<a href=\"1-one/report.html\">"));
    EXPECT_THAT(index, HasSubstr("crashed &lt;hard> after item 3"));
    EXPECT_THAT(index, HasSubstr("2026-11-23T10:00:00Z"));
    EXPECT_LT(index.find("2-two"), index.find("1-one"));
    fs::remove_all(flights / "1-one");
    flown("three.plan");
    EXPECT_THAT(contents(flights / "index.html"), Not(HasSubstr("1-one")));
}

TEST_F(Folders, have_a_link_to_the_newest) {
    flown("one.plan");
    EXPECT_EQ(contents(newest / "report.html"), "one.plan");
    flown("two.plan");
    EXPECT_EQ(contents(newest / "report.html"), "two.plan");
    EXPECT_EQ(fs::read_symlink(newest), "flights/2-two");
}

TEST_F(Folders, keep_a_flight_that_lay_where_the_link_belongs) {
    fs::create_directories(newest);
    std::ofstream(newest / "report.html") << "old";
    flown("one.plan");

    EXPECT_EQ(contents(newest / "report.html"), "one.plan");
    EXPECT_EQ(contents(flights / "2-before" / "report.html"), "old");
}

TEST_F(Folders, go_again_when_nothing_came_into_them) {
    { const FlightFolder folder(flights, newest, "none"); }
    EXPECT_FALSE(fs::exists(flights / "1-none"));
    EXPECT_FALSE(fs::exists(newest));
}

TEST_F(Folders, that_were_asked_for_have_no_index) {
    {
        const FlightFolder folder(root / "mine");
        folder.enter({"", "", "", "", "", true});
    }
    EXPECT_TRUE(fs::is_directory(root / "mine"));
    EXPECT_FALSE(fs::exists(flights));
    EXPECT_THROW(FlightFolder("/proc/nowhere"), OutputError);
}

TEST_F(Folders, show_nothing_of_a_damaged_entry) {
    flown("one.plan");
    std::ofstream(flights / "1-one" / "entry.json") << "{\"date\":";
    fs::create_directories(flights / "7-empty");

    EXPECT_THAT(indexPage(flights), Not(HasSubstr("<a ")));
}
