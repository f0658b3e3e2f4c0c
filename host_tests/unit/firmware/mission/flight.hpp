// SPDX-License-Identifier: GPL-3.0-or-later
// A mission flown natively, of either set, for tests of what its commands do to the airplane.
#pragma once
#include "mission_rig.hpp"

namespace firmware {

class MissionFlight : public Rig {
protected:
    static int reachedItem() {
        uint16_t index = 0;
        return takeReached(index) ? index : -1;
    }
    static void expectTo(const MissionItem& item) {
        EXPECT_EQ(vehicle.demand.to.latitude_e7, item.x);
        EXPECT_EQ(vehicle.demand.to.longitude_e7, item.y);
        EXPECT_FLOAT_EQ(vehicle.demand.height_m, item.z);
    }
};

class Apm1Flight : public MissionFlight {
protected:
    void SetUp() override {
        MissionFlight::SetUp();
        parameters.mission_set = 1;
    }
    // The command runs beside the first waypoint.
    static void run(const MissionItem& item) { fly({waypoint(500), item, waypoint(900)}); }
};

}  // namespace firmware
