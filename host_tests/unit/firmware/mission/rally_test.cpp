// SPDX-License-Identifier: GPL-3.0-or-later
// Where the airplane returns to.
#include "firmware/mission/rally.hpp"

#include "host_tests/support/fakes/vehicle.hpp"
#include "points_rig.hpp"

namespace firmware {
namespace {

using mavlink::MavCmd;
using mavlink::MavMissionType;

class Rally : public Points {
protected:
    void SetUp() override {
        Rig::SetUp();
        fenceStart();
        parameters.rally_limit_km = 0.3f;
        mutable_vehicle.estimate.position = beside(180000, 0);  // 2 km north of home
    }
    static void expectReturn(const Items& points, const geo::Position& to, float height_m) {
        ASSERT_EQ(store(MavMissionType::rally, points), MissionResult::accepted);
        requestMode(Mode::loiter, ModeReason::ground);
        ASSERT_TRUE(requestMode(Mode::rtl, ModeReason::ground));
        EXPECT_EQ(vehicle.demand.to, kHome);  // at once
        tenths(12);
        EXPECT_EQ(vehicle.demand.to, to);
        EXPECT_NEAR(vehicle.demand.height_m, height_m, 0.01);
    }
    static MissionItem at(int32_t north_e7, int32_t east_e7, float z) {
        return point(MavCmd::nav_rally_point, beside(north_e7, east_e7), 0, z);
    }
};

TEST_F(Rally, the_nearest_is_returned_to) {
    expectReturn({at(0, 90000, 40), at(120000, 0, 55.25f), at(150000, 90000, 60)},
                 beside(120000, 0), 55.25f);
    EXPECT_TRUE(hasStatusText("Going to rally point 1"));
}

TEST_F(Rally, home_is_returned_to_when_it_is_nearer_and_the_point_is_far) {
    mutable_vehicle.estimate.position = beside(30000, 0);  // 0.33 km from home
    parameters.rtl_height_cm = 8000;
    expectReturn({at(70000, 0, 40)}, kHome, 80);  // 0.44 km
}

TEST_F(Rally, a_point_within_the_limit_goes_before_home) {
    mutable_vehicle.estimate.position = beside(10000, 0);
    expectReturn({at(30000, 0, 40)}, beside(30000, 0), 40);
}

TEST_F(Rally, an_altitude_above_sea_level_is_converted_to_one_above_home) {
    MissionItem item = at(150000, 0, 470);
    item.frame = kGlobalFrame;
    expectReturn({item}, beside(150000, 0), 70);
}

TEST_F(Rally, without_points_home_it_is) {
    parameters.rtl_height_cm = 8000;
    expectReturn({}, kHome, 80);
}

}  // namespace
}  // namespace firmware
