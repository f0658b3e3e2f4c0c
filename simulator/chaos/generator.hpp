// SPDX-License-Identifier: GPL-3.0-or-later
// Draws scenarios: the same number, the same scenario.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "simulator/chaos/scenario.hpp"

namespace simulator::chaos {

struct ParameterRow {
    std::string name;
    double lowest, highest;
};
// Of the firmware's table, those that can be changed without losing the link.
std::vector<ParameterRow> readParameterRows(const std::string& csv_path);

Scenario drawScenario(uint64_t seed, const std::vector<ParameterRow>& parameters);

}  // namespace simulator::chaos
