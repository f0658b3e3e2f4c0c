// SPDX-License-Identifier: GPL-3.0-or-later
// What many flights come down to: of each figure in each group of flights the median, the 95th
// percentile, and the worst flight.
#pragma once
#include <string>
#include <vector>

#include "simulator/campaign/flight.hpp"

namespace simulator {

struct Spread95 {
    std::string group, figure;
    size_t flights = 0;
    double median = 0, p95 = 0, worst = 0;
    CampaignFlight worst_flight;
};

// `share` 0..1 of the values are not larger (nearest rank); `sorted` must not be empty.
double percentile(const std::vector<double>& sorted, double share);

std::vector<std::string> figuresOf(const std::vector<CampaignResult>& results);
std::vector<std::string> groupsOf(const std::vector<CampaignResult>& results);

// The values of a figure in a group, sorted; of failed flights too, as far as they have one.
std::vector<double> valuesOf(const std::vector<CampaignResult>& results, const std::string& group,
                             const std::string& figure);

// Figure by figure, in each the groups; figures no flight of a group has are left out.
std::vector<Spread95> spreadsOf(const std::vector<CampaignResult>& results);

// For the terminal.
std::string tableText(const std::vector<CampaignResult>& results);

}  // namespace simulator
