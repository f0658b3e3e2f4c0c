// SPDX-License-Identifier: GPL-3.0-or-later
// Where an airplane touched down, as its landing saw it.
#pragma once
#include <optional>
#include <vector>

#include "simulator/ground/plan.hpp"
#include "simulator/report/recorder.hpp"

namespace simulator {

struct Touchdown {
    double long_m, right_m;  // past the landing point along the final leg, and right of that leg
};

// Empty where the plan has no landing with a leg to it, or nothing was recorded then.
std::optional<Touchdown> touchdownAt(double time_s, const std::vector<Sample>& samples,
                                     const Plan& plan);

}  // namespace simulator
