// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/ground/waypoints.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

#include "simulator/ground/mission_file.hpp"
#include "simulator/ground/text_file.hpp"

namespace simulator {
namespace {

constexpr char kHeader[] = "QGC WPL 110";
constexpr char kSpace[] = " \t\r";

// One line, read column by column; knows where it stands for the sake of the message.
class Row {
public:
    Row(const std::string& text, const std::string& name, int line, std::vector<LineError>& errors)
        : text_(text), name_(name), line_(line), errors_(errors), errors_before_(errors.size()) {}

    bool blank() const {
        const size_t first = text_.find_first_not_of(kSpace);
        return first == std::string::npos || text_[first] == '#';
    }

    // 0 when it is wrong, which is noted; the columns behind it are read all the same.
    double number(const std::string& what, double lowest, double highest) {
        const std::string word = next();
        if (ended_) return 0;
        char* rest = nullptr;
        const double value = std::strtod(word.c_str(), &rest);
        const bool any = std::isinf(highest);
        const bool fits = std::isnan(value) ? any : value >= lowest && value <= highest;
        if (!word.empty() && *rest == 0 && fits) return value;
        fail(what, word);
        ended_ = word.empty();
        return 0;
    }

    int whole(const std::string& what, int lowest, int highest) {
        const double value = number(what, lowest, highest);
        if (value != std::floor(value)) fail(what, text_.substr(at_, end_ - at_));
        return static_cast<int>(value);
    }

    void end() {
        at_ = std::min(text_.find_first_not_of(kSpace, end_), text_.size());
        if (!ended_ && at_ < text_.size()) fail("the end of the line", text_.substr(at_));
    }

    bool good() const { return errors_.size() == errors_before_; }
    int line() const { return line_; }
    const std::array<int, 12>& columns() const { return columns_; }

    void fail(const std::string& expected, const std::string& found) {
        const auto column = static_cast<int>(at_) + 1;
        const std::string place =
            name_ + ':' + std::to_string(line_) + ':' + std::to_string(column);
        errors_.push_back({line_, column,
                           place + ": expected " + expected + ", found " +
                               (found.empty() ? "the end of the line" : quoted(found))});
    }

private:
    static std::string quoted(const std::string& found) { return "'" + printable(found) + "'"; }

    std::string next() {
        at_ = std::min(text_.find_first_not_of(kSpace, end_), text_.size());
        end_ = std::min(text_.find_first_of(kSpace, at_), text_.size());
        columns_.at(numbers_++) = static_cast<int>(at_) + 1;
        return text_.substr(at_, end_ - at_);
    }

    const std::string& text_;
    const std::string& name_;
    const int line_;
    std::vector<LineError>& errors_;
    const size_t errors_before_;
    size_t at_ = 0, end_ = 0;
    size_t numbers_ = 0;
    bool ended_ = false;  // nothing more stands in this line: said once
    std::array<int, 12> columns_{};
};

// A number that is missing is one error, not one in every line behind it.
int readIndex(Row& row, int expected) {
    constexpr int kMax = 1'000'000'000;
    const size_t index = static_cast<size_t>(expected);
    const int found = row.whole("index " + std::to_string(index), 0, kMax);
    if (row.good() && found != expected)
        row.fail("index " + std::to_string(index), std::to_string(found));
    return found;
}

WaypointItem parseRow(Row& row, int index) {
    const double any = INFINITY;
    WaypointItem item;
    item.index = readIndex(row, index);
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
    item.readable = row.good();
    return item;
}

}  // namespace

WaypointReading readWaypointLines(const std::string& bytes, const std::string& name) {
    WaypointReading reading;
    if (const std::string why = whyNoText(bytes); !why.empty()) {
        reading.errors.push_back({1, 1, name + ": " + why});
        return reading;
    }
    std::istringstream lines(decodedText(bytes));
    std::string line;
    int number = 1;
    std::getline(lines, line);
    size_t next_line = line.size() + 1;
    line.erase(line.find_last_not_of(kSpace) + 1);
    if (line != kHeader) {
        Row(line, name, 1, reading.errors).fail("'QGC WPL 110'", line);
        return reading;
    }
    int index = 0;
    while (std::getline(lines, line)) {
        const size_t begins = next_line;
        next_line += line.size() + 1;
        Row row(line, name, ++number, reading.errors);
        if (row.blank()) continue;
        reading.items.push_back(parseRow(row, index));
        reading.items.back().begins = begins;
        index = reading.items.back().index + 1;
    }
    if (reading.errors.empty() && reading.items.size() < 2)
        Row(line, name, number + 1, reading.errors).fail("home and at least one mission item", "");
    return reading;
}

Waypoints parseWaypoints(const std::string& bytes, const std::string& name) {
    return parseMissionFile(bytes, name).items;
}

Waypoints readWaypoints(const std::string& path) { return readMissionFile(path).items; }

}  // namespace simulator
