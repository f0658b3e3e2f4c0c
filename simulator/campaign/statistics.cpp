// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/campaign/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace simulator {

double percentile(const std::vector<double>& sorted, double share) {
    const auto rank = static_cast<size_t>(std::ceil(share * static_cast<double>(sorted.size())));
    return sorted[std::clamp<size_t>(rank, 1, sorted.size()) - 1];
}

std::vector<std::string> figuresOf(const std::vector<CampaignResult>& results) {
    std::set<std::string> names;
    for (const auto& result : results)
        for (const auto& figure : result.figures) names.insert(figure.first);
    return {names.begin(), names.end()};
}

std::vector<std::string> groupsOf(const std::vector<CampaignResult>& results) {
    std::vector<std::string> groups;
    for (const auto& result : results) {
        const std::string group = result.flight.group();
        if (std::find(groups.begin(), groups.end(), group) == groups.end()) groups.push_back(group);
    }
    return groups;
}

std::vector<double> valuesOf(const std::vector<CampaignResult>& results, const std::string& group,
                             const std::string& figure) {
    std::vector<double> values;
    for (const auto& result : results) {
        const auto found = result.figures.find(figure);
        if (found != result.figures.end() && result.flight.group() == group)
            values.push_back(found->second);
    }
    std::sort(values.begin(), values.end());
    return values;
}

static const CampaignFlight& flightWith(const std::vector<CampaignResult>& results,
                                        const std::string& group, const std::string& figure,
                                        double value) {
    return std::find_if(results.begin(), results.end(),
                        [&](const CampaignResult& result) {
                            const auto found = result.figures.find(figure);
                            return found != result.figures.end() && found->second == value &&
                                   result.flight.group() == group;
                        })
        ->flight;
}

std::vector<Spread95> spreadsOf(const std::vector<CampaignResult>& results) {
    std::vector<Spread95> spreads;
    const auto groups = groupsOf(results);
    for (const auto& figure : figuresOf(results)) {
        for (const auto& group : groups) {
            const auto values = valuesOf(results, group, figure);
            if (values.empty()) continue;
            spreads.push_back({group, figure, values.size(), percentile(values, 0.5),
                               percentile(values, 0.95), values.back(),
                               flightWith(results, group, figure, values.back())});
        }
    }
    return spreads;
}

std::string tableText(const std::vector<CampaignResult>& results) {
    std::string text, figure;
    char line[160];
    for (const Spread95& s : spreadsOf(results)) {
        if (s.figure != figure) {
            figure = s.figure;
            std::snprintf(line, sizeof line, "%-44s %8s %9s %8s  %s\n", figure.c_str(), "median",
                          "95 of 100", "worst", "its seed");
            text += (text.empty() ? "" : "\n") + std::string(line);
        }
        std::snprintf(line, sizeof line, "  %-42.42s %8.2f %9.2f %8.2f  %llu\n", s.group.c_str(),
                      s.median, s.p95, s.worst,
                      static_cast<unsigned long long>(s.worst_flight.seed));
        text += line;
    }
    return text;
}

}  // namespace simulator
