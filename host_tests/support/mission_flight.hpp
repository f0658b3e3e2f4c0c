// SPDX-License-Identifier: GPL-3.0-or-later
// A mission flown natively, of either set, for tests of what its commands do to the airplane.
#pragma once
#include "core/maths.hpp"
#include "firmware/actuators/camera.hpp"
#include "host_tests/support/fakes/vehicle.hpp"
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

class Beyond : public MissionFlight {
protected:
    void SetUp() override {
        MissionFlight::SetUp();
        cameraStart();
        course(0);
    }
    static void course(float degrees, float speed_mps = 15) {
        auto& estimate = mutable_vehicle.estimate;
        estimate.ground_speed_mps = speed_mps;
        estimate.velocity_mps = {speed_mps * cosf(core::radians(degrees)),
                                 speed_mps * sinf(core::radians(degrees)), 0};
        estimate.course_cd = core::wrap360_cd(core::rounded(degrees * 100));
    }
    static void moveTo(const MissionItem& item) {
        mutable_vehicle.estimate.position = {item.x, item.y};
    }
    static float bearingOfPath() {
        return static_cast<float>(geo::bearing_cd(vehicle.demand.from, vehicle.demand.to)) / 100;
    }
};

}  // namespace firmware
