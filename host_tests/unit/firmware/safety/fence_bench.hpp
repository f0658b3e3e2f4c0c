// SPDX-License-Identifier: GPL-3.0-or-later
// An airplane inside a fence that is on, and which can leave it.
#pragma once
#include "firmware/mission/fence_line.hpp"
#include "firmware/sensors/radio.hpp"
#include "host_tests/support/fakes/vehicle.hpp"
#include "points_rig.hpp"

namespace firmware {

using mavlink::MavCmd;
using mavlink::MavMissionType;

class FenceBench : public Points {
protected:
    void SetUp() override {
        Rig::SetUp();
        fenceStart();
        parameters.fence_action = 1;
        parameters.rtl_height_cm = 7000;
        parameters.stick_mixing = 1;
    }
    static Items square(const geo::Position& way_back = beside(100, 200)) {
        Items items = {point(MavCmd::nav_fence_return_point, way_back)};
        for (const auto& c : {beside(-kSide_e7, -kSide_e7), beside(-kSide_e7, kSide_e7),
                              beside(kSide_e7, kSide_e7), beside(kSide_e7, -kSide_e7)})
            items.push_back(point(MavCmd::nav_fence_polygon_vertex_inclusion, c, 4));
        return items;
    }
    static void raise(const Items& items = square()) {
        ASSERT_EQ(store(MavMissionType::fence, items), MissionResult::accepted);
        tenths(8);
        ASSERT_EQ(fenceLine(), Line::fit);
        ASSERT_TRUE(fenceEnable(1));
        tenths(2);
        (void)statusTexts();
    }
    static void goTo(const geo::Position& place) {
        mutable_vehicle.estimate.position = place;
        tenths(6);
    }
    // A frame comes every other time.
    static void receiveSwitch(uint16_t pulse_us) {
        for (int i = 0; i < 8; ++i) {
            if (i % 2 == 0) fakes::receiveRc({1500, 1500, 1100, 1500, 1500, 1500, pulse_us, 1500});
            firmware::sensors::runRadio();
        }
    }
    static void moveSwitch(uint16_t pulse_us) {
        receiveSwitch(pulse_us);
        tenths(1);
    }
    static void leave() { goTo(beside(kSide_e7 + 10, 0)); }
    static void comeBack() { goTo(beside(0, 0)); }
};

}  // namespace firmware
