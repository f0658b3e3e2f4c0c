// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/live/document.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "simulator/live/command_names.hpp"
#include "talking_board.hpp"

using namespace simulator;
using namespace simulator::live;

namespace {

class Document : public testing::Test {
protected:
    Document()
        : link(board, 0,
               [this](const mavlink::Frame& frame, uint64_t time_us) {
                   plans.take(frame, time_us);
               }),
          plans(link) {
        board.talks = false;
        board.listen([this](int, uint8_t byte, uint64_t time_us) { link.receive(byte, time_us); });
    }
    void read() {
        for (int i = 0; i < 50; ++i) {
            plans.step(board.time_us(), 1, 1);
            board.runUntil(board.time_us() + 10'000);
        }
    }
    Json made() { return Json::parse(documentJson(from, plans, chronicle)); }
    TalkingBoard board;
    Link link;
    PlanDownload plans;
    Origin from;
    Chronicle chronicle;
};

}  // namespace

TEST_F(Document, is_one_of_version_1_without_samples) {
    from.title = "box.waypoints, live";
    from.provenance = R"({"airplane": "foam_trainer"})";
    const Json json = made();

    EXPECT_EQ(json["format"], "apm-flight");
    EXPECT_EQ(json["version"], 1);
    EXPECT_EQ(json["kind"], "live");
    EXPECT_TRUE(json["times"].empty());
    EXPECT_EQ(json["provenance"]["airplane"], "foam_trainer");
    EXPECT_EQ(json["title"], "box.waypoints, live");
    EXPECT_GT(json["offers"]["modes"].size(), 10u);
}

TEST_F(Document, draws_the_plans_that_the_board_holds) {
    board.lists[0] = {itemAt(0, 16, 47, 8, 488), itemAt(1, 22, 0, 0, 50),
                      itemAt(2, 16, 47.01, 8.01, 60)};
    board.lists[1] = {itemAt(0, 5000, 47, 8, 0),      itemAt(1, 5001, 47.1, 8.1, 0),
                      itemAt(2, 5001, 47.1, 8.2, 0),  itemAt(3, 5001, 47.2, 8.1, 0),
                      itemAt(4, 5004, 47.15, 8.3, 0), itemAt(5, 5001, 47.3, 8.3, 0),
                      itemAt(6, 5001, 47.3, 8.4, 0),  itemAt(7, 5001, 47.4, 8.4, 0)};
    for (auto& item : board.lists[1]) item.params[0] = item.command == 5004 ? 120.5 : 3;
    board.lists[2] = {itemAt(0, 5100, 47.2, 8.2, 70)};
    board.lists[2][0].frame = 3;
    read();
    const Json plan = made()["plan"];

    EXPECT_EQ(plan["home"]["altitude_m"], 488);
    ASSERT_EQ(plan["items"].size(), 3u);
    EXPECT_EQ(plan["items"][1]["name"], "TAKEOFF");
    EXPECT_FALSE(plan["items"][1].contains("lat_deg"));
    EXPECT_NEAR(plan["items"][2]["lat_deg"].get<double>(), 47.01, 1e-6);
    EXPECT_EQ(plan["items"][2]["altitude_m"], 548);
    EXPECT_EQ(plan["items"][2]["text"], "60 m above home");
    ASSERT_EQ(plan["fence"].size(), 3u);
    EXPECT_NEAR(plan["fence"][0]["lon_deg"].get<double>(), 8.1, 1e-6);
    ASSERT_EQ(plan["zones"].size(), 2u);
    EXPECT_EQ(plan["zones"][0]["keeps"], "out");
    EXPECT_EQ(plan["zones"][0]["radius_m"], 120.5);
    EXPECT_NEAR(plan["zones"][0]["rim"][0]["lat_deg"].get<double>(), 47.15, 1e-6);
    EXPECT_EQ(plan["zones"][1]["keeps"], "in");
    EXPECT_EQ(plan["zones"][1]["rim"].size(), 3u);
    EXPECT_FALSE(plan["zones"][1].contains("radius_m"));
    EXPECT_EQ(plan["rally"][0]["altitude_m"], 558);
}

TEST_F(Document, has_a_home_before_the_board_has_one) {
    from.start.latitude_deg = 47.5;
    from.start.altitude_m = 400;
    EXPECT_EQ(made()["plan"]["home"]["lat_deg"], 47.5);

    board.lists[0] = {itemAt(0, 16, 0, 0, 0), itemAt(1, 16, 47.01, 8.01, 60)};
    read();
    const Json plan = made()["plan"];
    EXPECT_EQ(plan["home"]["lat_deg"], 47.5);
    EXPECT_FALSE(plan["items"][0].contains("lat_deg"));
    EXPECT_EQ(plan["items"][1]["altitude_m"], 460);
}

TEST_F(Document, has_what_happened) {
    chronicle.text("hello \xFF", 6, 1.23456);
    chronicle.text("Battery low", 2, 3);
    const Json json = made();

    EXPECT_EQ(json["events"][0]["time_s"], 1.23);
    EXPECT_EQ(json["events"][0]["severity"], 6);
    EXPECT_EQ(json["events"][1]["kind"], "failsafe");
    EXPECT_EQ(json["bands"][0]["name"], "Battery low");
    EXPECT_FALSE(json["bands"][0].contains("to_s"));
}
