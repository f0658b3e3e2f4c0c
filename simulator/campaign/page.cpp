// SPDX-License-Identifier: GPL-3.0-or-later
// The campaign's page: a verdict, the distribution and the table of every figure, and the flights
// that failed.
#include <algorithm>
#include <cctype>
#include <regex>

#include "simulator/campaign/statistics.hpp"
#include "simulator/report/chart.hpp"
#include "simulator/report/html.hpp"

namespace simulator {
namespace {

constexpr const char* kColours[] = {"#1f6feb", "#b42318", "#18794e", "#b4690e",
                                    "#6f42c1", "#0e7490", "#be185d", "#4d5d6c",
                                    "#7c8a00", "#1c2430", "#e07b39", "#5b8def"};
constexpr size_t kMaxFailures = 50;

long failures(const std::vector<CampaignResult>& results) {
    return std::count_if(results.begin(), results.end(),
                         [](const CampaignResult& r) { return !r.failure.empty(); });
}

// The share of the flights that stay at or below each value, a step at each flight.
Points distribution(const std::vector<double>& sorted) {
    Points points;
    const auto count = static_cast<double>(sorted.size());
    for (size_t i = 0; i < sorted.size(); ++i) {
        points.emplace_back(sorted[i], 100 * static_cast<double>(i) / count);
        points.emplace_back(sorted[i], 100 * static_cast<double>(i + 1) / count);
    }
    return points;
}

// "crosstrack_rms_m" as "Crosstrack rms, m".
std::string spelled(std::string figure) {
    const size_t unit = figure.rfind('_');
    figure[0] = static_cast<char>(std::toupper(figure[0]));
    std::string words = figure.substr(0, unit) + ", " + figure.substr(unit + 1);
    std::replace(words.begin(), words.end(), '_', ' ');
    return std::regex_replace(words, std::regex(" mps$"), " m/s");
}

template <class Of>
std::vector<std::string> different(const std::vector<CampaignResult>& results, Of of) {
    std::vector<std::string> names;
    for (const auto& result : results) {
        const std::string name = of(result.flight);
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
    return names;
}
std::vector<std::string> airplanesOf(const std::vector<CampaignResult>& results) {
    return different(results, [](const CampaignFlight& f) { return f.airplaneName(); });
}
// Each mission in each wind.
std::vector<std::string> placesOf(const std::vector<CampaignResult>& results) {
    return different(results,
                     [](const CampaignFlight& f) { return f.missionName() + " " + f.wind.name(); });
}

// A mission in a wind: a line for every airplane.
std::string chartOf(const std::vector<CampaignResult>& results, const std::string& figure,
                    const std::string& place) {
    Chart chart;
    chart.x_label = place + ": " + spelled(figure);
    chart.y_label = "flights, %";
    chart.y_from = 0;
    chart.y_to = 100;
    chart.width = 520;
    const auto airplanes = airplanesOf(results);
    for (size_t i = 0; i < airplanes.size(); ++i) {
        const auto values = valuesOf(results, airplanes[i] + " " + place, figure);
        if (!values.empty())
            chart.lines.push_back({airplanes[i], kColours[i % std::size(kColours)], Stroke::solid,
                                   distribution(values)});
    }
    return chart.lines.empty() ? "" : "<div>" + drawChart(chart) + "</div>";
}

std::string tableOf(const std::vector<Spread95>& spreads, const std::string& figure) {
    Table table({"", "flights", "median", "95 of 100", "worst", "its seed"});
    for (const Spread95& s : spreads)
        if (s.figure == figure)
            table.row({s.group, std::to_string(s.flights), fixed(s.median, 2), fixed(s.p95, 2),
                       fixed(s.worst, 2), std::to_string(s.worst_flight.seed)});
    return table.done();
}

std::string failureList(const std::vector<CampaignResult>& results) {
    std::string list;
    size_t shown = 0;
    for (const auto& result : results) {
        if (result.failure.empty() || shown++ >= kMaxFailures) continue;
        list += "<p><b>" + escaped(result.flight.group()) + ", seed " +
                std::to_string(result.flight.seed) + "</b>: " + escaped(result.failure) +
                "<br><code>" + escaped(result.flight.replay(true)) + "</code></p>\n";
    }
    if (shown > kMaxFailures)
        list += "<p>and " + std::to_string(shown - kMaxFailures) + " more</p>\n";
    return list;
}

std::string cards(const std::vector<CampaignResult>& results, double wall_s) {
    double emulated_s = 0;
    for (const auto& result : results) emulated_s += result.emulated_s;
    return "<div class=\"cards\">" + htmlCard("flights", std::to_string(results.size())) +
           htmlCard("not as they should be", std::to_string(failures(results))) +
           htmlCard("emulated", fixed(emulated_s / 3600, 1) + " h") +
           htmlCard("took", fixed(wall_s / 60, 1) + " min") +
           htmlCard("times real time", fixed(emulated_s / std::max(wall_s, 1e-3), 0)) + "</div>\n";
}

}  // namespace

std::string flownText(size_t flown, size_t planned, size_t failed) {
    const std::string failures = ", " + std::to_string(failed) + " failed";
    if (flown == planned) return std::to_string(flown) + " flights" + failures;
    return "interrupted: " + std::to_string(flown) + " of " + std::to_string(planned) +
           " flights were flown" + failures;
}

std::string campaignPage(const std::vector<CampaignResult>& results, size_t planned,
                         double wall_s) {
    const auto bad = static_cast<size_t>(failures(results));
    const bool all_well = bad == 0 && results.size() == planned;
    std::string page =
        htmlHead("Campaign") + "<header><h1>Campaign</h1><span class=\"verdict" +
        (all_well ? "\">every flight completed"
                  : " bad\">" + flownText(results.size(), planned, bad)) +
        "</span></header>\n<p class=\"sub\">natively compiled firmware · sensor errors and gusts "
        "drawn from each seed</p>\n" +
        cards(results, wall_s) + htmlSection("Flights that failed", failureList(results));
    const auto spreads = spreadsOf(results);
    for (const auto& figure : figuresOf(results)) {
        std::string body;
        for (const auto& place : placesOf(results)) body += chartOf(results, figure, place);
        page += htmlSection(spelled(figure),
                            "<div class=\"pair\">" + body + "</div>" + tableOf(spreads, figure),
                            "Of an airplane's flights so many per cent are at or below the value. "
                            "Wind: m/s, from degrees, with gusts.");
    }
    if (!results.empty())
        page += htmlSection(
            "A flight again",
            "<p>" + escaped(results.front().flight.replay(true)) + "</p><p>" +
                escaped(results.front().flight.replay(false)) + "</p>",
            "Natively, and the image on the emulated chip; with the airplane, wind, seed and "
            "mission of the flight.");
    return page + kHtmlEnd;
}

}  // namespace simulator
