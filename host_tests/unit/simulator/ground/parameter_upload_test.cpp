// SPDX-License-Identifier: GPL-3.0-or-later
// Setting parameters by wire, and the thrower, before a board that answers what the test says.
#include "simulator/ground/parameter_upload.hpp"

#include <gmock/gmock.h>

#include "echo_board.hpp"
#include "simulator/ground/thrower.hpp"

using namespace simulator;
using testing::HasSubstr;

namespace {

constexpr int kUsart = 2;
constexpr uint64_t kSecond_us = 1'000'000;

class ByWire : public testing::Test {
protected:
    // Runs the upload for `seconds` in steps of 20 ms.
    void run(ParameterUpload& upload, double seconds) {
        for (const uint64_t end_us = now_us + static_cast<uint64_t>(seconds * 1e6); now_us < end_us;
             now_us += 20'000)
            upload.step(now_us, 1, 1);
    }
    void answer(ParameterUpload& upload, const std::string& name, float value) {
        mavlink::ParamValue message{};
        message.param_value = value;
        name.copy(message.param_id, sizeof message.param_id);
        uint8_t bytes[mavlink::kLongestFrame];
        const auto size = mavlink::encode({mavlink::Framing::v2, 0, 1, 1}, message, bytes);
        for (uint16_t i = 0; i < size; ++i)
            for (bool whole = parser.put(bytes[i]); whole; whole = parser.next())
                upload.take(parser.frame());
    }
    // The names that were sent since the last call, in order.
    std::vector<std::string> sent() {
        std::vector<std::string> names;
        for (const char byte : std::exchange(board.sent.at(kUsart), "")) {
            for (bool whole = ground.put(static_cast<uint8_t>(byte)); whole; whole = ground.next())
                if (const auto set = as<mavlink::ParamSet>(ground.frame()))
                    names.emplace_back(set->param_id, strnlen(set->param_id, sizeof set->param_id));
        }
        return names;
    }

    EchoBoard board;
    mavlink::PeerParser parser, ground;
    Link link{board, kUsart, [](const mavlink::Frame&, uint64_t) {}};
    uint64_t now_us = kSecond_us;
};

}  // namespace

TEST_F(ByWire, sets_one_after_the_other_when_each_is_answered) {
    ParameterUpload upload(link, {{"ELEVON_OUTPUT", 1}, {"MIXING_GAIN", 0.9}});
    run(upload, 0.1);
    EXPECT_THAT(sent(), testing::ElementsAre("ELEVON_OUTPUT"));
    answer(upload, "ELEVON_OUTPUT", 1);
    run(upload, 0.1);
    EXPECT_THAT(sent(), testing::ElementsAre("MIXING_GAIN"));
    EXPECT_FALSE(upload.done());
    answer(upload, "MIXING_GAIN", 0.9f);
    EXPECT_TRUE(upload.done());
}

TEST_F(ByWire, asks_again_when_nothing_comes_and_gives_up_in_the_end) {
    ParameterUpload upload(link, {{"WP_RADIUS", 50}});
    run(upload, 1.1);
    EXPECT_EQ(sent().size(), 3u);
    answer(upload, "RLL2SRV_P", 50);  // another one's
    run(upload, 5);
    EXPECT_EQ(upload.failure(), "parameter WP_RADIUS: the autopilot does not answer");
}

TEST_F(ByWire, reports_the_value_the_autopilot_keeps) {
    ParameterUpload upload(link, {{"WP_RADIUS", 50}});
    run(upload, 0.1);
    answer(upload, "WP_RADIUS", 30);
    EXPECT_FALSE(upload.done());
    run(upload, 5);
    EXPECT_EQ(upload.failure(), "parameter WP_RADIUS: the autopilot has 30, not 50");
}

TEST_F(ByWire, has_nothing_to_do_for_an_airplane_on_the_defaults) {
    ParameterUpload upload(link, {});
    run(upload, 1);
    EXPECT_TRUE(upload.done());
    EXPECT_TRUE(sent().empty());
}

namespace {

// A board with the flying wing on its ramp.
class WingBoard : public EchoBoard {
public:
    World& world() override { return wing_; }

private:
    static WorldOptions wing() {
        WorldOptions options;
        options.airplane = "flying_wing";
        return options;
    }
    World wing_{wing()};
};

}  // namespace

TEST_F(ByWire, a_thrower_waits_for_three_heartbeats_armed_and_in_auto) {
    WingBoard wing;
    Thrower thrower(wing, kUsart);
    uint64_t time_us = 0;
    const auto beat = [&](uint32_t mode, bool armed) {
        mavlink::Heartbeat message{};
        message.custom_mode = mode;
        message.base_mode = armed ? mavlink::MavModeFlag::safety_armed : 0;
        uint8_t bytes[mavlink::kLongestFrame];
        const auto size = mavlink::encode({mavlink::Framing::v2, 0, 1, 1}, message, bytes);
        for (uint16_t i = 0; i < size; ++i) thrower.receive(bytes[i], time_us);
        wing.world().advanceTo(time_us += kSecond_us);
        return wing.world().truth().north_m > 1;
    };
    constexpr uint32_t kAuto = 10;
    EXPECT_FALSE(beat(kAuto, true) || beat(kAuto, true) || beat(0, true));
    EXPECT_FALSE(beat(kAuto, true) || beat(kAuto, false));
    EXPECT_FALSE(beat(kAuto, true) || beat(kAuto, true));
    EXPECT_TRUE(beat(kAuto, true));
}
