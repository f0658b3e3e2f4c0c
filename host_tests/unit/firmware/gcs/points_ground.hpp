// SPDX-License-Identifier: GPL-3.0-or-later
// A ground station that uploads, downloads and changes fence and rally points.
#pragma once
#include <algorithm>

#include "firmware/mission/rally.hpp"
#include "ground.hpp"

namespace ground {

using firmware::state::parameters;
using mavlink::MavCmd;
using mavlink::MavMissionResult;
using mavlink::MavMissionType;

constexpr uint8_t kFence = MavMissionType::fence, kRally = MavMissionType::rally;
constexpr int32_t kNorth_e7 = 473977000, kEast_e7 = 85456000;
constexpr int kSquare[4][2] = {{-9000, -9000}, {-9000, 9000}, {9000, 9000}, {9000, -9000}};

template <class Message>
Message toVehicle() {
    Message message = {};
    message.target_system = message.target_component = 1;
    return message;
}

inline mavlink::MissionCount count(uint16_t items, uint8_t type) {
    auto message = toVehicle<mavlink::MissionCount>();
    message.count = items;
    message.mission_type = type;
    return message;
}

inline mavlink::MissionItemInt item(uint8_t type, uint16_t command, int32_t x, int32_t y) {
    auto message = toVehicle<mavlink::MissionItemInt>();
    message.command = command;
    message.frame = 3;
    message.x = x;
    message.y = y;
    message.mission_type = type;
    return message;
}
using Items = std::vector<mavlink::MissionItemInt>;

// A return point, and a square about it.
inline Items square() {
    Items items = {item(kFence, MavCmd::nav_fence_return_point, kNorth_e7, kEast_e7)};
    for (const auto& corner : kSquare) {
        items.push_back(item(kFence, MavCmd::nav_fence_polygon_vertex_inclusion,
                             kNorth_e7 + corner[0], kEast_e7 + corner[1]));
        items.back().param1 = 4;
    }
    return items;
}
// A square, a triangle and a circle to stay out of, a circle to stay in, a return point.
inline Items zones() {
    Items items = square();
    items.erase(items.begin());
    const auto add = [&](uint16_t command, int32_t north_e7, int32_t east_e7, float param1) {
        items.push_back(item(kFence, command, kNorth_e7 + north_e7, kEast_e7 + east_e7));
        items.back().param1 = param1;
    };
    add(MavCmd::nav_fence_polygon_vertex_exclusion, 4000, 4000, 3);
    add(MavCmd::nav_fence_polygon_vertex_exclusion, 4000, 5000, 3);
    add(MavCmd::nav_fence_polygon_vertex_exclusion, 5000, 4000, 3);
    add(MavCmd::nav_fence_circle_exclusion, -4000, 0, 12.5f);
    items.back().frame = 0;
    add(MavCmd::nav_fence_circle_inclusion, 0, 0, 1500);
    add(MavCmd::nav_fence_return_point, 10, 20, 0);
    // items 0 to 3 are the square's, 4 to 6 the triangle's
    add(MavCmd::nav_fence_circle_exclusion, 0, -4000, 30.1f);
    return items;
}
inline Items threeRallyPoints() {
    Items items;
    for (int i = 0; i < 3; ++i) {
        items.push_back(item(kRally, MavCmd::nav_rally_point, kNorth_e7 + i, kEast_e7 - i));
        items.back().z = 10.25f * static_cast<float>(i) - 5;
    }
    items[2].frame = 0;
    return items;
}

using Results = std::vector<int>;

class Points : public Telemetry {
protected:
    void SetUp() override {
        Telemetry::SetUp();
        station.framing = second.framing = Framing::v2;
        firmware::safety::runFence();
    }
    // As Telemetry's, and what follows the lists at 10 Hz.
    void live_ms(uint32_t time_ms) {
        for (uint32_t ms = 0; ms < time_ms; ms += 100) {
            run_ms(100);
            firmware::safety::runFence();
            firmware::mission::rallyFollow();
        }
    }
    template <class Message>
    void give(const Message& message) {
        station.send(message);
        run_ms(20);
    }
    Results acks(Station& from, uint8_t type) {
        Results results;
        for (const auto& ack : from.all<mavlink::MissionAck>()) {
            EXPECT_EQ(ack.mission_type, type);
            results.push_back(ack.type);
        }
        return results;
    }
    Results upload(const Items& items, uint8_t type) {
        give(count(static_cast<uint16_t>(items.size()), type));
        for (uint16_t seq = 0; seq < items.size(); ++seq) {
            const auto asked = station.all<mavlink::MissionRequestInt>();
            if (asked.size() != 1 || asked[0].seq != seq || asked[0].mission_type != type) break;
            auto each = items[seq];
            each.seq = seq;
            give(each);
        }
        const Results results = acks(station, type);
        live_ms(200);
        return results;
    }
    Items download(uint8_t type) {
        auto list = toVehicle<mavlink::MissionRequestList>();
        list.mission_type = type;
        const auto counts = ask<mavlink::MissionCount>(list);
        EXPECT_EQ(counts.size(), 1u);
        Items items;
        for (uint16_t seq = 0; !counts.empty() && seq < counts[0].count; ++seq) {
            auto request = toVehicle<mavlink::MissionRequestInt>();
            request.seq = seq;
            request.mission_type = type;
            for (const auto& each : ask<mavlink::MissionItemInt>(request)) items.push_back(each);
        }
        return items;
    }
    uint8_t setParameter(const char* name, float value) {
        auto message = toVehicle<mavlink::ParamSet>();
        memcpy(message.param_id, name, std::min(strlen(name), sizeof message.param_id));
        message.param_value = value;
        const auto answers = ask<mavlink::ParamValue>(message, 200);
        EXPECT_EQ(answers.size(), 1u);
        return answers.empty() ? 0xFF : static_cast<uint8_t>(answers[0].param_value);
    }
};

inline void expectSame(const Items& is, const Items& was) {
    ASSERT_EQ(is.size(), was.size());
    for (size_t i = 0; i < is.size(); ++i) {
        EXPECT_EQ(is[i].command, was[i].command) << i;
        EXPECT_EQ(is[i].frame, was[i].frame) << i;
        EXPECT_EQ(is[i].x, was[i].x) << i;
        EXPECT_EQ(is[i].y, was[i].y) << i;
        EXPECT_FLOAT_EQ(is[i].z, was[i].z) << i;
        EXPECT_FLOAT_EQ(is[i].param1, was[i].param1) << i;
        EXPECT_EQ(is[i].mission_type, was[i].mission_type) << i;
        EXPECT_EQ(is[i].current, 0) << i;
    }
}

}  // namespace ground
