// SPDX-License-Identifier: GPL-3.0-or-later
#include "mission_rig.hpp"

namespace firmware {
namespace {

class Refusals : public Rig {
protected:
    // What stands behind "Item 2 refused", where there is one such text.
    static void expectReason(const std::string& reason) {
        const std::string texts = statusTexts(), begin = "Item 2 refused";
        const size_t at = texts.find(begin);
        ASSERT_NE(at, std::string::npos) << reason;
        EXPECT_EQ(texts.find("refused", at + begin.size()), std::string::npos) << "one is enough";
        const std::string behind = texts.substr(at + begin.size());
        if (reason.empty())
            EXPECT_NE(behind.substr(0, 1), ":") << behind;
        else
            EXPECT_EQ(behind.substr(0, reason.size()), reason);
    }
    static void expectRefused(const MissionItem& item, const std::string& reason) {
        EXPECT_NE(upload({waypoint(100), item}), MissionResult::accepted);
        expectReason(reason);
        missionAbort();
    }
};
class RefusalsApm1 : public Refusals {
protected:
    void SetUp() override {
        Rig::SetUp();
        parameters.mission_set = 1;
    }
};

TEST_F(Refusals, name_the_item_and_the_reason_where_the_answer_does_not) {
    expectRefused(command(9999), ": command is not known");
    expectRefused(command(181, 0, 9), "");
    MissionItem terrain = waypoint(100);
    terrain.frame = 10;
    expectRefused(terrain, ": altitude's frame");
}

TEST_F(Refusals, come_once_however_often_the_item_is_sent) {
    EXPECT_EQ(upload({waypoint(100), command(9999)}), MissionResult::unsupported);
    EXPECT_EQ(missionUploadItem(2, command(9999)), MissionResult::unsupported);
    expectReason(": command is not known");
}

TEST_F(Refusals, there_is_none_for_what_is_taken) {
    EXPECT_EQ(upload({waypoint(100), waypoint(200)}), MissionResult::accepted);
    EXPECT_FALSE(hasStatusText("refused"));
}

// ---- of the whole mission, when its last item has come

Items relays(int count) {
    Items items = {waypoint(100)};
    for (int i = 0; i < count; ++i) items.push_back(command(181, 0, 1));
    items.push_back(waypoint(200));
    return items;
}

TEST_F(Refusals, a_mission_that_holds_up_its_next_nav_is_refused_and_the_old_one_stays) {
    ASSERT_EQ(upload({waypoint(300), waypoint(400)}), MissionResult::accepted);
    EXPECT_EQ(upload(relays(146)), MissionResult::invalid);
    expectReason(": over 1.5 s to next NAV");
    EXPECT_EQ(missionCount(), 3);
    EXPECT_EQ(upload(relays(145)), MissionResult::accepted);
    EXPECT_EQ(missionCount(), 148);
}

TEST_F(Refusals, jumps_that_go_round_are_refused_with_their_item) {
    EXPECT_EQ(upload({waypoint(100), command(177, 3, -1), command(177, 2, -1), waypoint(200)}),
              MissionResult::invalid);
    expectReason(": jumps go round");
    EXPECT_EQ(missionCount(), 0);
    EXPECT_EQ(upload({waypoint(100), waypoint(200), command(177, 1, -1)}), MissionResult::accepted);
}

TEST_F(Refusals, a_part_is_computed_together_with_what_stays) {
    ASSERT_EQ(upload({waypoint(100), command(181, 0, 1), waypoint(200)}), MissionResult::accepted);
    EXPECT_EQ(uploadPartial(2, {command(177, 3, -1)}), MissionResult::accepted);
    ASSERT_EQ(upload({waypoint(100), command(177, 3, -1), command(181, 0, 1), waypoint(200)}),
              MissionResult::accepted);
    EXPECT_EQ(uploadPartial(3, {command(177, 2, -1)}), MissionResult::invalid);
}

TEST_F(RefusalsApm1, jumps_that_go_round_are_refused_too) {
    EXPECT_EQ(upload({waypoint(100), command(0x81, 1), command(0x75, 0, 2)}),
              MissionResult::invalid);
    EXPECT_TRUE(hasStatusText("Item 3 refused: jumps go round"));
}

TEST_F(RefusalsApm1, of_a_gain_say_what_plays_its_part_or_that_nothing_does) {
    expectRefused(command(0x60, 3, 1000), ": NAVL1_PERIOD instead");
    expectRefused(command(0x60, 5, 1000), ": TECS_TIME_CONST instead");
    expectRefused(command(0x61, 3, 1000), ": no parameter for it");
    expectRefused(command(0x63, 7, 1000), ": no parameter for it");
    expectRefused(command(0x64, 2, 1000), ": no parameter for it");
    expectRefused(command(0x60, 8, 1000), ": no parameter for it");
    expectRefused(command(0x73, 1, 1500), ": ELEVON_OUTPUT is 0");
    expectRefused(command(0x60, 0, -100000000), "");
    expectRefused(command(0x73, 2, -5), "");
}

}  // namespace
}  // namespace firmware
