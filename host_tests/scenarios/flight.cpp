// SPDX-License-Identifier: GPL-3.0-or-later
// Flights as tests. Prints what was measured against what is allowed; exits 0 when all limits hold.
//   flight fly FOLDER MINUTES_FOLDER CROSSTRACK_M ALTITUDE_M TOUCHDOWN_M PROGRAM [ARGUMENT...]
//   flight same SUMMARY_A SUMMARY_B        the same mission events in the same order?
//   flight minutes MINUTES_FOLDER          emulated minutes of all flights together
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>

namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

Json readJson(const fs::path& path) {
    std::ifstream file(path);
    return Json::parse(file);
}

struct Limit {
    const char* key;
    double most;
    const char* unit;
};

bool holds(const Json& summary, const Limit& limit) {
    const Json& value = summary.at(limit.key);
    const bool ok = value.is_number() && value.get<double>() <= limit.most;
    std::cout << (ok ? "  ok      " : "  FAILED  ") << limit.key << ' ' << value << ", at most "
              << limit.most << ' ' << limit.unit << '\n';
    return ok;
}

std::string quoted(const std::string& word) { return "'" + word + "'"; }

int fly(const std::vector<std::string>& words) {
    const fs::path folder = words.at(0), minutes = words.at(1);
    const Limit limits[] = {{"crosstrack_rms_m", std::stod(words.at(2)), "m"},
                            {"altitude_rms_m", std::stod(words.at(3)), "m"},
                            {"landed_distance_m", std::stod(words.at(4)), "m"}};
    std::string command;
    for (size_t i = 5; i < words.size(); ++i) command += quoted(words[i]) + " ";
    fs::remove_all(folder);
    const int status = std::system((command + "--out " + quoted(folder.string())).c_str());
    if (!fs::exists(folder / "summary.json")) {
        std::cout << "  FAILED  no summary was written\n";
        return 1;
    }
    const Json summary = readJson(folder / "summary.json");
    bool ok = status == 0;
    for (const Limit& limit : limits) ok = holds(summary, limit) && ok;
    if (summary.at("frame_overruns").is_number())
        ok = holds(summary, {"frame_overruns", 0, ""}) && ok;
    const double flown_min = summary.at("emulated_s").get<double>() / 60;
    std::cout << "emulated minutes: " << flown_min << '\n';
    fs::create_directories(minutes);
    std::ofstream(minutes / folder.filename()) << flown_min << '\n';
    return ok ? 0 : 1;
}

// Modes and arming are sent in a heartbeat once a second, the mission's progress when it happens:
// each is a sequence of its own. What comes next is announced in a stream's phase and left out.
std::vector<std::string> events(const Json& summary, bool by_heartbeat) {
    std::vector<std::string> found;
    for (const Json& event : summary.at("events")) {
        const std::string text = event.at("text");
        const bool beat = text.rfind("mode ", 0) == 0 || text == "armed" || text == "disarmed";
        if (beat == by_heartbeat && text.rfind("flies item", 0) != 0) found.push_back(text);
    }
    return found;
}

bool sameSequence(const std::vector<std::string>& a, const std::vector<std::string>& b) {
    for (size_t i = 0; i < std::max(a.size(), b.size()); ++i) {
        const std::string left = i < a.size() ? a[i] : "-", right = i < b.size() ? b[i] : "-";
        std::cout << (left == right ? "  " : "! ") << left << " | " << right << '\n';
    }
    return a == b && !a.empty();
}

int same(const std::vector<std::string>& words) {
    const Json a = readJson(words.at(0)), b = readJson(words.at(1));
    const bool modes = sameSequence(events(a, true), events(b, true));
    const bool mission = sameSequence(events(a, false), events(b, false));
    return modes && mission ? 0 : 1;
}

constexpr double kMaxMinutes = 150;

int minutes(const std::vector<std::string>& words) {
    double sum = 0;
    int flights = 0;
    if (fs::exists(words.at(0))) {
        for (const auto& entry : fs::directory_iterator(words[0])) {
            std::ifstream file(entry.path());
            for (double flown = 0; file >> flown; ++flights) sum += flown;
        }
    }
    std::cout << "the image ran " << sum << " emulated minutes in " << flights << " runs, of "
              << kMaxMinutes << '\n';
    return sum <= kMaxMinutes ? 0 : 1;
}

}  // namespace

int main(int count, char** arguments) {
    const std::vector<std::string> words(arguments + 1, arguments + count);
    const std::string verb = words.empty() ? "" : words[0];
    const std::vector<std::string> rest(words.begin() + !words.empty(), words.end());
    try {
        if (verb == "fly") return fly(rest);
        if (verb == "same") return same(rest);
        if (verb == "minutes") return minutes(rest);
        std::cerr << "flight: expected fly, same or minutes\n";
    } catch (const std::exception& error) {
        std::cerr << "flight: " << error.what() << '\n';
    }
    return 2;
}
