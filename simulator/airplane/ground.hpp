// SPDX-License-Identifier: GPL-3.0-or-later
// Wheels and skids on flat ground. Along the normal a spring and damper; along the ground each
// contact holds on to the place it touches like a spring until friction lets it slip, so that a
// standing airplane stays where it is.
#pragma once
#include <vector>

#include "simulator/airplane/aerodynamics.hpp"
#include "simulator/airplane/parameters.hpp"

namespace simulator {

// Where the body is and how it moves; height is -position.z.
struct Motion {
    Vec3 position_m, velocity_mps;  // north, east, down
    Quaternion attitude;
    Vec3 rates_rads;  // body
};

class Ground {
public:
    explicit Ground(const AirplaneParameters& p);

    // `rudder` -1..1 turns the steered wheels.
    Loads loads(const Motion& motion, double rudder) const;

    // Lets contacts slip that can not hold; once a step.
    void advance(const Motion& motion, double rudder);

    bool touching() const { return touching_; }
    bool broken() const { return broken_; }
    double standingHeight_m() const;  // of the centre of gravity, on wheels or skids

private:
    struct Touch;  // one contact at one moment
    bool touch(size_t index, const Motion& motion, const Rotation& rotation, double rudder,
               Touch& out) const;

    const AirplaneParameters& p_;
    double reach_m_ = 0;         // no contact is farther from the centre of gravity
    std::vector<Vec3> anchors_;  // where each contact holds on to the ground
    bool touching_ = false, broken_ = false;
};

}  // namespace simulator
