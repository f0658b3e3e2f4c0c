// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/report/names.hpp"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "shared_tables.hpp"

namespace simulator {
namespace {

using Json = nlohmann::json;

const Json& names() {
    static const Json read = Json::parse(tables::k_names);
    return read;
}

std::string nameIn(const char* table, const std::string& key) {
    const Json& rows = names()[table];
    const auto found = rows.find(key);
    return found == rows.end() ? "" : found->get<std::string>();
}

std::string general(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%g", value);
    return text;
}

std::string codeName(int subsystem, int code, bool ours) {
    const std::string key = std::to_string(subsystem) + "." + std::to_string(code);
    const std::string known = nameIn(ours ? "our_codes" : "ardupilot_codes", key);
    if (!known.empty()) return known;
    if (code == 0) return "resolved";
    if (code == 1 && !ours) return "failsafe occurred";
    return "code " + std::to_string(code);
}

}  // namespace

std::string commandName(uint16_t command) {
    const std::string name = nameIn("commands", std::to_string(command));
    return name.empty() ? "COMMAND " + std::to_string(command) : name;
}

std::string itemText(const WaypointItem& item) {
    std::string text = commandName(item.command);
    for (char& letter : text)
        letter = letter == '_' ? ' ' : static_cast<char>(std::tolower(letter));
    if (item.altitude_m != 0) text += ", " + general(item.altitude_m) + " m";
    const auto& params = item.params;
    if (std::all_of(params.begin(), params.end(), [](double each) { return each == 0; }))
        return text;
    text += ", parameters";
    for (const double each : params) text += " " + general(each);
    return text;
}

const std::vector<FailsafeTexts>& failsafeTexts() {
    static const std::vector<FailsafeTexts> read = [] {
        std::vector<FailsafeTexts> rows;
        for (const Json& row : names()["failsafes"]) rows.push_back({row[0], row[1]});
        return rows;
    }();
    return read;
}

std::string logEventName(int id) {
    const std::string name = nameIn("events", std::to_string(id));
    return name.empty() ? "event " + std::to_string(id) : name;
}

std::string logSubsystemName(int subsystem) {
    const Json& all = names()["subsystems"];
    const bool known = subsystem >= 0 && subsystem < static_cast<int>(all.size());
    return known && all[static_cast<size_t>(subsystem)].is_string()
               ? all[static_cast<size_t>(subsystem)].get<std::string>()
               : "";
}

std::string logErrorName(int subsystem, int code, bool ours) {
    const std::string name = logSubsystemName(subsystem);
    return (name.empty() ? "subsystem " + std::to_string(subsystem) : name) + ": " +
           codeName(subsystem, code, ours);
}

}  // namespace simulator
