// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/report/page.hpp"

#include <cmath>
#include <cstdio>

#include "simulator/report/chart.hpp"
#include "simulator/report/flight_charts.hpp"
#include "simulator/report/tables.hpp"

namespace simulator {
namespace {

constexpr char kHead[] = R"(<!doctype html>
<html lang="en"><head><meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Flight report</title>
<style>
:root{--ink:#1c2430;--soft:#5d6b7c;--edge:#e1e6ec;--paper:#fff;--ground:#f5f7f9;--good:#18794e;--bad:#b42318}
*{box-sizing:border-box}
body{margin:0;background:var(--ground);color:var(--ink);font:15px/1.5 system-ui,-apple-system,"Segoe UI",Roboto,sans-serif}
main{max-width:1120px;margin:0 auto;padding:28px 20px 60px}
header{display:flex;flex-wrap:wrap;gap:6px 18px;align-items:baseline;margin-bottom:6px}
h1{font-size:26px;margin:0;letter-spacing:-.01em}
h2{font-size:17px;margin:0 0 10px}
.sub{color:var(--soft);margin:0 0 20px}
.verdict{font-weight:600;padding:2px 12px;border-radius:999px;color:#fff;background:var(--good)}
.verdict.bad{background:var(--bad)}
.cards{display:grid;grid-template-columns:repeat(auto-fit,minmax(128px,1fr));gap:12px;margin-bottom:18px}
.card,section{background:var(--paper);border:1px solid var(--edge);border-radius:10px}
.card{padding:12px 14px}
.card b{display:block;font-size:21px;font-weight:600;font-variant-numeric:tabular-nums}
.card span{color:var(--soft);font-size:13px}
section{padding:18px 18px 14px;margin-bottom:18px}
.pair{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(100%,440px),1fr));gap:18px}
.map{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(100%,400px),1fr));gap:18px;align-items:start}
.map section{margin:0}.map{margin-bottom:18px}
@media(min-width:900px){.map{grid-template-columns:3fr 2fr}}
.pair section{margin:0}.pair{margin-bottom:18px;align-items:start}
.wide{overflow-x:auto}
table{border-collapse:collapse;width:100%;font-size:14px;font-variant-numeric:tabular-nums}
th,td{text-align:left;padding:5px 12px 5px 0;border-bottom:1px solid var(--edge)}
th{font-weight:600;color:var(--soft)}
td.n,th.n{text-align:right;white-space:nowrap}
.note{color:var(--soft);font-size:13px;margin:8px 0 0}
svg.chart{width:100%;height:auto;display:block}
.chart .grid{stroke:#e9edf2;stroke-width:1}.chart .axis{stroke:#9aa7b5;stroke-width:1}
.chart .upright{stroke:#b9c3cf;stroke-width:1;stroke-dasharray:2 3}
.chart text{font:12px system-ui,-apple-system,"Segoe UI",Roboto,sans-serif;fill:#5d6b7c}
.chart .label{fill:#1c2430}.chart .legend{fill:#1c2430}.chart .mark{font-size:10.5px}
.chart .name{fill:#1c2430;font-weight:600}
.chart .line{fill:none;stroke-width:1.7;stroke-linejoin:round}
.chart .dashed{stroke-dasharray:6 4;stroke-width:1.5}.chart .thin{stroke-width:1}
.chart .band{stroke-width:7;stroke-linecap:round}
.chart .rose{fill:#fff;stroke:#c4ccd6}.chart .wind{stroke:#b42318;fill:#b42318;stroke-width:2}
.chart .place{fill:#fff;stroke:#5d6b7c;stroke-width:1.5}
@media print{body{background:#fff}section,.card{break-inside:avoid}}
</style></head><body><main>
)";

std::string section(const std::string& title, const std::string& body, const std::string& note) {
    if (body.empty()) return "";
    return "<section><h2>" + escaped(title) + "</h2>\n" + body +
           (note.empty() ? "" : "<p class=\"note\">" + escaped(note) + "</p>") + "</section>\n";
}

std::string card(const char* name, const std::optional<double>& value, const char* format) {
    if (!value) return "";
    char text[64];
    std::snprintf(text, sizeof text, format, *value);
    return std::string("<div class=\"card\"><b>") + text + "</b><span>" + name + "</span></div>\n";
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
    return std::string(kHead) + "<header><h1>Flight report</h1><span class=\"verdict" +
           (summary.completed ? "" : " bad") + "\">" + escaped(verdict) + "</span></header>\n" +
           "<p class=\"sub\">" + escaped(summary.mission) + " · " + escaped(summary.firmware) +
           " on " + escaped(summary.board) + " · " + escaped(conditions(summary)) + "</p>\n" +
           cards(summary) + "<div class=\"map\">" +
           section("Ground track", charts.map(),
                   std::string("Dots: the places of the mission's NAV commands. ") +
                       (summary.from_log
                            ? "The flown line is where the airplane took itself to be."
                            : "The flown line is the truth, not the autopilot's estimate.")) +
           section("Summary", summaryTable(summary), "") + "</div>" +
           section("Altitude", charts.altitude(),
                   "Above the take-off point. Upright lines: the item flown from there on.") +
           section("Airspeed", charts.airspeed(), "Equivalent airspeed.") +
           section("Crosstrack", charts.crosstrack(),
                   "Distance from the straight leg, positive to the right.") +
           section("Roll against demand", charts.roll(), "") +
           section("Pitch against demand", charts.pitch(), "") +
           section("Control surfaces", charts.surfaces(), "") +
           section("Throttle and outputs 5 to 8", charts.otherServos(), "") +
           section("Processor load", charts.frames(),
                   "Time awake in the frames of every tenth of a second, interrupts and the "
                   "handling of received bytes included; a frame has 10,000 µs.") +
           section("Tasks", taskTable(summary), "Interrupts within a task are not counted to it.") +
           "<div class=\"pair\">" +
           section("Interrupts", interruptTable(summary.figures, summary.emulated_s), "") +
           section("Events", eventTable(summary), "") + "</div>" +
           section("Sensor errors of this flight", summary.from_log ? "" : errorTable(),
                   "Deviations are one sigma, drawn from the seed.") +
           "</main></body></html>\n";
}

}  // namespace simulator
