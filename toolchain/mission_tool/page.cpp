// SPDX-License-Identifier: GPL-3.0-or-later
#include "toolchain/mission_tool/page.hpp"

#include <algorithm>
#include <filesystem>

#include "toolchain/mission_tool/columns.hpp"
#include "toolchain/mission_tool/drawing.hpp"
#include "toolchain/mission_tool/flight_table.hpp"

namespace mission_tool {
namespace {

constexpr size_t kMaxRows = 200;

constexpr char kStyle[] = R"(<style>
:root{color-scheme:light dark;--ink:#1c2430;--soft:#5d6b7c;--edge:#d8dee6;--paper:#fff;--ground:#f5f7f9;
--way:#1f6feb;--fence:#b42318;--rally:#8250df;--home:#18794e;--warn:#9a6700;--grid:#e6eaef}
@media(prefers-color-scheme:dark){:root{--ink:#e6edf3;--soft:#9aa7b5;--edge:#30363d;--paper:#161b22;
--ground:#0d1117;--way:#58a6ff;--fence:#ff7b72;--rally:#d2a8ff;--home:#56d364;--warn:#e3b341;--grid:#242b33}}
*{box-sizing:border-box}
body{margin:0;background:var(--ground);color:var(--ink);font:15px/1.45 system-ui,-apple-system,"Segoe UI",Roboto,sans-serif}
main{max-width:720px;margin:0 auto;padding:14px 10px 40px}
h1{font-size:21px;margin:4px 0;overflow-wrap:anywhere}h2{font-size:16px;margin:0 0 8px}
p{margin:0 0 12px;color:var(--soft)}
section{background:var(--paper);border:1px solid var(--edge);border-radius:10px;padding:10px;margin-bottom:12px}
.cards{display:grid;grid-template-columns:repeat(auto-fit,minmax(104px,1fr));gap:8px;margin-bottom:12px}
.cards div{background:var(--paper);border:1px solid var(--edge);border-radius:10px;padding:8px 10px}
.cards b{display:block;font-size:18px}.cards span{color:var(--soft);font-size:13px}
svg{display:block;width:100%;height:auto}
svg text{font:11px system-ui,-apple-system,"Segoe UI",Roboto,sans-serif;fill:var(--soft)}
svg .name{fill:var(--ink);font-weight:600}
.grid{stroke:var(--grid);fill:none}.axis{stroke:var(--soft);fill:none}
.way{stroke:var(--way);fill:none;stroke-width:1.8;stroke-linejoin:round}
.about{stroke:var(--way);fill:none;stroke-width:1.4;stroke-dasharray:3 4}
.place{fill:var(--paper);stroke:var(--way);stroke-width:1.6}
.fence{stroke:var(--fence);fill:none;stroke-width:1.4;stroke-dasharray:7 4}
.out{stroke:var(--fence);fill:var(--fence);fill-opacity:.18;stroke-width:1.4}
.limit{stroke:var(--fence);stroke-dasharray:7 4}.rtl{stroke:var(--home);stroke-dasharray:2 4}
.home{fill:var(--home)}.rally{fill:var(--rally)}
.wide{overflow-x:auto}table{border-collapse:collapse;width:100%;font-size:13px;font-variant-numeric:tabular-nums}
th,td{text-align:right;padding:3px 8px 3px 0;border-bottom:1px solid var(--edge);white-space:nowrap}
th{color:var(--soft);font-weight:600}.l{text-align:left}.words{white-space:normal;min-width:130px}
ul{margin:0;padding-left:18px}li{margin:3px 0;overflow-wrap:anywhere}.error{color:var(--fence)}.warning{color:var(--warn)}
</style>)";

std::string card(const std::string& name, const std::string& value) {
    return "<div><b>" + escaped(value) + "</b><span>" + escaped(name) + "</span></div>\n";
}

std::string cards(const PageOf& page) {
    const Estimate& flight = page.flight;
    const double share =
        flight.capacity_mah > 0 ? 100 * flight.used_mah / flight.capacity_mah : 0;
    return "<div class=\"cards\">\n" + card("way", format("%.2f km", flight.length_m / 1000)) +
           card("time", minutesAndSeconds(flight.time_s) + " min") +
           card("of the battery", format("%.0f %%", share)) +
           card("highest", format("%.0f m", flight.highest_m)) +
           card("farthest", format("%.0f m", flight.farthest_m)) + "</div>\n";
}

std::string cell(const char* tag, const std::string& text, const char* of = "") {
    return std::string("<") + tag + (*of != 0 ? std::string(" class=\"") + of + '"' : "") + '>' +
           escaped(text) + "</" + tag + '>';
}

std::string rows(const PageOf& page) {
    std::string text;
    size_t next = 0;
    for (size_t i = 0; i < std::min(page.order.visits.size(), kMaxRows); ++i) {
        const Visit& visit = page.order.visits[i];
        if (visit.nav == 0 || next >= page.flight.stretches.size()) continue;
        const Stretch& s = page.flight.stretches[next++];
        text += "<tr>" + cell("td", std::to_string(visit.nav), "l") +
                cell("td", nameOf(page.document.entries[visit.nav]), "l") +
                cell("td", s.ground_mps > 0 ? format("%.0f", s.length_m) : "never") +
                cell("td", format("%.0f", s.height_m)) +
                cell("td", format("%+.1f", s.needed_climb_mps)) +
                cell("td", minutesAndSeconds(s.time_s)) +
                cell("td", format("%.0f", s.used_mah)) +
                cell("td", besideOf(page.document, visit), "l words") + "</tr>\n";
    }
    if (page.order.visits.size() > kMaxRows)
        text += "<tr><td class=\"l\" colspan=\"8\">and " +
                std::to_string(page.order.visits.size() - kMaxRows) + " more</td></tr>\n";
    return text;
}

std::string table(const PageOf& page) {
    std::string head;
    for (const char* left : {"", "NAV"}) head += cell("th", left, "l");
    for (const char* each : {"way, m", "height, m", "climb, m/s", "time", "mAh"})
        head += cell("th", each);
    return "<section><h2>In the order of the flight</h2><div class=\"wide\"><table><thead><tr>" +
           head + cell("th", "beside it", "l") + "</tr></thead><tbody>\n" + rows(page) +
           "</tbody></table></div></section>\n";
}

std::string findingsOf(const PageOf& page) {
    constexpr size_t kMaxShown = 50;
    if (page.findings.empty()) return "";
    std::string text = "<section><h2>Findings</h2><ul>\n";
    for (size_t i = 0; i < std::min(page.findings.size(), kMaxShown); ++i) {
        const Finding& each = page.findings[i];
        text += std::string("<li class=\"") + (each.error ? "error" : "warning") + "\">" +
                (each.error ? "error: " : "") + "item " + std::to_string(each.index) + ": " +
                escaped(each.text) + "</li>\n";
    }
    if (page.findings.size() > kMaxShown)
        text += "<li>and " + std::to_string(page.findings.size() - kMaxShown) + " more</li>\n";
    return text + "</ul></section>\n";
}

}  // namespace

std::string pageOf(const PageOf& page) {
    const std::string name =
        escaped(std::filesystem::path(page.document.name).filename().string());
    return "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
           "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
           name + "</title>\n" + kStyle + "</head><body><main>\n<h1>" + name + "</h1>\n<p>" +
           escaped(page.airplane + ", " + windInWords(page.wind) + ", estimated; " +
                   std::to_string(page.document.entries.size()) + " items, " + endOf(page.order)) +
           "</p>\n" + cards(page) + "<section><h2>Map</h2>\n" +
           mapOf(page.document, page.flight) + "</section>\n<section><h2>Height above home</h2>\n" +
           profileOf(page.flight) + "</section>\n" + findingsOf(page) + table(page) +
           "</main></body></html>\n";
}

}  // namespace mission_tool
