// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/ground/points_file.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <utility>

#include "simulator/ground/text_file.hpp"
#include "simulator/input_file.hpp"

namespace simulator {
namespace {

constexpr char kRallyWord[] = "RALLY";
constexpr char kPolygonMark[] = "#saved by Mission Planner";
constexpr double kFarAltitude_m = 100'000;

std::vector<std::string> wordsOf(const std::string& line) {
    std::istringstream from(line);
    std::vector<std::string> words;
    for (std::string word; from >> word;) words.push_back(word);
    return words;
}

bool isNumber(const std::string& word) {
    char* rest = nullptr;
    const double value = std::strtod(word.c_str(), &rest);
    return !word.empty() && *rest == 0 && std::isfinite(value);
}

class PointsReader {
public:
    PointsReader(const std::string& text, const std::string& name) : name_(name) {
        only_corners_ = text.compare(0, sizeof kPolygonMark - 1, kPolygonMark) == 0;
        std::istringstream lines(text);
        for (std::string line; std::getline(lines, line);) {
            ++line_;
            words_ = wordsOf(line);
            if (words_.empty() || words_[0][0] == '#') continue;
            if (words_[0] == kRallyWord)
                rally();
            else
                corner();
        }
        close();
    }
    MissionFile take() { return std::move(file_); }

private:
    void fail(const std::string& wanted, const std::string& found) {
        file_.errors.push_back({line_, 1,
                                name_ + ':' + std::to_string(line_) + ":1: expected " + wanted +
                                    ", found '" + printable(found) + '\''});
    }
    double number(size_t at, const char* what, double limit) {
        const std::string word = at < words_.size() ? words_[at] : "";
        const double value = isNumber(word) ? std::strtod(word.c_str(), nullptr) : INFINITY;
        if (std::abs(value) <= limit) return value;
        fail(what, word);
        return 0;
    }
    Place place(size_t at) {
        const double latitude_deg = number(at, "a latitude, -90 to 90 degrees", 90);
        return {latitude_deg, number(at + 1, "a longitude, -180 to 180 degrees", 180)};
    }

    // Break altitude, direction and flags follow; nothing here makes use of them.
    void rally() {
        const Place at = place(1);
        file_.rally.push_back({at, number(3, "an altitude in metres", kFarAltitude_m)});
    }
    void corner() {
        constexpr size_t kTwo = 2;
        if (words_.size() != kTwo) return fail("a latitude and a longitude", words_[0]);
        points_.push_back(place(0));
    }

    // The first corner stands at the end again.
    void close() {
        if (points_.empty()) return;
        if (!only_corners_) {
            file_.fence.way_back = points_.front();
            points_.erase(points_.begin());
        }
        const auto same = [](const Place& a, const Place& b) {
            return a.latitude_deg == b.latitude_deg && a.longitude_deg == b.longitude_deg;
        };
        if (points_.size() > 1 && same(points_.front(), points_.back())) points_.pop_back();
        constexpr size_t kLeast = 3;
        if (points_.size() < kLeast)
            return fail("at least three corners of a fence", std::to_string(points_.size()));
        file_.fence.areas.push_back({true, points_, 0});
    }

    const std::string& name_;
    int line_ = 0;
    bool only_corners_ = false;
    std::vector<std::string> words_;
    std::vector<Place> points_;
    MissionFile file_;
};

// Of items of the mission protocol. A corner says how many there are of its polygon.
void takeItems(MissionFile& file) {
    size_t missing = 0;
    for (const WaypointItem& item : file.items) {
        const Place place = {item.latitude_deg, item.longitude_deg};
        const bool polygon = item.command == kPolygonInside || item.command == kPolygonOutside;
        const bool circle = item.command == kCircleInside || item.command == kCircleOutside;
        const bool inside = item.command == kPolygonInside || item.command == kCircleInside;
        if (polygon && missing == 0) {
            file.fence.areas.push_back({inside, {}, 0});
            missing = item.params[0] >= 1 ? static_cast<size_t>(item.params[0]) : 1;
        }
        if (polygon) {
            file.fence.areas.back().rim.push_back(place);
            --missing;
        }
        if (circle) file.fence.areas.push_back({inside, {place}, item.params[0]});
        if (item.command == mavlink::MavCmd::nav_fence_return_point) file.fence.way_back = place;
        if (item.command == mavlink::MavCmd::nav_rally_point)
            file.rally.push_back({place, item.altitude_m});
    }
}

std::string degrees(double value) {
    char text[24];
    std::snprintf(text, sizeof text, "%.7f", value);
    return text;
}
std::string line(const Place& place, const char* between) {
    return degrees(place.latitude_deg) + between + degrees(place.longitude_deg);
}

}  // namespace

bool looksLikePoints(const std::string& text) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        const std::vector<std::string> words = wordsOf(line);
        if (words.empty() || words[0][0] == '#') continue;
        return words[0] == kRallyWord ||
               (words.size() == 2 && isNumber(words[0]) && isNumber(words[1]));
    }
    return false;
}

MissionFile parsePoints(const std::string& bytes, const std::string& name) {
    const std::string text = decodedText(bytes);
    MissionFile file;
    if (whyNoText(bytes).empty() && looksLikePoints(text)) {
        file = PointsReader(text, name).take();
    } else {
        file = readMissionLines(bytes, name);
        takeItems(file);
    }
    throwErrors(file);
    return file;
}

MissionFile readPointsFile(const std::string& path) {
    const auto bytes = wholeFile(path);
    if (!bytes) throw WaypointError(path + ": cannot be read");
    return parsePoints(*bytes, path);
}

std::string fenceAsPoints(const Fence& fence) {
    const bool simple = fence.areas.size() == 1 && fence.areas[0].inclusion &&
                        !fence.areas[0].isCircle() && fence.way_back;
    if (!simple) return "";
    std::string text = "#saved by APM Planner\n" + line(*fence.way_back, " ") + '\n';
    for (const Place& corner : fence.areas[0].rim) text += line(corner, " ") + '\n';
    return text + line(fence.areas[0].rim[0], " ") + '\n';
}

std::string rallyAsPoints(const std::vector<RallyPlace>& rally) {
    if (rally.empty()) return "";
    std::string text = "#saved by Mission Planner\n";
    for (const RallyPlace& each : rally)
        text += std::string(kRallyWord) + '\t' + line(each.place, "\t") + '\t' +
                std::to_string(std::lround(each.height_m)) + "\t0\t0\t0\n";
    return text;
}

}  // namespace simulator
