// SPDX-License-Identifier: GPL-3.0-or-later
// Mission files: "QGC WPL 110", the text form every ground station writes. One item a line, twelve
// columns: index current frame command p1 p2 p3 p4 latitude longitude altitude autocontinue.
#pragma once
#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "mavlink/messages.hpp"

namespace simulator {

// Below MAV_CMD_NAV_LAST, 95. NAV_DELAY is one by its number only: it has no effect here.
constexpr bool isNavCommand(int command) {
    constexpr int kNavDelay = 93;
    return command < 96 && command != kNavDelay;
}

struct WaypointItem {
    int index = 0;
    bool current = false;
    uint8_t frame = 0;     // MAV_FRAME
    uint16_t command = 0;  // MAV_CMD
    std::array<double, 4> params{};
    double latitude_deg = 0, longitude_deg = 0, altitude_m = 0;  // altitude in the frame's sense
    bool autocontinue = true;
    bool readable = true;           // false: an error of its line is reported
    int line = 0;                   // of the file, from 1
    size_t begins = 0;              // of that line in the file's decodedText
    std::array<int, 12> columns{};  // where each number begins, from 1

    bool isNav() const { return isNavCommand(command); }
    bool isCircle() const {
        return command >= mavlink::MavCmd::nav_loiter_unlim &&
               command <= mavlink::MavCmd::nav_loiter_time;
    }
    bool hasPlace() const {
        return isNav() && command != mavlink::MavCmd::nav_takeoff &&
               command != mavlink::MavCmd::nav_return_to_launch;
    }
    // 0, 0 stands for the place where the airplane is; one of both alone is a meridian or the
    // equator.
    bool isPlaced() const { return hasPlace() && (latitude_deg != 0 || longitude_deg != 0); }
    bool relative() const { return frame == 3 || frame == 6; }  // to home
};
using Waypoints = std::vector<WaypointItem>;

struct LineError {
    int line, column;
    std::string text;  // "name:line:column: expected ..."
};

// Every line that is no comment gives an item, so that places in the mission stay what they are.
struct WaypointReading {
    Waypoints items;
    std::vector<LineError> errors;
};
WaypointReading readWaypointLines(const std::string& bytes, const std::string& name);

// what() has a line for each error, 50 at most.
class WaypointError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

// The items alone of any file that mission_file.hpp reads.
Waypoints parseWaypoints(const std::string& bytes, const std::string& name);
Waypoints readWaypoints(const std::string& path);  // throws WaypointError also when unreadable

}  // namespace simulator
