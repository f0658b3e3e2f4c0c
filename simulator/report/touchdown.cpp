// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/report/touchdown.hpp"

#include <algorithm>

namespace simulator {

std::optional<Touchdown> touchdownAt(double time_s, const std::vector<Sample>& samples,
                                     const Plan& plan) {
    const std::optional<Point> point = plan.landing();
    const auto sample = std::find_if(samples.begin(), samples.end(),
                                     [&](const Sample& each) { return each.time_s >= time_s; });
    if (!point || !plan.navs.back().from || sample == samples.end()) return std::nullopt;
    const Along there = along(*plan.navs.back().from, *point, sample->place);
    return Touchdown{there.along_m - there.length_m, there.across_m};
}

}  // namespace simulator
