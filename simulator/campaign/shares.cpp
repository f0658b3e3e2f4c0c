// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/campaign/shares.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "simulator/campaign/statistics.hpp"

namespace simulator {
namespace {

constexpr size_t kWorst = 10;

double limitOf(const Goal& goal) { return kDrawnTimes * goal.windy; }

// Infinite when the flight does not have it.
double valueOf(const CampaignResult& result, const std::string& figure) {
    const auto found = result.figures.find(figure);
    return found == result.figures.end() ? std::numeric_limits<double>::infinity() : found->second;
}

Share shareOf(const Goal& goal, const std::vector<CampaignResult>& results) {
    Share share{goal.figure, goal.name, goal.unit, limitOf(goal), 0, results.size(), 0, 0, 0, 0};
    std::vector<double> values;
    for (const CampaignResult& result : results) {
        const double value = valueOf(result, goal.figure);
        if (value <= share.limit) ++share.met;
        if (!std::isfinite(value)) continue;
        if (values.empty() || value > share.worst) {
            share.worst = value;
            share.worst_seed = result.flight.seed;
        }
        values.push_back(value);
    }
    if (values.empty()) return share;
    std::sort(values.begin(), values.end());
    share.median = percentile(values, 0.5);
    share.p95 = percentile(values, 0.95);
    return share;
}

// The figure that misses its limit by most.
const Goal& worstGoalOf(const CampaignResult& result) {
    return *std::max_element(goals().begin(), goals().end(), [&](const Goal& a, const Goal& b) {
        return valueOf(result, a.figure) / limitOf(a) < valueOf(result, b.figure) / limitOf(b);
    });
}

double plannedExcess(const CampaignResult& result) {
    double most = 0;
    for (const Goal& goal : goals()) {
        const auto found = result.figures.find(goal.figure);
        if (goal.calibrated || found == result.figures.end()) continue;
        most = std::max(most, found->second / (result.flight.wind.calm() ? goal.calm : goal.windy));
    }
    return most;
}

}  // namespace

std::vector<Share> sharesOf(const std::vector<CampaignResult>& results) {
    std::vector<Share> shares;
    for (const Goal& goal : goals()) shares.push_back(shareOf(goal, results));
    return shares;
}

double excessOf(const CampaignResult& result) {
    if (!result.failure.empty()) return std::numeric_limits<double>::infinity();
    if (!result.flight.drawn) return plannedExcess(result);
    const Goal& goal = worstGoalOf(result);
    return valueOf(result, goal.figure) / limitOf(goal);
}

size_t meetingAll(const std::vector<CampaignResult>& results) {
    return static_cast<size_t>(std::count_if(results.begin(), results.end(),
                                             [](const auto& each) { return excessOf(each) <= 1; }));
}

std::string sharesText(const std::vector<Share>& shares) {
    char line[200];
    std::snprintf(line, sizeof line, "%-42s %7s %6s %8s %9s %8s  %s\n", "figure", "limit", "met",
                  "median", "95 of 100", "worst", "its seed");
    std::string text = line;
    for (const Share& s : shares) {
        const double percent = s.flights == 0 ? 0 : 100.0 * double(s.met) / double(s.flights);
        std::snprintf(line, sizeof line, "%-42.42s %7.2f %5.0f%% %8.2f %9.2f %8.2f  %llu\n",
                      (s.name + ", " + s.unit).c_str(), s.limit, percent, s.median, s.p95, s.worst,
                      static_cast<unsigned long long>(s.worst_seed));
        text += line;
    }
    return text;
}

std::string worstText(const std::vector<CampaignResult>& results) {
    std::vector<const CampaignResult*> sorted;
    for (const CampaignResult& each : results)
        if (each.failure.empty() && excessOf(each) > 1) sorted.push_back(&each);
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const auto* a, const auto* b) { return excessOf(*a) > excessOf(*b); });
    std::string text = "\nevery limit is met by " + std::to_string(meetingAll(results)) + " of " +
                       std::to_string(results.size()) + " flights\n";
    for (size_t i = 0; i < std::min(kWorst, sorted.size()); ++i) {
        const Goal& goal = worstGoalOf(*sorted[i]);
        char line[200];
        std::snprintf(line, sizeof line, "  %s of %.2f %s, limit %.2f: ", goal.name.c_str(),
                      valueOf(*sorted[i], goal.figure), goal.unit.c_str(), limitOf(goal));
        text += line + sorted[i]->flight.replay(true) + "\n";
    }
    return text;
}

}  // namespace simulator
