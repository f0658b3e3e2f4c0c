// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/report/chart.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace simulator {
namespace {

constexpr double kLeft = 64, kRight = 14, kTop = 34, kBottom = 44;
constexpr double kNearest_px = 0.6;  // points closer than this to the last one are left out

std::string number(double value, int decimals = 1) {
    char text[32];
    std::snprintf(text, sizeof text, "%.*f", decimals, value);
    return text;
}

std::string label(double value, double step) {
    const int decimals = std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9)));
    return number(value + 0.0, decimals);
}

struct Range {
    double from = INFINITY, to = -INFINITY;
    void add(double value) {
        if (!std::isfinite(value)) return;
        from = std::min(from, value);
        to = std::max(to, value);
    }
    void settle(double margin) {
        if (from > to) from = 0, to = 1;
        const double room = std::max((to - from) * margin, 1e-6);
        from -= room;
        to += room;
    }
    double span() const { return to - from; }
};

class Drawing {
public:
    explicit Drawing(const Chart& chart) : chart_(chart) {
        for (const Line& line : chart.lines) {
            for (const auto& [px, py] : line.points) {
                x_.add(px);
                y_.add(py);
            }
        }
        for (const Mark& place : chart.places) x_.add(place.x), y_.add(place.y);
        x_.settle(chart.map ? 0.06 : 0);
        y_.settle(0.06);
        if (chart.y_from) y_.from = *chart.y_from;
        if (chart.y_to) y_.to = *chart.y_to;
        if (chart.map) sameScale();
    }

    std::string draw() {
        open();
        grid();
        for (const Mark& mark : chart_.uprights) upright(mark);
        for (const Line& line : chart_.lines) path(line);
        for (const Mark& mark : chart_.places) dot(mark);
        if (chart_.wind) wind(*chart_.wind);
        legend();
        return svg_ + "</svg>\n";
    }

private:
    double inner() const { return chart_.width - kLeft - kRight; }
    double tall() const { return chart_.height - kTop - kBottom; }
    double px(double x) const { return kLeft + (x - x_.from) / x_.span() * inner(); }
    double py(double y) const { return kTop + (y_.to - y) / y_.span() * tall(); }

    void sameScale() {
        const double scale = std::max(x_.span() / inner(), y_.span() / tall());
        widen(x_, scale * inner());
        widen(y_, scale * tall());
    }
    static void widen(Range& range, double span) {
        const double middle = (range.from + range.to) / 2;
        range.from = middle - span / 2;
        range.to = middle + span / 2;
    }

    void open() {
        svg_ = "<svg class=\"chart\" viewBox=\"0 0 " + number(chart_.width, 0) + " " +
               number(chart_.height, 0) + "\" role=\"img\" aria-label=\"" +
               escaped(chart_.y_label + " over " + chart_.x_label) + "\">\n";
    }

    void text(double x, double y, const char* anchor, const char* kind, const std::string& words) {
        svg_ += "<text x=\"" + number(x) + "\" y=\"" + number(y) + "\" text-anchor=\"" + anchor +
                "\" class=\"" + kind + "\">" + escaped(words) + "</text>\n";
    }

    void segment(double x1, double y1, double x2, double y2, const char* kind) {
        svg_ += "<line x1=\"" + number(x1) + "\" y1=\"" + number(y1) + "\" x2=\"" + number(x2) +
                "\" y2=\"" + number(y2) + "\" class=\"" + kind + "\"/>\n";
    }

    void grid() {
        const double bottom = kTop + tall();
        const auto across = ticks(x_.from, x_.to, static_cast<int>(inner() / 90));
        const auto up = ticks(y_.from, y_.to, static_cast<int>(tall() / (chart_.map ? 90 : 26)));
        for (const double x : across) {
            segment(px(x), kTop, px(x), bottom, "grid");
            text(px(x), bottom + 16, "middle", "tick", label(x, step(across)));
        }
        for (const double y : up) {
            segment(kLeft, py(y), kLeft + inner(), py(y), "grid");
            text(kLeft - 7, py(y) + 4, "end", "tick", label(y, step(up)));
        }
        segment(kLeft, bottom, kLeft + inner(), bottom, "axis");
        segment(kLeft, kTop, kLeft, bottom, "axis");
        text(kLeft + inner() / 2, chart_.height - 8, "middle", "label", chart_.x_label);
        const double middle = kTop + tall() / 2;
        svg_ += "<text transform=\"translate(15 " + number(middle) +
                ") rotate(-90)\" text-anchor=\"middle\" class=\"label\">" +
                escaped(chart_.y_label) + "</text>\n";
    }
    static double step(const std::vector<double>& at) { return at.size() > 1 ? at[1] - at[0] : 1; }

    void upright(const Mark& mark) {
        segment(px(mark.x), kTop, px(mark.x), kTop + tall(), "upright");
        text(px(mark.x) + 3, kTop + 10, "start", "mark", mark.text);
    }

    void dot(const Mark& mark) {
        svg_ += "<circle cx=\"" + number(px(mark.x)) + "\" cy=\"" + number(py(mark.y)) +
                "\" r=\"4\" class=\"place\"/>\n";
        text(px(mark.x) + 7, py(mark.y) - 6, "start", "name", mark.text);
    }

    // A compass rose with the wind blowing through it.
    void wind(const Wind& wind) {
        constexpr double kRadius = 24;
        const double x = kLeft + inner() - 48, y = kTop + 50;
        const std::string at = "translate(" + number(x) + " " + number(y) + ")";
        svg_ += "<circle cx=\"" + number(x) + "\" cy=\"" + number(y) + "\" r=\"" + number(kRadius) +
                "\" class=\"rose\"/>\n";
        text(x, y - kRadius - 5, "middle", "name", "N");
        text(x, y + kRadius + 18, "middle", "label", wind.text);
        if (wind.calm) return;
        svg_ += "<path transform=\"" + at + " rotate(" + number(wind.from_deg) +
                ")\" d=\"M0 -20V12M-6 6L0 19L6 6Z\" class=\"wind\"/>\n";
    }

    void path(const Line& line) {
        std::string points;
        double last_x = -1e9, last_y = -1e9;
        bool pen_down = false;
        for (const auto& [x, y] : line.points) {
            if (!std::isfinite(y) || !std::isfinite(x)) {
                pen_down = false;
                continue;
            }
            const double at_x = px(x), at_y = std::clamp(py(y), kTop, kTop + tall());
            if (pen_down && std::hypot(at_x - last_x, at_y - last_y) < kNearest_px) continue;
            points += (pen_down ? "L" : "M") + number(at_x) + " " + number(at_y);
            pen_down = true;
            last_x = at_x;
            last_y = at_y;
        }
        if (points.empty()) return;
        svg_ += "<path d=\"" + points + "\" stroke=\"" + line.colour + "\" class=\"" +
                kind(line.stroke) + "\"/>\n";
    }
    static const char* kind(Stroke stroke) {
        static const char* const kKinds[] = {"line", "line dashed", "line thin", "line band"};
        return kKinds[static_cast<size_t>(stroke)];
    }

    void legend() {
        double x = kLeft;
        for (const Line& line : chart_.lines) {
            if (line.name.empty()) continue;
            svg_ += "<path d=\"M" + number(x) + " 16h22\" stroke=\"" + line.colour + "\" class=\"" +
                    kind(line.stroke) + "\"/>\n";
            text(x + 29, 20, "start", "legend", line.name);
            x += 46 + 6.6 * static_cast<double>(line.name.size());
        }
    }

    const Chart& chart_;
    Range x_, y_;
    std::string svg_;
};

}  // namespace

std::vector<double> ticks(double from, double to, int count) {
    const double rough = (to - from) / std::max(count, 1);
    const double power = std::pow(10, std::floor(std::log10(rough)));
    double step = power * 10;
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * power >= rough * (1 - 1e-9)) {
            step = factor * power;
            break;
        }
    }
    std::vector<double> at;
    const auto last = static_cast<long>(std::floor(to / step + 1e-9));
    for (auto i = static_cast<long>(std::ceil(from / step - 1e-9)); i <= last; ++i) {
        at.push_back(static_cast<double>(i) * step);
    }
    return at;
}

std::string escaped(const std::string& text) {
    std::string safe;
    for (const char c : text) {
        switch (c) {
            case '&':
                safe += "&amp;";
                break;
            case '<':
                safe += "&lt;";
                break;
            case '>':
                safe += "&gt;";
                break;
            case '"':
                safe += "&quot;";
                break;
            default:
                safe += c;
        }
    }
    return safe;
}

std::string drawChart(const Chart& chart) { return Drawing(chart).draw(); }

}  // namespace simulator
