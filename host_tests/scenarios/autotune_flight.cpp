// SPDX-License-Identifier: GPL-3.0-or-later
// AUTOTUNE in the air, natively: a pilot who rolls and pitches from gains that are so many times
// the defaults comes to the gains of this airplane, whatever they were at first. Exits 0 when that
// is so.
//   autotune_flight AIRPLANE MISSION TIMES RLL2SRV_P PTCH2SRV_P [NAME=VALUE ...]
//   autotune_flight AIRPLANE MISSION to OWN.param FOUND.param
// NAME is set to VALUE before: what an airplane needs to be flown at all, its mixing for one. The
// second form begins with the defaults, and with what OWN.param says but for the gains that are
// learnt; it writes all that to FOUND.param with the gains it finds.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>

#include "firmware/state/parameters.hpp"
#include "host_tests/scenarios/flight_scenario.hpp"
#include "simulator/devices/ppm_encoder.hpp"
#include "simulator/ground/tuning_pilot.hpp"
#include "simulator/invariants/watched_board.hpp"
#include "simulator/parameter_file.hpp"

using namespace simulator;

namespace {

constexpr uint64_t kStep_us = 20'000;
constexpr float kFarthest = 1.25f;  // from what it is to come to

float parameterNow(const char* name) {
    char padded[16] = {};
    std::memcpy(padded, name, std::min(std::strlen(name), sizeof padded));
    uint16_t index;
    float value = NAN;
    uint8_t type;
    if (firmware::state::parameterFind(padded, index))
        firmware::state::parameterAt(index, padded, value, type);
    return value;
}

struct Gains {
    float roll_p, pitch_p;
};

class Tuning : FlightScenario {
public:
    Tuning(Board& board, const Waypoints& items, const ParameterSettings& settings)
        : FlightScenario(
              board, items, 600, kStep_us, [](const mavlink::Frame&, uint64_t) {}, settings) {}

    Gains learn(float by) {
        while (advance() && sinceAirborne_s() <= 25) {
        }
        set({{"FLTMODE1", 8},
             {"RLL2SRV_P", 0.75f * by},
             {"RLL2SRV_I", 0.04f * by},
             {"RLL2SRV_D", 0.03f * by},
             {"PTCH2SRV_P", 1 * by},
             {"PTCH2SRV_I", 0.3f * by},
             {"PTCH2SRV_D", 0.05f * by}});
        const double from_s = seconds();
        // straight on: every turn is one that he flies for AUTOTUNE
        constexpr double kFar_m = 1e6;
        TuningPilot pilot(double{parameterNow("TRIM_ARSPD_CM")} * 0.01, kFar_m);
        for (double t_s = 0; t_s < kTuneAll_s && advance(); t_s = seconds() - from_s)
            board_.world().radio().sticks(pilot.sticks(t_s, board_.world().truth()), true);
        if (flight_.over()) throw std::runtime_error("the flight ended: " + flight_.reason());
        const Gains found = {firmware::state::parameters.roll.axis.p,
                             firmware::state::parameters.pitch.axis.p};
        std::printf("  from %.1f times the defaults: RLL2SRV_P %.2f, PTCH2SRV_P %.2f\n", double(by),
                    double(found.roll_p), double(found.pitch_p));
        return found;
    }

private:
    void set(std::initializer_list<std::pair<const char*, float>> parameters) {
        for (const auto& [name, value] : parameters) {
            send(name, value);
            for (int i = 0; i < 10; ++i) advance();
        }
    }
};

WorldOptions worldOf(const std::string& airplane, const Waypoints& items) {
    WorldOptions world = worldAt(items, 4, 320);
    world.airplane = airplane;
    world.seed = 3;
    return world;
}

constexpr const char* kLearnt[] = {"RLL2SRV_TCONST",  "RLL2SRV_P",  "RLL2SRV_I",  "RLL2SRV_D",
                                   "PTCH2SRV_TCONST", "PTCH2SRV_P", "PTCH2SRV_I", "PTCH2SRV_D"};

int learnTo(const std::string& airplane, const Waypoints& items, const std::string& own,
            const std::string& found) {
    ParameterSettings settings = readParameterFile(own);
    settings.erase(std::remove_if(settings.begin(), settings.end(),
                                  [](const ParameterSetting& each) {
                                      return std::count(std::begin(kLearnt), std::end(kLearnt),
                                                        each.name) > 0;
                                  }),
                   settings.end());
    WatchedBoard board(std::make_unique<NativeBoard>(worldOf(airplane, items)));
    Tuning tuning(board, items, settings);
    tuning.learn(1);
    const bool held = board.held();
    std::filesystem::create_directories(std::filesystem::path(found).parent_path());
    std::ofstream file(found);
    file << "# " << own << ", but for the gains, which AUTOTUNE has found.\n";
    for (const ParameterSetting& each : settings) file << each.name << "," << each.value << "\n";
    for (const char* name : kLearnt) file << name << "," << parameterNow(name) << "\n";
    return file.good() && held ? 0 : 1;
}

bool near(float one, float other) { return one < kFarthest * other && other < kFarthest * one; }

}  // namespace

int main(int count, char** words) try {
    if (count == 6 && std::string(words[3]) == "to")
        return learnTo(words[1], readWaypoints(words[2]), words[4], words[5]);
    if (count < 6)
        throw std::runtime_error("expected AIRPLANE MISSION TIMES RLL2SRV_P PTCH2SRV_P NAME=VALUE");
    ParameterSettings settings;
    for (int i = 6; i < count; ++i) {
        const std::string word = words[i];
        const size_t equals = word.find('=');
        settings.push_back({word.substr(0, equals), std::stod(word.substr(equals + 1))});
    }
    const Gains right = {std::stof(words[4]), std::stof(words[5])};
    const Waypoints items = readWaypoints(words[2]);
    WatchedBoard board(std::make_unique<NativeBoard>(worldOf(words[1], items)));
    Tuning tuning(board, items, settings);
    const Gains found = tuning.learn(std::stof(words[3]));
    const bool ok = near(found.roll_p, right.roll_p) && near(found.pitch_p, right.pitch_p);
    std::printf("  %s wanted about %s and %s\n", ok ? "ok    " : "FAILED", words[4], words[5]);
    return board.held() && ok ? 0 : 1;
} catch (const std::exception& error) {
    std::fprintf(stderr, "autotune_flight: %s\n", error.what());
    return 1;
}
