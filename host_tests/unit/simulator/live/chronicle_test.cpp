// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/live/chronicle.hpp"

#include <gmock/gmock.h>

using namespace simulator;
using namespace simulator::live;
using testing::ElementsAre;

namespace {

class ChronicleTest : public testing::Test {
protected:
    ChronicleTest() {
        chronicle.on_event = [this](const ChronicleEvent& e) {
            said.push_back(e.kind + " " + e.text);
        };
        chronicle.on_band = [this](const Band& b) {
            said.push_back((b.to_s ? "end " : "begin ") + b.kind + " " + b.name);
        };
    }
    void heartbeat(uint32_t mode, bool armed) {
        mavlink::Heartbeat beat{};
        beat.custom_mode = mode;
        beat.base_mode = armed ? mavlink::MavModeFlag::safety_armed : 0;
        telemetry.heartbeat = beat;
    }
    std::vector<std::string> look(double now_s) {
        said.clear();
        chronicle.look(telemetry, world, now_s);
        return said;
    }
    Chronicle chronicle;
    Telemetry telemetry;
    World world{{}};
    std::vector<std::string> said;
};

}  // namespace

TEST_F(ChronicleTest, is_silent_while_nothing_happens) {
    EXPECT_THAT(look(1), ElementsAre());
    heartbeat(0, false);
    look(2);
    EXPECT_THAT(look(3), ElementsAre());
}

TEST_F(ChronicleTest, has_a_band_for_each_mode) {
    heartbeat(0, false);
    EXPECT_THAT(look(1), ElementsAre("begin mode MANUAL", "mode MANUAL"));
    heartbeat(10, true);
    EXPECT_THAT(look(5),
                ElementsAre("end mode MANUAL", "begin mode AUTO", "mode AUTO", "armed armed"));
    EXPECT_EQ(chronicle.bands()[0].from_s, 1);
    EXPECT_EQ(chronicle.bands()[0].to_s, 5);
    EXPECT_FALSE(chronicle.bands()[1].to_s);
}

TEST_F(ChronicleTest, has_a_band_from_a_failsafes_text_to_its_end) {
    chronicle.text("GPS lost: dead reckoning", 3, 7);
    chronicle.text("GPS lost: dead reckoning", 3, 8);  // on another link
    chronicle.text("GPS back", 5, 9);

    EXPECT_THAT(
        said, ElementsAre("begin failsafe GPS lost: dead reckoning",
                          "failsafe GPS lost: dead reckoning", "failsafe GPS lost: dead reckoning",
                          "end failsafe GPS lost: dead reckoning", "text GPS back"));
    EXPECT_EQ(chronicle.events()[0].severity, 3);
}

TEST_F(ChronicleTest, ends_every_failsafe_on_disarming) {
    heartbeat(5, true);
    look(1);
    chronicle.text("Battery low", 2, 2);
    heartbeat(5, false);

    EXPECT_THAT(look(3), ElementsAre("end failsafe Battery low", "armed disarmed"));
}

TEST_F(ChronicleTest, shows_a_fault_while_it_lasts) {
    world.setFaults({*parseFault("gps:lost@10-20"), *parseFault("supply:sag_3.2v@15-16")});

    EXPECT_THAT(look(9), ElementsAre());
    EXPECT_THAT(look(10), ElementsAre("begin fault gps:lost", "fault gps:lost"));
    EXPECT_THAT(look(15), ElementsAre("begin fault supply:sag_3.2v", "fault supply:sag_3.2v"));
    EXPECT_THAT(look(16),
                ElementsAre("end fault supply:sag_3.2v", "fault supply:sag_3.2v is over"));
    EXPECT_THAT(look(20), ElementsAre("end fault gps:lost", "fault gps:lost is over"));
}

TEST_F(ChronicleTest, follows_the_mission) {
    telemetry.visited = {1};
    EXPECT_THAT(look(1), ElementsAre("item flies item 1"));
    telemetry.reached = {1};
    telemetry.visited = {1, 2};
    EXPECT_THAT(look(2), ElementsAre("item reached item 1", "item flies item 2"));
}
