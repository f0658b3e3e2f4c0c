// SPDX-License-Identifier: GPL-3.0-or-later
#include "toolchain/mission_tool/page.hpp"

#include <regex>

#include "mission_tool_rig.hpp"
#include "simulator/input_file.hpp"
#include "toolchain/mission_tool/drawing.hpp"

namespace mission_tool {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

size_t count(const std::string& text, const std::string& part) {
    size_t found = 0;
    for (size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++found;
    return found;
}

class Page : public Tool {
protected:
    std::string pageFor(const std::string& mission, const std::vector<std::string>& options = {}) {
        std::vector<std::string> words = {"show", mission, "--html", path("page.html")};
        words.insert(words.end(), options.begin(), options.end());
        EXPECT_EQ(tool(words), 0) << err_;
        return simulator::wholeFile(path("page.html")).value_or("");
    }
};

// Whatever opens is closed, in its order.
void expectClosed(const std::string& page) {
    std::vector<std::string> open;
    const std::regex tag("<(/?)([a-z0-9]+)[^>]*?(/?)>");
    for (std::sregex_iterator it(page.begin(), page.end(), tag), end; it != end; ++it) {
        const std::string name = (*it)[2];
        if (name == "meta" || (*it)[3] == "/") continue;
        if ((*it)[1] != "/") {
            open.push_back(name);
            continue;
        }
        ASSERT_FALSE(open.empty()) << name;
        EXPECT_EQ(open.back(), name);
        open.pop_back();
    }
    EXPECT_TRUE(open.empty());
}

TEST_F(Page, has_map_profile_table_and_findings_and_nothing_from_elsewhere) {
    const std::string page = pageFor(MISSIONS "/survey.plan", {"--wind", "5,270"});
    expectClosed(page);
    EXPECT_EQ(count(page, "<svg "), 2u);
    EXPECT_EQ(count(page, "viewBox=\"0 0 390.0 "), 2u);
    EXPECT_THAT(page, HasSubstr("width=device-width"));
    EXPECT_THAT(page, HasSubstr("prefers-color-scheme:dark"));
    EXPECT_THAT(page, Not(HasSubstr("http")));
    EXPECT_THAT(page, Not(HasSubstr("<script")));
    EXPECT_THAT(page, HasSubstr("<polygon class=\"fence\""));
    EXPECT_THAT(page, HasSubstr("rally point R1"));
    EXPECT_THAT(page, HasSubstr("<title>27 LAND, 0 m</title>"));
    EXPECT_THAT(page, HasSubstr("24 LAND_START, 25 SET_CAM_TRIGG_DIST"));
    EXPECT_THAT(page, HasSubstr("<li class=\"warning\">item 9: the leg of 40 m is shorter than"));
    EXPECT_THAT(page,
                HasSubstr("foam_trainer, 5.0 m/s from 270, estimated; 28 items, ends landed"));
}

TEST_F(Page, all_that_is_drawn_lies_within_it) {
    const std::string page = pageFor(MISSIONS "/box_600.waypoints");
    const std::regex corner(" (?:x1|x2|cx|x)=\"([-0-9.]+)\"");
    for (std::sregex_iterator it(page.begin(), page.end(), corner), end; it != end; ++it) {
        EXPECT_GE(std::stod((*it)[1]), -0.1);
        EXPECT_LE(std::stod((*it)[1]), 390.1);
    }
}

TEST_F(Page, names_of_files_are_text) {
    const std::string name = file("<b>&.waypoints", kTwoWaypoints);
    EXPECT_THAT(pageFor(name), HasSubstr("<h1>&lt;b&gt;&amp;.waypoints</h1>"));
}

TEST_F(Page, of_a_mission_that_is_refused_or_cannot_be_written_there_is_none) {
    EXPECT_EQ(tool({"show", file("m", between("3 202 0 0 0 0 0 0 0")), "--html", path("p.html")}),
              1);
    EXPECT_THAT(err_, EndsWith("p.html: not written: there is no flight to draw\n"));
    EXPECT_FALSE(std::filesystem::exists(path("p.html")));
    EXPECT_EQ(tool({"show", file("n", kTwoWaypoints), "--html", path("no/p.html")}), 1);
    EXPECT_THAT(err_, HasSubstr("cannot be written: No such file or directory"));
}

TEST(Drawing, steps_of_the_grid_are_round) {
    EXPECT_EQ(gridStep(1000, 5), 200);
    EXPECT_EQ(gridStep(1001, 5), 500);
    EXPECT_EQ(gridStep(0.9, 5), 0.2);
    EXPECT_EQ(gridStep(47, 5), 10);
    EXPECT_EQ(gridStep(0, 5), 1);
}

}  // namespace
}  // namespace mission_tool
