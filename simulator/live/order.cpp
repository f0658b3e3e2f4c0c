// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/live/order.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "simulator/ground/telemetry.hpp"

namespace simulator::live {
namespace {

using Json = nlohmann::json;
using Do = Order::Do;

constexpr uint32_t kModes[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 10, 11, 12, 15};
constexpr double kMaxTimes = 1000, kMaxWind_mps = 30;

double number(const Json& json, const char* name, double from, double to) {
    const auto found = json.find(name);
    if (found == json.end() || !found->is_number())
        throw OrderError(std::string(name) + ": expected a number");
    const double value = found->get<double>();
    if (value >= from && value <= to) return value;
    char text[80];
    std::snprintf(text, sizeof text, "%s: expected %g to %g", name, from, to);
    throw OrderError(text);
}

std::string word(const Json& json, const char* name) {
    const auto found = json.find(name);
    if (found != json.end() && found->is_string()) return found->get<std::string>();
    throw OrderError(std::string(name) + ": expected a word");
}

void readMode(const Json& json, Order& order) {
    const std::string name = word(json, "mode");
    const auto found = std::find_if(std::begin(kModes), std::end(kModes),
                                    [&](uint32_t mode) { return modeName(mode) == name; });
    if (found == std::end(kModes)) throw OrderError("mode: there is no such mode");
    order.mode = *found;
}

void readPlace(const Json& json, Order& order) {
    order.latitude_deg = number(json, "lat_deg", -90, 90);
    order.longitude_deg = number(json, "lon_deg", -180, 180);
    if (json.contains("altitude_m")) order.height_m = number(json, "altitude_m", -500, 10'000);
}

void readSpeed(const Json& json, Order& order) {
    if (json.contains("times") && json["times"] == "max") {
        order.times = 0;
    } else {
        order.times = number(json, "times", 0.1, kMaxTimes);
    }
}

void readFault(const Json& json, Order& order) {
    order.fault_name = word(json, "name");
    const auto fault = faultNamed(order.fault_name);
    if (!fault) throw OrderError("name: there is no such fault; 'fly --help' names them");
    order.fault = *fault;
    const auto on = json.find("on");
    if (on == json.end() || !on->is_boolean()) throw OrderError("on: expected true or false");
    order.on = on->get<bool>();
    if (order.fault_name.find(':') == std::string::npos)
        order.fault_name[order.fault_name.find('_')] = ':';
}

void readWind(const Json& json, Order& order) {
    order.wind_mps = number(json, "speed_mps", 0, kMaxWind_mps);
    order.wind_from_deg = number(json, "from_deg", 0, 360);
}

void readSticks(const Json& json, Order& order) {
    order.roll = number(json, "roll", -1, 1);
    order.pitch = number(json, "pitch", -1, 1);
    order.throttle = number(json, "throttle", 0, 1);
    order.yaw = number(json, "yaw", -1, 1);
}

void readNothing(const Json&, Order&) {}

struct Row {
    const char* name;
    Do what;
    void (*read)(const Json&, Order&);
};
constexpr Row kRows[] = {
    {"arm", Do::arm, readNothing},         {"disarm", Do::disarm, readNothing},
    {"takeoff", Do::takeoff, readNothing}, {"pause", Do::pause, readNothing},
    {"resume", Do::resume, readNothing},   {"mode", Do::mode, readMode},
    {"goto", Do::go_to, readPlace},        {"speed", Do::speed, readSpeed},
    {"fault", Do::fault, readFault},       {"wind", Do::wind, readWind},
    {"sticks", Do::sticks, readSticks},
};

std::string names() {
    std::string all;
    for (const Row& row : kRows) all += (all.empty() ? "" : ", ") + std::string(row.name);
    return all;
}

}  // namespace

std::optional<Fault> faultNamed(const std::string& name) {
    std::string text = name;
    const size_t at = text.find_first_of(":_");
    if (at == text.npos) return std::nullopt;
    text[at] = ':';
    return parseFault(text + "@0");
}

Order readOrder(const std::string& text) {
    constexpr int kDepth = 4;  // of objects in objects: none of them means anything here
    if (std::count_if(text.begin(), text.end(), [](char c) { return c == '[' || c == '{'; }) >
        kDepth)
        throw OrderError("expected one flat JSON object");
    const Json json = Json::parse(text, nullptr, false);
    if (!json.is_object()) throw OrderError("expected a JSON object");
    const std::string what = word(json, "do");
    for (const Row& row : kRows) {
        if (row.name != what) continue;
        Order order;
        order.what = row.what;
        row.read(json, order);
        return order;
    }
    throw OrderError("do: expected " + names());
}

std::vector<std::string> modeNames() {
    std::vector<std::string> all;
    for (const uint32_t mode : kModes) all.push_back(modeName(mode));
    return all;
}

std::vector<std::string> faultNames() {
    std::vector<std::string> all;
    for (int part = 0; part < kFaulty; ++part)
        for (int kind = 1; kind < kFaultKinds; ++kind) {
            const auto faulty = static_cast<Faulty>(part);
            const auto how = static_cast<FaultKind>(kind);
            if (canFail(faulty, how) && how != FaultKind::sag)
                all.push_back(nameOf(faulty) + std::string(":") + nameOf(how));
        }
    return all;
}

}  // namespace simulator::live
