// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/report/page.hpp"

#include <cmath>
#include <cstdio>

#include "simulator/report/chart.hpp"
#include "simulator/report/flight_charts.hpp"
#include "simulator/report/html.hpp"
#include "simulator/report/tables.hpp"

namespace simulator {
namespace {

std::string card(const char* name, const std::optional<double>& value, const char* format) {
    if (!value) return "";
    char text[64];
    std::snprintf(text, sizeof text, format, *value);
    return htmlCard(name, text);
}

std::string cards(const Summary& s) {
    std::optional<double> load;
    if (s.figures.cpu_load) load = *s.figures.cpu_load * 100;
    return "<div class=\"cards\">" + card("flight time", s.flight_time_s, "%.0f s") +
           card("touch-down from the point", s.landed_distance_m, "%.1f m") +
           card("crosstrack, RMS", s.crosstrack_rms_m, "%.2f m") +
           card("altitude, RMS", s.altitude_rms_m, "%.2f m") +
           card("airspeed, RMS", s.airspeed_rms_mps, "%.2f m/s") +
           card("processor load", load, "%.1f %%") + card("times real time", s.speedup, "%.1f") +
           "</div>\n";
}

std::string violations(const Summary& s) {
    if (s.violations.empty()) return "";
    return htmlSection("Violations", violationTable(s),
                       "What must hold in every flight, and did not.");
}

std::string conditions(const Summary& s) {
    if (s.from_log) return "as the airplane has logged it";
    if (s.wind_mps <= 0 && !s.gusts) return "calm air · seed " + std::to_string(s.seed);
    char text[80];
    std::snprintf(text, sizeof text, "wind %.1f m/s from %.0f°%s", s.wind_mps, s.wind_from_deg,
                  s.gusts ? " with gusts" : "");
    return text + (" · seed " + std::to_string(s.seed));
}

}  // namespace

std::string reportPage(const Summary& summary, const std::vector<Sample>& samples,
                       const Plan& plan) {
    const FlightCharts charts(summary, samples, plan);
    const std::string verdict = summary.completed ? "mission completed" : summary.reason;
    return htmlHead("Flight report") + "<header><h1>Flight report</h1><span class=\"verdict" +
           (summary.completed ? "" : " bad") + "\">" + escaped(verdict) + "</span></header>\n" +
           "<p class=\"sub\">" + escaped(summary.mission) + " · " + escaped(summary.firmware) +
           " on " + escaped(summary.board) + " · " + escaped(conditions(summary)) + "</p>\n" +
           cards(summary) + violations(summary) + "<div class=\"map\">" +
           htmlSection("Ground track", charts.map(),
                       std::string("Dots: the places of the mission's NAV commands. ") +
                           (summary.from_log
                                ? "The flown line is where the airplane took itself to be."
                                : "The flown line is the truth, not the autopilot's estimate.")) +
           htmlSection("Summary", summaryTable(summary), "") + "</div>" +
           htmlSection("Altitude", charts.altitude(),
                       "Above the take-off point. Upright lines: the item flown from there on.") +
           htmlSection("Airspeed", charts.airspeed(), "Equivalent airspeed.") +
           htmlSection("Crosstrack", charts.crosstrack(),
                       "Distance from the straight leg, positive to the right.") +
           htmlSection("Roll against demand", charts.roll(), "") +
           htmlSection("Pitch against demand", charts.pitch(), "") +
           htmlSection("Control surfaces", charts.surfaces(), "") +
           htmlSection("Throttle and outputs 5 to 8", charts.otherServos(), "") +
           htmlSection("Processor load", charts.frames(),
                       "Time awake in the frames of every tenth of a second, interrupts and the "
                       "handling of received bytes included; a frame has 10,000 µs.") +
           htmlSection("Tasks", taskTable(summary),
                       "Interrupts within a task are not counted to it.") +
           "<div class=\"pair\">" +
           htmlSection("Interrupts", interruptTable(summary.figures, summary.emulated_s), "") +
           htmlSection("Events", eventTable(summary), "") + "</div>" +
           htmlSection("Sensor errors of this flight", summary.from_log ? "" : errorTable(),
                       "Deviations are one sigma, drawn from the seed.") +
           kHtmlEnd;
}

}  // namespace simulator
