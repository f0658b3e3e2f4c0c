// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/campaign/reports_held.hpp"

namespace simulator {

std::string ReportsHeld::add(double badness, const std::string& report) {
    held_.emplace(badness, report);
    if (held_.size() <= places_) return "";
    const auto least = held_.begin();
    const std::string goes = least->second;
    held_.erase(least);
    return goes;
}

}  // namespace simulator
