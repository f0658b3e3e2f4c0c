// SPDX-License-Identifier: GPL-3.0-or-later
// What the flights that check themselves have in common: the world they begin in, the rows they
// print, and the files they leave for the sums and reports over all tests.
#pragma once
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include "simulator/board.hpp"
#include "simulator/ground/scripted_flight.hpp"
#include "simulator/report/summary.hpp"

namespace simulator {

// On the runway at the mission's home, in a steady wind.
inline WorldOptions worldAt(const Waypoints& items, double wind_mps = 0, double from_deg = 0) {
    WorldOptions world;
    world.latitude_deg = items[0].latitude_deg;
    world.longitude_deg = items[0].longitude_deg;
    world.altitude_m = items[0].altitude_m;
    world.heading_deg = 340;
    world.wind_mps = wind_mps;
    world.wind_from_deg = from_deg;
    return world;
}

inline bool say(bool passed, const std::string& what) {
    std::printf("  %s  %s\n", passed ? "ok    " : "FAILED", what.c_str());
    return passed;
}

struct Check {
    const char* what;
    bool passed;
};
template <size_t kCount>
bool printChecks(const Check (&rows)[kCount]) {
    bool all = true;
    for (const Check& row : rows) all = say(row.passed, row.what) && all;
    return all;
}

// What happened, for finding out why a flight failed.
inline void printEvents(const ScriptedFlight& flight) {
    if (!flight.reason().empty()) std::printf("  %s\n", flight.reason().c_str());
    for (const Event& event : flight.telemetry().events)
        std::printf("%8.1f s  %s\n", event.time_s, event.text.c_str());
    for (const Event& text : flight.telemetry().texts)
        std::printf("%8.1f s  said: %s\n", text.time_s, text.text.c_str());
}

// All but the figures that only the flight knows.
inline Summary summaryOf(Board& board, const ScriptedFlight& flight, const std::string& firmware,
                         const WorldOptions& world = {}) {
    Summary s;
    const bool native = firmware == "native";
    s.firmware = std::filesystem::path(firmware).filename();
    s.board = native ? "native" : "apm2";
    s.wind_mps = world.wind_mps;
    s.wind_from_deg = world.wind_from_deg;
    s.gusts = world.gusts;
    s.seed = world.seed;
    s.reason = flight.reason();
    s.emulated_s = static_cast<double>(board.time_us()) * 1e-6;
    s.figures = board.figures();
    if (!native) s.task_names = readTaskNames(firmware);
    s.events = flight.telemetry().events;
    s.texts = flight.telemetry().texts;
    return s;
}

// Of every run of the image, for the sum that the tests may not pass.
inline void writeMinutes(const std::filesystem::path& file, double minutes) {
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file) << minutes << '\n';
    std::printf("emulated minutes: %.2f\n", minutes);
}

inline void emptyFolder(const std::filesystem::path& folder) {
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
}

// OUT/summary.json, and the minutes under the name of OUT.
inline void writeOutcome(const std::filesystem::path& out, const std::filesystem::path& minutes,
                         const Summary& summary) {
    std::ofstream(out / "summary.json") << summaryJson(summary);
    writeMinutes(minutes / out.filename(), summary.emulated_s / 60);
}

}  // namespace simulator
