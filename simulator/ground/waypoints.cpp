// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/ground/waypoints.hpp"

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace simulator {
namespace {

constexpr char kHeader[] = "QGC WPL 110";
constexpr char kSpace[] = " \t\r";

// One line, read column by column; knows where it stands for the sake of the message.
class Row {
public:
    Row(const std::string& text, const std::string& name, int line)
        : text_(text), name_(name), line_(line) {}

    bool blank() const {
        const size_t first = text_.find_first_not_of(kSpace);
        return first == std::string::npos || text_[first] == '#';
    }

    double number(const char* what, double lowest, double highest) {
        const size_t begin = text_.find_first_not_of(kSpace, at_);
        at_ = begin == std::string::npos ? text_.size() : begin;
        columns_.at(numbers_) = static_cast<int>(at_) + 1;
        const size_t end = std::min(text_.find_first_of(kSpace, at_), text_.size());
        const std::string word = text_.substr(at_, end - at_);
        char* rest = nullptr;
        const double value = std::strtod(word.c_str(), &rest);
        if (word.empty() || *rest != 0) fail(what, word);
        if (!(std::isnan(value) ? std::isinf(highest) : value >= lowest && value <= highest)) {
            fail(what, word);
        }
        at_ = end;
        ++numbers_;
        return value;
    }

    int whole(const char* what, int lowest, int highest) {
        const size_t begin = at_;
        const double value = number(what, lowest, highest);
        if (value != std::floor(value)) {
            at_ = std::min(text_.find_first_not_of(kSpace, begin), text_.size());
            fail(what, text_.substr(at_, text_.find_first_of(kSpace, at_) - at_));
        }
        return static_cast<int>(value);
    }

    void end() {
        at_ = text_.find_first_not_of(kSpace, at_);
        if (at_ != std::string::npos) fail("the end of the line", text_.substr(at_));
    }

    int line() const { return line_; }
    const std::array<int, 12>& columns() const { return columns_; }

    [[noreturn]] void fail(const std::string& expected, const std::string& found) const {
        std::ostringstream message;
        message << name_ << ':' << line_ << ':' << at_ + 1 << ": expected " << expected
                << ", found " << (found.empty() ? "the end of the line" : "'" + found + "'");
        throw WaypointError(message.str());
    }

private:
    const std::string& text_;
    const std::string& name_;
    int line_;
    size_t at_ = 0;
    size_t numbers_ = 0;
    std::array<int, 12> columns_{};
};

WaypointItem parseRow(Row& row, int index) {
    const double any = INFINITY;
    WaypointItem item;
    item.index = row.whole(("index " + std::to_string(index)).c_str(), index, index);
    item.current = row.whole("current: 0 or 1", 0, 1) != 0;
    item.frame = static_cast<uint8_t>(row.whole("a frame number, 0 to 255", 0, 255));
    item.command = static_cast<uint16_t>(row.whole("a command number, 1 to 65535", 1, 65535));
    for (double& param : item.params) param = row.number("a number as parameter", -any, any);
    item.latitude_deg = row.number("a latitude, -90 to 90 degrees", -90, 90);
    item.longitude_deg = row.number("a longitude, -180 to 180 degrees", -180, 180);
    item.altitude_m = row.number("an altitude in metres", -100'000, 100'000);
    item.autocontinue = row.whole("autocontinue: 0 or 1", 0, 1) != 0;
    row.end();
    item.line = row.line();
    item.columns = row.columns();
    return item;
}

}  // namespace

Waypoints parseWaypoints(const std::string& text, const std::string& name) {
    std::istringstream lines(text);
    std::string line;
    int number = 1;
    std::getline(lines, line);
    line.erase(line.find_last_not_of(kSpace) + 1);
    if (line != kHeader) Row(line, name, 1).fail("'QGC WPL 110'", line);
    Waypoints items;
    while (std::getline(lines, line)) {
        Row row(line, name, ++number);
        if (!row.blank()) items.push_back(parseRow(row, static_cast<int>(items.size())));
    }
    if (items.size() < 2) {
        Row(line, name, number + 1).fail("home and at least one mission item", "");
    }
    return items;
}

Waypoints readWaypoints(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::stringstream text;
    if (!file || !(text << file.rdbuf())) throw WaypointError(path + ": cannot be read");
    return parseWaypoints(text.str(), path);
}

}  // namespace simulator
