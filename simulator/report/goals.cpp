// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/report/goals.hpp"

#include <nlohmann/json.hpp>

#include "shared_tables.hpp"

namespace simulator {

static std::vector<Goal> read() {
    std::vector<Goal> all;
    const nlohmann::json found = nlohmann::json::parse(tables::k_limits);
    for (const auto& row : found["figures"])
        all.push_back({row["key"], row["name"], row["unit"], row["goal"]["calm"],
                       row["goal"]["wind"], row.value("calibrated", false)});
    return all;
}

const std::vector<Goal>& goals() {
    static const std::vector<Goal> all = read();
    return all;
}

std::optional<double> goalOf(const std::string& figure, bool windy, bool calibrated) {
    for (const Goal& goal : goals())
        if (goal.figure == figure && (calibrated || !goal.calibrated))
            return windy ? goal.windy : goal.calm;
    return std::nullopt;
}

}  // namespace simulator
