// SPDX-License-Identifier: GPL-3.0-or-later
// A fence as geometry around home, in metres.
#pragma once
#include <vector>

#include "simulator/ground/mission_file.hpp"
#include "simulator/ground/plan.hpp"

namespace mission_tool {

class FenceCheck {
public:
    FenceCheck(const simulator::Fence& fence, const simulator::LocalFrame& frame);

    // How far a place is from being allowed; below 0 it is, and so far from the line.
    double outside_m(const simulator::Point& place) const;
    // The worst of a straight way, and of a circle.
    double outsideOnLeg_m(const simulator::Point& from, const simulator::Point& to) const;
    double outsideOnCircle_m(const simulator::Point& centre, double radius_m) const;

private:
    struct Area {
        bool inclusion;
        std::vector<simulator::Point> rim;
        double radius_m;
        double beyond_m(const simulator::Point& place) const;  // below 0: within
    };
    std::vector<Area> areas_;
};

// What the firmware would not take of it, or not act on; empty: nothing.
struct FenceProblem {
    bool error;
    std::string text;
};
std::vector<FenceProblem> problemsOf(const simulator::Fence& fence,
                                     const simulator::LocalFrame& frame);

}  // namespace mission_tool
