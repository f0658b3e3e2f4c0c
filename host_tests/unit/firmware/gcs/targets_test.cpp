// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/gcs/targets.hpp"

#include <cmath>

#include "ground.hpp"

namespace ground {
namespace {

using firmware::state::Mode;
using firmware::state::mutable_vehicle;
using mavlink::MavFrame;
using Texts = std::vector<std::string>;

class Targets : public Telemetry {
protected:
    void SetUp() override {
        Telemetry::SetUp();
        run_ms(5000);
        station.framing = Framing::v2;
        mutable_vehicle.mode = Mode::guided;
        mutable_vehicle.demand.height_m = 80;
        station.forget();
    }
    template <class Message>
    void send(Message message) {
        message.target_system = message.target_component = 1;
        station.send(message);
        run_ms(40);
    }
    static mavlink::SetPositionTargetGlobalInt place(uint16_t type_mask) {
        mavlink::SetPositionTargetGlobalInt target = {};
        target.coordinate_frame = MavFrame::global_relative_alt_int;
        target.type_mask = type_mask;
        target.lat_int = 473977001;
        target.lon_int = 85456002;
        target.alt = 60;
        return target;
    }
    // As QGroundControl changes the altitude.
    static mavlink::SetPositionTargetLocalNed down(float by_m) {
        mavlink::SetPositionTargetLocalNed target = {};
        target.coordinate_frame = MavFrame::local_offset_ned;
        target.type_mask = 0xFFF8;
        target.z = by_m;
        return target;
    }
};

TEST_F(Targets, a_place_is_flown_to_in_guided) {
    send(place(0x0FF8));
    ASSERT_EQ(doubles::vehicle.targets.size(), 1u);
    EXPECT_EQ(doubles::vehicle.targets[0].x, 473977001);
    EXPECT_EQ(doubles::vehicle.targets[0].y, 85456002);
    EXPECT_EQ(doubles::vehicle.targets[0].z, 60);
    EXPECT_EQ(doubles::vehicle.targets[0].frame, +MavFrame::global_relative_alt_int);
    EXPECT_EQ(doubles::vehicle.targets[0].command, +mavlink::MavCmd::nav_waypoint);
    EXPECT_TRUE(station.texts().empty());
}

TEST_F(Targets, a_height_or_a_place_may_be_left_out) {
    send(place(0x0FFB));
    ASSERT_EQ(doubles::vehicle.heights.size(), 1u);
    EXPECT_EQ(doubles::vehicle.heights[0].z, 60);
    EXPECT_TRUE(doubles::vehicle.targets.empty());
    send(place(0x0FFC));
    ASSERT_EQ(doubles::vehicle.targets.size(), 1u);
    EXPECT_TRUE(std::isnan(doubles::vehicle.targets[0].z));
}

TEST_F(Targets, an_offset_down_changes_the_height_that_is_flown) {
    send(down(-20));
    ASSERT_EQ(doubles::vehicle.heights.size(), 1u);
    EXPECT_EQ(doubles::vehicle.heights[0].z, 100);
    EXPECT_EQ(doubles::vehicle.heights[0].frame, +MavFrame::global_relative_alt);
    EXPECT_TRUE(station.texts().empty());
}

TEST_F(Targets, what_is_not_flown_is_refused_by_a_text_and_not_at_ten_hertz) {
    for (int i = 0; i < 20; ++i) {
        send(place(0x0DC7));  // a speed alone
        run_ms(60);
    }
    const Texts texts = station.texts();
    EXPECT_GE(texts.size(), 1u);
    EXPECT_LE(texts.size(), 2u);
    EXPECT_EQ(texts.at(0), "Message 86 refused");
    EXPECT_TRUE(doubles::vehicle.targets.empty() && doubles::vehicle.heights.empty());
}

TEST_F(Targets, are_refused_outside_of_guided_and_in_other_frames) {
    auto sideways = down(-20);
    sideways.x = 5;
    auto absolute = down(-20);
    absolute.coordinate_frame = 1;
    for (const auto& wrong : {sideways, absolute}) {
        send(wrong);
        EXPECT_EQ(station.texts(), Texts{"Message 84 refused"});
        run_ms(5000);
    }
    mutable_vehicle.mode = Mode::cruise;
    send(place(0x0FF8));
    EXPECT_EQ(station.texts(), Texts{"Message 86 refused"});
    EXPECT_TRUE(doubles::vehicle.targets.empty() && doubles::vehicle.heights.empty());
}

TEST_F(Targets, attitudes_are_refused) {
    mavlink::SetAttitudeTarget attitude = {};
    attitude.thrust_body[2] = 1;
    send(attitude);
    EXPECT_EQ(station.texts(), Texts{"Message 82 refused"});
}

}  // namespace
}  // namespace ground
