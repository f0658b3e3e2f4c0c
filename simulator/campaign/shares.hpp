// SPDX-License-Identifier: GPL-3.0-or-later
// What share of the flights in drawn worlds meets each goal, and which are the worst.
#pragma once
#include <string>
#include <vector>

#include "simulator/campaign/flight.hpp"
#include "simulator/report/goals.hpp"

namespace simulator {

constexpr double kDrawnTimes = 1.5;  // a drawn world may take so many times a goal in wind

struct Share {
    std::string figure, name, unit;
    double limit = 0;  // kDrawnTimes included
    size_t met = 0, flights = 0;
    double median = 0, p95 = 0, worst = 0;  // of the flights that have the figure
    uint64_t worst_seed = 0;
};

// In the order of the goals. A flight without the figure has not met its goal.
std::vector<Share> sharesOf(const std::vector<CampaignResult>& results);
// How many times its limit the worst figure of a flight is, in a drawn world; else its goal, among
// the figures that it has. Infinite when it failed.
double excessOf(const CampaignResult& result);
size_t meetingAll(const std::vector<CampaignResult>& results);

// For the terminal: the shares, and the ten flights that miss by most.
std::string sharesText(const std::vector<Share>& shares);
std::string worstText(const std::vector<CampaignResult>& results);

}  // namespace simulator
