// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/campaign/flight.hpp"

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>

#include "simulator/input_file.hpp"
#include "simulator/run_program.hpp"

namespace simulator {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr double kFrames_hz = 100;
constexpr double kStartFrames = 5;  // before the first frame is due
// What is given to a flight, or says nothing about how well it was flown.
constexpr const char* kNoFigures[] = {"wind_mps",      "wind_from_deg",    "emulated_s",
                                      "flight_time_s", "touchdown_long_m", "touchdown_right_m"};
constexpr char kInterrupted[] = "interrupted";  // the reason when a signal has ended a flight
constexpr const char* kUnits[] = {"_m", "_mps", "_deg", "_ms"};

std::string contents(const fs::path& path) { return wholeFile(path).value_or(""); }

// The last line of the log that the program speaks to its user in; else the first.
std::string complaintIn(const std::string& log) {
    const size_t flown = log.rfind("fly: "), drawn = log.rfind("drawn: ");
    const size_t at = flown == log.npos ? drawn : flown;
    const size_t begin = at == log.npos ? 0 : at;
    return log.substr(begin, log.find('\n', begin) - begin);
}

bool endsWith(const std::string& text, const std::string& end) {
    return text.size() >= end.size() &&
           text.compare(text.size() - end.size(), end.size(), end) == 0;
}

// Whatever is measured in a length, a speed, an angle or a time.
bool isFigure(const std::string& name, const Json& value) {
    if (!value.is_number()) return false;
    const auto is = [&name](const char* other) { return name == other; };
    if (std::any_of(std::begin(kNoFigures), std::end(kNoFigures), is)) return false;
    return std::any_of(std::begin(kUnits), std::end(kUnits),
                       [&name](const char* unit) { return endsWith(name, unit); });
}

std::string shown(double value) {
    std::ostringstream text;
    text << value;
    return text.str();
}

std::string brokenFrames(const Json& summary) {
    const auto number = [&summary](const char* key) {
        const Json value = summary.value(key, Json());
        return value.is_number() ? value.get<double>() : -1;
    };
    if (number("frame_overruns") > 0) return shown(number("frame_overruns")) + " frames were late";
    const double due = number("emulated_s") * kFrames_hz - kStartFrames;
    if (number("frames") >= 0 && number("frames") < due)
        return "only " + shown(number("frames")) + " of " + shown(due) + " frames were begun";
    if (number("imu_samples_lost") > 0)
        return shown(number("imu_samples_lost")) + " inertial samples were lost";
    return "";
}

}  // namespace

std::string CampaignWind::name() const {
    return calm() ? "calm" : shown(mps) + "," + shown(from_deg);
}

std::string CampaignFlight::missionName() const { return fs::path(mission).stem(); }
std::string CampaignFlight::airplaneName() const { return fs::path(airplane).stem(); }

std::string CampaignFlight::group() const {
    if (drawn) return "drawn";
    return airplaneName() + " " + missionName() + " " + wind.name();
}

std::vector<std::string> CampaignFlight::arguments() const {
    if (drawn) return {"--drawn", std::to_string(seed) + "-" + std::to_string(seed)};
    std::vector<std::string> words = {"--airplane", airplane};
    if (!wind.calm()) words.insert(words.end(), {"--wind", wind.name(), "--gusts"});
    words.insert(words.end(), {"--seed", std::to_string(seed), mission});
    return words;
}

std::string CampaignFlight::replay(bool native) const {
    std::string line = drawn    ? "toolchain/campaign"
                       : native ? "toolchain/fly --native"
                                : "toolchain/fly";
    for (const auto& word : arguments())
        line += word.find(' ') == std::string::npos ? " " + word : " '" + word + "'";
    return line;
}

CampaignResult resultOf(const CampaignFlight& flight, const std::string& summary_json) {
    CampaignResult result{flight, true, "", {}, 0, {}};
    const Json summary = Json::parse(summary_json, nullptr, false);
    if (!summary.is_object()) {
        result.failure = "no summary was written";
        return result;
    }
    result.emulated_s = summary.value("emulated_s", 0.0);
    if (!summary.value("completed", false)) {
        const Json reason = summary.value("reason", Json());
        result.failure = reason.is_string() ? reason.get<std::string>() : "not completed";
        result.flown = result.failure != kInterrupted;
    } else {
        result.failure = brokenFrames(summary);
    }
    const Json past = summary.value("touchdown_long_m", Json());
    const Json right = summary.value("touchdown_right_m", Json());
    if (past.is_number() && right.is_number())
        result.touchdown = {past.get<double>(), right.get<double>()};
    for (const auto& [name, value] : summary.items())
        if (isFigure(name, value)) result.figures[name] = value.get<double>();
    return result;
}

std::vector<WorldValue> worldValuesOf(const std::string& drawn_json) {
    const Json drawn = Json::parse(drawn_json, nullptr, false);
    std::vector<WorldValue> values;
    if (!drawn.is_object() || drawn.value("format", Json()) != "apm-drawn") return values;
    for (const Json& each : drawn.value("values", Json()))
        if (each.is_object())
            values.push_back({each.value("key", ""), each.value("name", ""), each.value("unit", ""),
                              each.value("value", 0.0)});
    return values;
}

static Ending run(const CampaignPrograms& programs, const CampaignFlight& flight,
                  const std::string& folder, const fs::path& log) {
    if (flight.drawn)
        return runProgram(programs.drawn,
                          {std::to_string(flight.seed), "--out", folder, "--fly", programs.fly},
                          log);
    std::vector<std::string> words = {"--native", "--out", folder};
    for (const auto& word : flight.arguments()) words.push_back(word);
    return runProgram(programs.fly, words, log);
}

static CampaignResult flyIn(const std::string& folder, const CampaignPrograms& programs,
                            const CampaignFlight& flight) {
    fs::remove_all(folder);
    fs::create_directories(folder);
    const fs::path log = fs::path(folder) / "fly.log";
    const Ending ending = run(programs, flight, folder, log);
    CampaignResult result = resultOf(flight, contents(fs::path(folder) / "summary.json"));
    if (ending.signal == SIGINT || ending.signal == SIGTERM) {
        result.failure = kInterrupted;
        result.flown = false;
    } else if (ending.signal != 0) {
        result.failure = "the program died of signal " + std::to_string(ending.signal);
    } else if (ending.status > 1 || (flight.drawn && result.emulated_s <= 0)) {
        result.failure = complaintIn(contents(log));
    }
    if (flight.drawn) result.world = worldValuesOf(contents(fs::path(folder) / "drawn.json"));
    for (const char* large : {"flight.csv", "track.kml", "track.gpx"})
        fs::remove(fs::path(folder) / large);
    return result;
}

// A full disk fails the flight, not the program.
CampaignResult flyOne(const CampaignPrograms& programs, const CampaignFlight& flight,
                      const std::string& folder) {
    try {
        return flyIn(folder, programs, flight);
    } catch (const std::exception& error) {
        return {flight, true, error.what(), {}, 0, {}};
    }
}

}  // namespace simulator
