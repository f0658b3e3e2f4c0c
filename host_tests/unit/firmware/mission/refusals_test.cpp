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
