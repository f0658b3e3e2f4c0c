// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/live/command_names.hpp"

#include <cmath>

namespace simulator::live {
namespace {

struct Row {
    uint16_t command;
    const char* name;
};
// clang-format off
constexpr Row kRows[] = {
    {16, "WAYPOINT"}, {17, "LOITER_UNLIM"}, {18, "LOITER_TURNS"}, {19, "LOITER_TIME"},
    {20, "RETURN_TO_LAUNCH"}, {21, "LAND"}, {22, "TAKEOFF"}, {30, "CONTINUE_AND_CHANGE_ALT"},
    {31, "LOITER_TO_ALT"}, {82, "SPLINE_WAYPOINT"}, {83, "ALTITUDE_WAIT"}, {92, "GUIDED_ENABLE"},
    {93, "DELAY"}, {112, "CONDITION_DELAY"}, {113, "CONDITION_CHANGE_ALT"},
    {114, "CONDITION_DISTANCE"}, {115, "CONDITION_YAW"}, {176, "SET_MODE"}, {177, "JUMP"},
    {178, "CHANGE_SPEED"}, {179, "SET_HOME"}, {181, "SET_RELAY"}, {182, "REPEAT_RELAY"},
    {183, "SET_SERVO"}, {184, "REPEAT_SERVO"}, {189, "LAND_START"}, {191, "GO_AROUND"},
    {201, "SET_ROI"}, {202, "DIGICAM_CONFIGURE"}, {203, "DIGICAM_CONTROL"},
    {205, "MOUNT_CONTROL"}, {206, "SET_CAM_TRIGG_DIST"}, {207, "FENCE_ENABLE"},
    {210, "INVERTED_FLIGHT"}, {5000, "FENCE_RETURN_POINT"}, {5001, "FENCE_VERTEX_INCLUSION"},
    {5002, "FENCE_VERTEX_EXCLUSION"}, {5003, "FENCE_CIRCLE_INCLUSION"},
    {5004, "FENCE_CIRCLE_EXCLUSION"}, {5100, "RALLY_POINT"},
};
// clang-format on

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%g", value);
    return text;
}

}  // namespace

std::string commandName(uint16_t command) {
    for (const Row& row : kRows)
        if (row.command == command) return row.name;
    return "command " + std::to_string(command);
}

std::string itemText(const WaypointItem& item) {
    std::string text;
    const auto add = [&text](const std::string& more) {
        text += (text.empty() ? "" : ", ") + more;
    };
    if (item.isNav())
        add(number(std::round(item.altitude_m * 10) / 10) +
            (item.relative() ? " m above home" : " m above sea"));
    for (size_t i = 0; i < item.params.size(); ++i)
        if (item.params[i] != 0 && std::isfinite(item.params[i]))
            add("p" + std::to_string(i + 1) + " " + number(item.params[i]));
    return text;
}

}  // namespace simulator::live
