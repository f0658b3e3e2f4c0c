// SPDX-License-Identifier: GPL-3.0-or-later
// Line charts and a map as inline SVG: no script, no font, nothing from elsewhere.
#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace simulator {

using Points = std::vector<std::pair<double, double>>;  // a NaN y breaks the line

enum class Stroke { solid, dashed, thin, band };

struct Line {
    std::string name;  // in the legend; empty: not there
    std::string colour;
    Stroke stroke;
    Points points;
};

struct Mark {
    double x, y;  // y is ignored by upright marks
    std::string text;
};

struct Wind {
    double from_deg;
    std::string text;
    bool calm;
};

struct Chart {
    std::string x_label, y_label;
    std::vector<Line> lines;
    std::vector<Mark> uprights;          // thin vertical lines named at the top
    std::vector<Mark> places;            // named dots
    std::optional<double> y_from, y_to;  // else from the lines, with a margin
    double width = 960, height = 260;
    bool map = false;          // same scale both ways
    std::optional<Wind> wind;  // as an arrow in the corner
};

std::string drawChart(const Chart& chart);

// Round steps that part `from`..`to` into about `count`.
std::vector<double> ticks(double from, double to, int count);

std::string escaped(const std::string& text);  // for HTML and SVG

}  // namespace simulator
