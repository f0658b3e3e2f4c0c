// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/drawn/files.hpp"

#include <cstdio>
#include <nlohmann/json.hpp>
#include <sstream>

#include "simulator/output_file.hpp"
#include "simulator/world_file.hpp"

namespace simulator::drawn {
namespace {

std::string waypointText(const Waypoints& items) {
    std::string text = "QGC WPL 110\n";
    for (const WaypointItem& item : items) {
        char line[200];
        std::snprintf(line, sizeof line, "%d\t%d\t%d\t%d\t%g\t%g\t%g\t%g\t%.7f\t%.7f\t%.2f\t1\n",
                      item.index, item.index == 0, item.frame, item.command, item.params[0],
                      item.params[1], item.params[2], item.params[3], item.latitude_deg,
                      item.longitude_deg, item.altitude_m);
        text += line;
    }
    return text;
}

// docs/campaign_document.md
std::string drawnText(const DrawnWorld& drawn) {
    nlohmann::ordered_json json = {{"format", "apm-drawn"},
                                   {"version", 1},
                                   {"seed", drawn.world.seed},
                                   {"about", drawn.about},
                                   {"values", nlohmann::ordered_json::array()}};
    for (const DrawnValue& each : drawn.values)
        json["values"].push_back(
            {{"key", each.key}, {"name", each.name}, {"unit", each.unit}, {"value", each.value}});
    return json.dump(1) + "\n";
}

}  // namespace

void writeParameters(const std::filesystem::path& path, const std::string& about,
                     const ParameterSettings& settings) {
    std::ostringstream text;
    text << "# " << about << "\n";
    for (const ParameterSetting& each : settings) text << each.name << "," << each.value << "\n";
    writeFile(path, text.str());
}

void writeFiles(const DrawnFiles& files, const DrawnWorld& drawn) {
    writeFile(files.airplane, airplaneText(drawn.airplane, drawn.about));
    writeParameters(files.owner, "What its owner knows.", drawn.owner);
    writeFile(files.world, worldFileText(drawn.world));
    writeFile(files.mission, waypointText(drawn.mission));
    writeFile(files.drawn, drawnText(drawn));
}

}  // namespace simulator::drawn
