// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/flight_folder.hpp"

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>
#include <vector>

#include "simulator/output_file.hpp"

namespace simulator {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr char kEntry[] = "entry.json";
constexpr size_t kMaxName = 40;

// Of 12-box_600: 12; 0: it is none of ours.
int numberOf(const fs::path& folder) {
    const std::string name = folder.filename();
    const size_t end = name.find_first_not_of("0123456789");
    if (end == 0 || end == name.npos || end > 8 || name[end] != '-') return 0;
    return std::stoi(name.substr(0, end));
}

std::vector<fs::path> foldersIn(const fs::path& flights) {
    std::vector<fs::path> all;
    std::error_code error;
    for (const auto& each : fs::directory_iterator(flights, error))
        if (numberOf(each.path()) > 0) all.push_back(each.path());
    std::sort(all.begin(), all.end(),
              [](const fs::path& a, const fs::path& b) { return numberOf(a) > numberOf(b); });
    return all;
}

std::string plainName(const std::string& mission) {
    std::string name = fs::path(mission).stem().string().substr(0, kMaxName);
    for (char& c : name)
        if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-') c = '_';
    return name.empty() ? "flight" : name;
}

// Another flight may take the same number at the same moment: then the next one.
fs::path newFolder(const fs::path& flights, const std::string& mission) {
    makeFolder(flights);
    const std::vector<fs::path> before = foldersIn(flights);
    int number = before.empty() ? 1 : numberOf(before.front()) + 1;
    for (;; ++number) {
        const fs::path path = flights / (std::to_string(number) + "-" + plainName(mission));
        std::error_code error;
        if (fs::create_directory(path, error)) return path;
        if (error) throw OutputError(path.string(), error.value());
    }
}

std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (c == '&') out += "&amp;";
        if (c == '<') out += "&lt;";
        if (c == '"') out += "&quot;";
        if (c != '&' && c != '<' && c != '"') out += c;
    }
    return out;
}

std::string wordOf(const Json& json, const char* name) {
    return json.contains(name) && json[name].is_string() ? escaped(json[name].get<std::string>())
                                                         : "";
}

std::string rowOf(const fs::path& folder) {
    std::ifstream file(folder / kEntry);
    const Json json = Json::parse(file, nullptr, false);
    if (!json.is_object()) return "";
    const bool good = json.contains("good") && json["good"] == true;
    const std::string name = escaped(folder.filename());
    std::string row = "<tr><td><a href=\"" + name + "/report.html\">" + name + "</a></td>";
    for (const char* each : {"date", "mission", "airplane", "board"})
        row += "<td>" + wordOf(json, each) + "</td>";
    return row + "<td class=\"" + (good ? "good" : "bad") + "\">" + wordOf(json, "result") +
           "</td></tr>\n";
}

constexpr char kHead[] = R"html(<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>Flights</title>
<link rel="icon" href="data:,">
<style>
body { font: 15px/1.5 system-ui, sans-serif; margin: 1.5em; }
table { border-collapse: collapse; }
th, td { text-align: left; padding: .2em .8em .2em 0; border-bottom: 1px solid #8884; }
.good { color: light-dark(#17692d, #7fd694); }
.bad { color: light-dark(#a3231c, #ff9d94); }
</style>
<h1>Flights</h1>
<table>
<thead><tr><th>report</th><th>date</th><th>mission</th><th>airplane</th><th>board</th><th>result</th></tr></thead>
<tbody>
)html";

}  // namespace

std::string indexPage(const fs::path& flights) {
    std::string page = kHead;
    for (const fs::path& folder : foldersIn(flights)) page += rowOf(folder);
    return page + "</tbody>\n</table>\n</html>\n";
}

FlightFolder::FlightFolder(const fs::path& asked) : path_(asked) { makeFolder(path_); }

FlightFolder::FlightFolder(const fs::path& flights, const fs::path& newest,
                           const std::string& mission)
    : path_(newFolder(flights, mission)), flights_(flights), newest_(newest) {}

FlightFolder::~FlightFolder() {
    std::error_code not_empty;
    if (!flights_.empty()) fs::remove(path_, not_empty);
}

// The index is made beside the flight and moved, so that two flights that end at once never mix.
void FlightFolder::enter(const FlightEntry& entry) const {
    if (flights_.empty()) return;
    const Json json = {{"date", entry.date},       {"airplane", entry.airplane},
                       {"mission", entry.mission}, {"board", entry.board},
                       {"result", entry.result},   {"good", entry.good}};
    writeFile(path_ / kEntry, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
    const fs::path made = path_ / "index.html", index = flights_ / "index.html";
    writeFile(made, indexPage(flights_));
    std::error_code error;
    fs::rename(made, index, error);
    if (error) throw OutputError(index.string(), error.value());
    link();
}

// A folder in the link's place is a flight of before there was a link: it becomes one of them.
void FlightFolder::link() const {
    std::error_code error;
    if (fs::is_directory(fs::symlink_status(newest_, error))) {
        const fs::path kept = newFolder(flights_, "before");
        fs::rename(newest_, kept, error);
    }
    const fs::path made = path_ / "newest";
    fs::create_directory_symlink(fs::relative(path_, newest_.parent_path()), made, error);
    if (!error) fs::rename(made, newest_, error);
    if (!error) return;
    std::error_code ignored;
    fs::remove(made, ignored);
    throw OutputError(newest_.string(), error.value());
}

}  // namespace simulator
