// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/ground/telemetry.hpp"

#include <gmock/gmock.h>

#include "mavlink/peer.hpp"

using namespace simulator;
using testing::ElementsAre;

namespace {

class TelemetryTest : public testing::Test {
protected:
    template <class Message>
    void receive(const Message& message, double time_s) {
        uint8_t bytes[mavlink::kLongestFrame];
        const auto size = mavlink::encode({mavlink::Framing::v2, 0, 1, 1}, message, bytes);
        for (uint16_t i = 0; i < size; ++i) {
            for (bool whole = parser.put(bytes[i]); whole; whole = parser.next()) {
                telemetry.take(parser.frame(), static_cast<uint64_t>(time_s * 1e6));
            }
        }
    }
    void heartbeat(uint32_t mode, bool armed, double time_s) {
        mavlink::Heartbeat beat{};
        beat.custom_mode = mode;
        beat.autopilot = mavlink::MavAutopilot::ardupilotmega;
        beat.base_mode = armed ? mavlink::MavModeFlag::safety_armed : 0;
        receive(beat, time_s);
    }
    std::vector<std::string> events() const {
        std::vector<std::string> texts;
        for (const Event& event : telemetry.events) texts.push_back(event.text);
        return texts;
    }

    mavlink::PeerParser parser;
    Telemetry telemetry;
};

}  // namespace

TEST_F(TelemetryTest, turns_heartbeats_into_events_when_something_changes) {
    heartbeat(0, false, 1);
    heartbeat(0, false, 2);
    heartbeat(0, true, 3);
    heartbeat(10, true, 4);
    heartbeat(10, false, 5);

    EXPECT_THAT(events(), ElementsAre("mode MANUAL", "armed", "mode AUTO", "disarmed"));
}

TEST_F(TelemetryTest, does_not_take_a_ground_station_for_a_vehicle) {
    mavlink::Heartbeat beat{};
    beat.autopilot = mavlink::MavAutopilot::invalid;
    receive(beat, 1);

    EXPECT_FALSE(telemetry.heard());
}

TEST_F(TelemetryTest, lists_the_items_reached) {
    for (const uint16_t item : {1, 3, 4}) receive(mavlink::MissionItemReached{item}, item);

    EXPECT_THAT(telemetry.reached, ElementsAre(1, 3, 4));
}

TEST_F(TelemetryTest, takes_an_autopilot_without_the_prearm_bit_for_ready) {
    receive(mavlink::SysStatus{}, 1);
    EXPECT_TRUE(telemetry.prearmOk());

    mavlink::SysStatus status{};
    status.onboard_control_sensors_present = 0x10000000;
    receive(status, 2);
    EXPECT_FALSE(telemetry.prearmOk());
}

TEST(ModeName, names_the_modes_it_knows_and_numbers_the_others) {
    EXPECT_EQ(modeName(10), "AUTO");
    EXPECT_EQ(modeName(9), "mode 9");
    EXPECT_EQ(modeName(77), "mode 77");
}
