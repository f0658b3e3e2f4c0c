// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/report/html.hpp"

#include <cstdio>

#include "simulator/report/chart.hpp"

namespace simulator {
namespace {

constexpr char kStyle[] = R"(<style>
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
</style>)";

}  // namespace

std::string htmlHead(const std::string& title) {
    return "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
           "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
           escaped(title) + "</title>\n" + kStyle + "</head><body><main>\n";
}

std::string htmlSection(const std::string& title, const std::string& body,
                        const std::string& note) {
    if (body.empty()) return "";
    return "<section><h2>" + escaped(title) + "</h2>\n" + body +
           (note.empty() ? "" : "<p class=\"note\">" + escaped(note) + "</p>") + "</section>\n";
}

std::string htmlCard(const std::string& name, const std::string& value) {
    return "<div class=\"card\"><b>" + escaped(value) + "</b><span>" + escaped(name) +
           "</span></div>\n";
}

Table::Table(const std::vector<std::string>& heads) {
    text_ = "<div class=\"wide\"><table><thead><tr>";
    for (const auto& head : heads) cell("th", head, &head != &heads.front());
    text_ += "</tr></thead><tbody>\n";
}

void Table::row(const std::vector<std::string>& cells) {
    text_ += "<tr>";
    for (const auto& words : cells) cell("td", words, &words != &cells.front());
    text_ += "</tr>\n";
}

void Table::cell(const std::string& tag, const std::string& words, bool number) {
    text_ += "<" + tag + (number ? " class=\"n\">" : ">") + escaped(words) + "</" + tag + ">";
}

std::string fixed(double value, int decimals) {
    char text[40];
    std::snprintf(text, sizeof text, "%.*f", decimals, value);
    return text;
}

}  // namespace simulator
