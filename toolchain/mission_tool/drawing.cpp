// SPDX-License-Identifier: GPL-3.0-or-later
#include "toolchain/mission_tool/drawing.hpp"

#include <algorithm>
#include <cmath>

#include "firmware/state/parameters.hpp"
#include "toolchain/mission_tool/columns.hpp"

namespace mission_tool {
namespace {

using firmware::state::parameters;
using simulator::Point;

constexpr double kWidth = 390;
constexpr size_t kMaxDrawn = 1000;
constexpr double kLetter = 7.4, kLine = 12;  // of the page's small bold type

std::string number(double value) { return format("%.1f", value); }

std::string open(double height) {
    return "<svg viewBox=\"0 0 " + number(kWidth) + ' ' + number(height) + "\" role=\"img\">\n";
}
std::string line(const char* of, double x1, double y1, double x2, double y2) {
    return std::string("<line class=\"") + of + "\" x1=\"" + number(x1) + "\" y1=\"" + number(y1) +
           "\" x2=\"" + number(x2) + "\" y2=\"" + number(y2) + "\"/>\n";
}
std::string text(double x, double y, const std::string& words, const char* anchor = "start",
                 const char* of = "") {
    return std::string("<text class=\"") + of + "\" x=\"" + number(x) + "\" y=\"" + number(y) +
           "\" text-anchor=\"" + anchor + "\">" + escaped(words) + "</text>\n";
}
std::string dot(const char* of, double x, double y, double radius, const std::string& title = "") {
    return std::string("<circle class=\"") + of + "\" cx=\"" + number(x) + "\" cy=\"" + number(y) +
           "\" r=\"" + number(radius) + "\">" +
           (title.empty() ? "" : "<title>" + escaped(title) + "</title>") + "</circle>\n";
}

// Names that do not lie on one another; what finds no room is left out, its dot has a title.
class Names {
public:
    std::string add(double x, double y, const std::string& words) {
        const double width = kLetter * static_cast<double>(words.size());
        for (const auto& [dx, dy] : {std::pair{6.0, -5.0}, {6.0, 14.0}, {-6.0 - width, -5.0},
                                     {-6.0 - width, 14.0}}) {
            const Box box = {x + dx, y + dy - kLine + 2, x + dx + width, y + dy + 2};
            const bool inside = box.left >= 0 && box.right <= kWidth && box.top >= 0;
            if (!inside || std::any_of(taken_.begin(), taken_.end(),
                                       [&](const Box& other) { return box.meets(other); }))
                continue;
            taken_.push_back(box);
            return text(box.left, y + dy, words, "start", "name");
        }
        return "";
    }

private:
    struct Box {
        double left, top, right, bottom;
        bool meets(const Box& other) const {
            return left < other.right && other.left < right && top < other.bottom &&
                   other.top < bottom;
        }
    };
    std::vector<Box> taken_;
};

class Map {
public:
    Map(const Document& document, const Estimate& flight)
        : document_(document),
          flight_(flight),
          frame_(document.entries[0].record.p3 * 1e-7, document.entries[0].record.p4 * 1e-7) {
        include({0, 0}, 0);
        for (const Stretch& s : drawn()) {
            include(s.from, 0);
            include(s.to, s.circle_m);
        }
        for (const auto& area : document.fence.areas)
            for (const auto& place : area.rim) include(at(place), area.radius_m);
        for (const auto& each : document.rally) include(at(each.place), 0);
        constexpr double kSmallest_m = 100, kMargin = 1.12;
        const double north_m = std::max(kSmallest_m, highest_.north_m - lowest_.north_m);
        const double east_m = std::max(kSmallest_m, highest_.east_m - lowest_.east_m);
        scale_ = kWidth / (east_m * kMargin);
        height_ = std::clamp(north_m * kMargin * scale_, 200.0, 480.0);
        scale_ = std::min(scale_, height_ / (north_m * kMargin));
        middle_ = {(lowest_.north_m + highest_.north_m) / 2,
                   (lowest_.east_m + highest_.east_m) / 2};
    }

    std::string drawing() {
        return open(height_) + grid() + fence() + ways() + places() + "</svg>\n";
    }

private:
    std::vector<Stretch> drawn() const {
        const auto& all = flight_.stretches;
        return {all.begin(), all.begin() + static_cast<long>(std::min(all.size(), kMaxDrawn))};
    }
    Point at(const simulator::Place& place) const {
        return frame_.at(place.latitude_deg, place.longitude_deg);
    }
    void include(const Point& place, double around_m) {
        lowest_ = {std::min(lowest_.north_m, place.north_m - around_m),
                   std::min(lowest_.east_m, place.east_m - around_m)};
        highest_ = {std::max(highest_.north_m, place.north_m + around_m),
                    std::max(highest_.east_m, place.east_m + around_m)};
    }
    double x(double east_m) const { return kWidth / 2 + (east_m - middle_.east_m) * scale_; }
    double y(double north_m) const { return height_ / 2 - (north_m - middle_.north_m) * scale_; }
    std::string lineOf(const char* of, const Point& a, const Point& b) const {
        return line(of, x(a.east_m), y(a.north_m), x(b.east_m), y(b.north_m));
    }
    std::string circleOf(const char* of, const Point& centre, double radius_m) const {
        return dot(of, x(centre.east_m), y(centre.north_m), radius_m * scale_);
    }

    std::string grid() const {
        const double step_m = gridStep(kWidth / scale_, 5);
        std::string all;
        const double west_m = middle_.east_m - kWidth / 2 / scale_;
        const double south_m = middle_.north_m - height_ / 2 / scale_;
        for (double e = std::ceil(west_m / step_m) * step_m; x(e) < kWidth; e += step_m)
            all += line("grid", x(e), 0, x(e), height_);
        for (double n = std::ceil(south_m / step_m) * step_m; y(n) > 0; n += step_m)
            all += line("grid", 0, y(n), kWidth, y(n));
        all += line("axis", 8, height_ - 8, 8 + step_m * scale_, height_ - 8);
        const bool far = step_m >= 1000;
        all += text(8, height_ - 13, far ? format("%g km", step_m / 1000) : format("%g m", step_m));
        return all + text(kWidth - 8, 14, "N", "end", "name") +
               line("axis", kWidth - 12, 34, kWidth - 12, 19) +
               line("axis", kWidth - 15, 23, kWidth - 12, 19) +
               line("axis", kWidth - 9, 23, kWidth - 12, 19);
    }

    std::string fence() const {
        std::string all;
        for (const auto& area : document_.fence.areas) {
            const char* of = area.inclusion ? "fence" : "out";
            if (area.isCircle()) {
                all += circleOf(of, at(area.rim[0]), area.radius_m);
                continue;
            }
            all += std::string("<polygon class=\"") + of + "\" points=\"";
            for (const auto& place : area.rim)
                all += number(x(at(place).east_m)) + ',' + number(y(at(place).north_m)) + ' ';
            all += "\"/>\n";
        }
        return all;
    }

    std::string ways() const {
        std::string all;
        for (const Stretch& s : drawn()) {
            all += lineOf(s.placed ? "way" : "about", s.from, s.to);
            if (s.circle_m > 0) all += circleOf("way", s.to, s.circle_m);
        }
        return all;
    }

    std::string places() const {
        constexpr double kSize = 3.5;
        std::string all;
        Names names;
        all += dot("home", x(0), y(0), 5, "home") + names.add(x(0), y(0), "home");
        std::vector<size_t> done;
        for (const Stretch& s : drawn()) {
            if (!s.placed || std::find(done.begin(), done.end(), s.nav) != done.end()) continue;
            done.push_back(s.nav);
            const std::string name = std::to_string(s.nav);
            const double at_x = x(s.to.east_m), at_y = y(s.to.north_m);
            all += dot("place", at_x, at_y, kSize,
                       name + ' ' + nameOf(document_.entries[s.nav]) +
                           format(", %.0f m", s.height_m)) +
                   names.add(at_x, at_y, name);
        }
        for (size_t i = 0; i < document_.rally.size(); ++i) {
            const Point place = at(document_.rally[i].place);
            const std::string name = "R" + std::to_string(i + 1);
            all += dot("rally", x(place.east_m), y(place.north_m), 4, "rally point " + name) +
                   names.add(x(place.east_m), y(place.north_m), name);
        }
        return all;
    }

    const Document& document_;
    const Estimate& flight_;
    const simulator::LocalFrame frame_;
    Point lowest_, highest_, middle_;
    double scale_ = 1, height_ = kWidth;
};

class Profile {
public:
    explicit Profile(const Estimate& flight) : flight_(flight) {
        length_m_ = std::max(1.0, flight.length_m);
        for (const Stretch& s : flight.stretches) {
            highest_m_ = std::max({highest_m_, s.height_m, s.wanted_height_m});
            lowest_m_ = std::min({lowest_m_, s.height_m, s.wanted_height_m});
        }
        for (const double limit_m : {fenceLimit_m(), rtl_m()})
            if (limit_m < 3 * highest_m_) highest_m_ = std::max(highest_m_, limit_m);
        highest_m_ += 0.12 * (highest_m_ - lowest_m_);
    }

    std::string drawing() const {
        return open(kHeight) + grid() + limit("limit", fenceLimit_m(), "FENCE_MAXALT") +
               limit("rtl", rtl_m(), "RTL") + way() + "</svg>\n";
    }

private:
    static constexpr double kHeight = 190, kLeft = 34, kBottom = 20, kTop = 8, kRight = 8;

    static double fenceLimit_m() {
        return parameters.fence_max_m > parameters.fence_min_m ? parameters.fence_max_m : -1;
    }
    static double rtl_m() { return parameters.rtl_height_cm * 0.01; }

    double x(double along_m) const {
        return kLeft + along_m / length_m_ * (kWidth - kLeft - kRight);
    }
    double y(double height_m) const {
        return kHeight - kBottom -
               (height_m - lowest_m_) / (highest_m_ - lowest_m_) * (kHeight - kBottom - kTop);
    }

    std::string grid() const {
        std::string all;
        const double up_m = gridStep(highest_m_ - lowest_m_, 5), on_m = gridStep(length_m_, 5);
        for (double h = std::ceil(lowest_m_ / up_m) * up_m; h <= highest_m_; h += up_m)
            all += line("grid", kLeft, y(h), kWidth - kRight, y(h)) +
                   text(kLeft - 4, y(h) + 4, format("%g", h), "end");
        for (double d = 0; d <= length_m_; d += on_m)
            all += line("grid", x(d), kTop, x(d), kHeight - kBottom) +
                   text(x(d), kHeight - 6,
                        length_m_ >= 2000 ? format("%g km", d / 1000) : format("%g m", d),
                        d == 0 ? "start" : "middle");
        return all;
    }

    std::string limit(const char* of, double height_m, const char* name) const {
        if (height_m <= 0 || height_m > highest_m_) return "";
        return line(of, kLeft, y(height_m), kWidth - kRight, y(height_m)) +
               text(kWidth - kRight, y(height_m) - 3, name, "end");
    }

    std::string way() const {
        std::string points, dots;
        Names names;
        double along_m = 0;
        for (size_t i = 0; i < std::min(flight_.stretches.size(), kMaxDrawn); ++i) {
            const Stretch& s = flight_.stretches[i];
            points += number(x(along_m)) + ',' + number(y(s.from_height_m)) + ' ';
            along_m += s.length_m;
            const double at_x = x(along_m), at_y = y(s.height_m);
            points += number(at_x) + ',' + number(at_y) + ' ';
            dots += dot("place", at_x, at_y, 3, format("%zu, %.0f m", s.nav, s.height_m)) +
                    names.add(at_x, at_y, std::to_string(s.nav));
        }
        return "<polyline class=\"way\" points=\"" + points + "\"/>\n" + dots;
    }

    const Estimate& flight_;
    double length_m_, highest_m_ = 10, lowest_m_ = 0;
};

}  // namespace

double gridStep(double range, int count) {
    if (!(range > 0) || count < 1) return 1;
    const double least = range / count;
    const double power = std::pow(10, std::floor(std::log10(least)));
    for (const double times : {1.0, 2.0, 5.0})
        if (times * power >= least * (1 - 1e-9)) return times * power;
    return 10 * power;
}

std::string escaped(const std::string& words) {
    std::string safe;
    for (const char c : words) {
        if (c == '<') safe += "&lt;";
        else if (c == '>') safe += "&gt;";
        else if (c == '&') safe += "&amp;";
        else if (c == '"') safe += "&quot;";
        else safe += c;
    }
    return safe;
}

std::string mapOf(const Document& document, const Estimate& flight) {
    return Map(document, flight).drawing();
}

std::string profileOf(const Estimate& flight) { return Profile(flight).drawing(); }

}  // namespace mission_tool
