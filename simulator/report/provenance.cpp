// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/report/provenance.hpp"

#include <nlohmann/json.hpp>
#include <sstream>

#include "simulator/input_file.hpp"

namespace simulator {
namespace {

using Json = nlohmann::ordered_json;

void add(Json& json, const char* name, const std::string& text) {
    if (!text.empty()) json[name] = text;
}

template <class T>
void add(Json& json, const char* name, const std::optional<T>& value) {
    if (value) json[name] = *value;
}

}  // namespace

std::string provenanceJson(const Provenance& from) {
    Json json = Json::object(), firmware = Json::object();
    add(json, "command", from.command);
    add(json, "log", from.log);
    add(json, "mission", from.mission);
    add(json, "airplane", from.airplane);
    add(json, "board", from.board);
    if (from.log.empty()) json["native"] = from.native;
    add(json, "seed", from.seed);
    add(json, "wind", from.wind);
    add(json, "faults", from.faults);
    add(json, "options", from.options);
    add(firmware, "name", from.firmware);
    add(firmware, "commit", from.commit);
    add(firmware, "flash_bytes", from.flash_bytes);
    add(firmware, "ram_bytes", from.ram_bytes);
    json["firmware"] = firmware;
    add(json, "date", from.date);
    add(json, "parameters", from.parameters);
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

void takeCommit(Provenance& provenance) { takeCommit(provenance, COMMIT_FILE); }

void takeCommit(Provenance& provenance, const std::filesystem::path& file) {
    std::istringstream words(wholeFile(file).value_or(""));
    words >> provenance.commit >> provenance.date;
}

}  // namespace simulator
