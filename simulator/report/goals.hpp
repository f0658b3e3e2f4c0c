// SPDX-License-Identifier: GPL-3.0-or-later
// How exactly a flight ought to be flown, by the figures of summary.json (docs/airplanes.md).
#pragma once
#include <optional>
#include <string>
#include <vector>

namespace simulator {

struct Goal {
    std::string figure, name, unit;  // "crosstrack_rms_m", its words, "m"
    double calm = 0, windy = 0;      // the most it may be
    bool calibrated = false;         // only of an airplane with a calibrated compass
};

const std::vector<Goal>& goals();
// Empty: it has none.
std::optional<double> goalOf(const std::string& figure, bool windy, bool calibrated);

}  // namespace simulator
