// SPDX-License-Identifier: GPL-3.0-or-later
// Flies a scenario: a ground station brings the airplane into AUTO, then the events have it. At the
// end the board must still answer, and know what it has acknowledged.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "simulator/airplane/parameters.hpp"
#include "simulator/chaos/drill.hpp"
#include "simulator/chaos/outcome.hpp"
#include "simulator/chaos/station.hpp"
#include "simulator/devices/faults.hpp"
#include "simulator/devices/ppm_encoder.hpp"
#include "simulator/ground/scripted_flight.hpp"
#include "simulator/invariants/watched_board.hpp"
#include "simulator/parameter_file.hpp"

namespace simulator::chaos {
namespace {

constexpr int kTelemetry = 2;
constexpr uint64_t kStep_us = 20'000;
constexpr uint32_t kAutotune = 8;
constexpr uint16_t kAutoSwitch_us = 1300, kFbwaSwitch_us = 1425;

constexpr double kRunway_deg = 340;

// A runway lies as it does; who throws an airplane turns into the wind.
double departureHeading_deg(const Scenario& scenario) {
    const bool thrown = loadAirplane(scenario.airplane).launch.speed_mps > 0;
    return thrown && scenario.wind_mps > 0 ? scenario.wind_from_deg : kRunway_deg;
}

WorldOptions worldOf(const Scenario& scenario) {
    WorldOptions world;
    const WaypointItem& home = scenario.mission[0];
    world.airplane = scenario.airplane;
    world.latitude_deg = home.latitude_deg;
    world.longitude_deg = home.longitude_deg;
    world.altitude_m = home.altitude_m;
    world.heading_deg = departureHeading_deg(scenario);
    world.wind_mps = scenario.wind_mps;
    world.wind_from_deg = scenario.wind_from_deg;
    world.gusts = scenario.gusts;
    world.seed = scenario.seed;
    const Conditions& drawn = scenario.conditions;
    world.gps_latency_s = drawn.gps_latency_s;
    world.board_warmth_c = drawn.board_warmth_c;
    world.board_warmth_start_c = drawn.board_warmth_start_c;
    world.band_gap_v = drawn.band_gap_v;
    world.worn_cells = static_cast<unsigned>(drawn.worn_cells);
    world.bootloader = static_cast<Bootloader>(drawn.bootloader);
    world.declination_deg = drawn.declination_deg;
    world.inclination_deg = drawn.inclination_deg;
    world.magnetic_field_mg = drawn.magnetic_field_mg;
    for (const Event& event : scenario.events) {
        if (event.kind() != "fault") continue;
        const double to_s = event.at_s + std::stod(event.words[2]);
        const auto fault = parseFault(event.words[1] + "@" + std::to_string(event.at_s) + "-" +
                                      std::to_string(to_s));
        if (!fault) throw ScenarioError("no such fault: " + event.words[1]);
        world.faults.push_back(*fault);
    }
    return world;
}

ParameterSettings parametersOf(const Scenario& scenario) {
    const std::filesystem::path beside =
        std::filesystem::path(airplanePath(scenario.airplane)).replace_extension(".param");
    ParameterSettings settings =
        std::filesystem::exists(beside) ? readParameterFile(beside) : ParameterSettings{};
    settings.push_back({"FLTMODE2", 10});  // AUTO, where kAutoSwitch_us is
    if (scenario.conditions.tube == 0) settings.push_back({"ARSPD_USE", 0});
    if (scenario.fence.given()) {
        settings.push_back({"FENCE_ACTION", 1});
        settings.push_back({"FENCE_AUTOENABLE", 1});
        settings.push_back({"FENCE_MAXALT", 120});
    }
    return settings;
}

MissionFile filesOf(const Scenario& scenario) {
    MissionFile files;
    files.items = scenario.mission;
    files.fence = scenario.fence;
    return files;
}

bool has(const Scenario& scenario, std::initializer_list<const char*> kinds) {
    return std::any_of(scenario.events.begin(), scenario.events.end(), [&](const Event& event) {
        return std::find(kinds.begin(), kinds.end(), event.kind()) != kinds.end();
    });
}

class ChaosFlight {
public:
    ChaosFlight(const Scenario& scenario, const std::string& firmware, bool talks)
        : scenario_(scenario),
          drill_(makeDrill(firmware, worldOf(scenario))),
          board_(drill_->board()),
          script_(board_, kTelemetry, filesOf(scenario), 1e6, parametersOf(scenario)),
          station_(board_, kTelemetry),
          reader_(board_, kTelemetry,
                  [this](const mavlink::Frame& frame, uint64_t) { answers(frame); }),
          talks_(talks) {
        board_.listen([this](int usart, uint8_t byte, uint64_t time_us) {
            if (usart != kTelemetry) return;
            script_.receive(byte, time_us);
            reader_.receive(byte, time_us);
        });
        switchTransmitterOn(board_.world());
        excuse();
    }

    Outcome fly() {
        while (now_s() < scenario_.seconds && goesOn()) {
            while (next_ < scenario_.events.size() && scenario_.events[next_].at_s <= now_s())
                happen(scenario_.events[next_++]);
            step();
        }
        lookAfterwards();
        Outcome outcome;
        outcome.violations = board_.violations();
        for (const auto& own : own_) outcome.violations.push_back(own);
        outcome.emulated_s = now_s();
        outcome.airborne = script_.airborne_s().has_value();
        outcome.crashed = crashed_;
        return outcome;
    }

private:
    double now_s() { return static_cast<double>(board_.time_us()) * 1e-6; }
    void violated(const char* name, const std::string& numbers) {
        own_.push_back({now_s(), name, numbers});
    }

    // What was changed by parameters, commands and frames of any kind moves surfaces otherwise, and
    // what is measured counts otherwise.
    void excuse() {
        if (has(scenario_, {"param", "frame", "command"})) {
            board_.watch().excuse("surface_at_its_stop");
            board_.watch().excuse("surface_swings");
            board_.watch().excuse("standing_report");
        }
    }

    // Until it lies where it crashed, or stands after its landing.
    bool goesOn() {
        constexpr double kAfterwards_s = 5;
        const Truth& truth = board_.world().truth();
        if (truth.crashed && !crashed_) {
            crashed_ = true;
            if (promisesToSurvive(scenario_) && !lands())
                violated("crashed", "in mode " + modeName(script_.telemetry().mode()));
        }
        const bool over = crashed_ || (script_.airborne_s() && script_.landed_s() &&
                                       !script_.telemetry().armed());
        if (!over) over_s_ = now_s();
        return alive_ && now_s() - over_s_ < kAfterwards_s;
    }
    // A landing with a fault may be a hard one.
    bool lands() const {
        const auto item = static_cast<size_t>(script_.telemetry().current());
        return item < scenario_.mission.size() &&
               scenario_.mission[item].command == mavlink::MavCmd::nav_land;
    }

    void step() {
        if (!board_.runUntil((board_.time_us() / kStep_us + 1) * kStep_us)) {
            alive_ = false;
            violated("board_stopped", board_.fault());
            return;
        }
        if (!script_.over() && now_s() >= scenario_.begins_s) script_.step(board_.time_us());
        if (talks_) talk();
        tuned_ = tuned_ || script_.telemetry().mode() == kAutotune;
        if (!switched_ && script_.airborne_s()) switchTo(kAutoSwitch_us);
    }

    // A line a second, and every text.
    void talk() {
        const Telemetry& telemetry = script_.telemetry();
        for (; shown_ < telemetry.texts.size(); ++shown_)
            std::printf("%8.2f s  said: %s\n", telemetry.texts[shown_].time_s,
                        telemetry.texts[shown_].text.c_str());
        if (now_s() < talked_s_ + 1) return;
        talked_s_ = now_s();
        const Truth& truth = board_.world().truth();
        std::printf(
            "%8.2f s  %-9s %s item %d, %.0f m, reported %.0f m, %.1f m/s, bank %.0f, "
            "pitch %.0f, servos",
            talked_s_, modeName(telemetry.mode()).c_str(), telemetry.armed() ? "armed" : "disarmed",
            telemetry.current(), truth.height_m, reportedHeight_m(), truth.airspeed_mps,
            truth.roll_rad / invariants::kDegree, truth.pitch_rad / invariants::kDegree);
        for (int i = 1; i <= 4; ++i) std::printf(" %.0f", board_.world().servoPulse_us(i));
        std::printf("\n");
    }

    // What the board reports, above the field, as the truth is printed.
    double reportedHeight_m() {
        const auto& position = board_.watch().history().position();
        return position ? position->alt * 0.001 - scenario_.mission[0].altitude_m : 0;
    }

    // The pilot puts the switch where the mission is flown, once it flies.
    void switchTo(uint16_t us) {
        switched_ = true;
        sticks_[7] = us;
        put();
    }
    void put() { board_.world().radio().sticks(sticks_, transmits_); }

    void happen(const Event& event) {
        const auto& words = event.words;
        if (talks_) std::printf("%8.2f s  %s\n", now_s(), textOf(event).c_str());
        if (EventStation::sends(event)) return station_.send(event);
        if (event.kind() == "restart") restart(words[1]);
        if (event.kind() == "usb") board_.setUsb(words[1] == "on");
        if (event.kind() == "transmitter") transmits_ = words[1] == "on", put();
        if (event.kind() == "switch") switchTo(static_cast<uint16_t>(std::stoi(words[1])));
        if (event.kind() == "sticks") {
            for (size_t i = 0; i < 4; ++i)
                sticks_[i] = static_cast<uint16_t>(std::stoi(words[i + 1]));
            put();
        }
    }
    void restart(const std::string& how) {
        board_.watch().provokedRestart(how != "button");
        drill_->restart(how);
    }

    // ---- when all is over
    void run(double seconds) {
        const double end_s = now_s() + seconds;
        while (alive_ && now_s() < end_s) step();
    }
    bool listens() {
        constexpr double kHeartbeats_s = 5;
        run(kHeartbeats_s);
        return alive_ && now_s() - board_.watch().history().heard().time_s < kHeartbeats_s - 1;
    }
    void lookAfterwards() {
        script_.stop("over");
        if (!alive_) return;
        if (!listens()) return violated("board_silent", "no heartbeat at the end");
        restartOnTheGround();
        readBack();
    }
    // After the flight it stays disarmed, whatever restarts it.
    void restartOnTheGround() {
        if (!board_.world().truth().on_ground || script_.telemetry().armed()) return;
        restart(scenario_.seed % 2 == 0 ? "watchdog" : "brown_out");
        run(3);
    }
    // What was set and acknowledged, from the memory that a restart leaves.
    void readBack();
    void answers(const mavlink::Frame& frame) {
        if (const auto value = as<mavlink::ParamValue>(frame))
            read_[{value->param_id, strnlen(value->param_id, sizeof value->param_id)}] =
                value->param_value;
    }
    bool ask(const std::string& name);
    // Where one cell is worn its bit is mended. Several are more than a check of four bytes can
    // mend: then the board says so at the start, and does not arm.
    // In the cells that say whose the memory is, too: then nothing is stored.
    bool saysMemoryIsWorn(double since_s) {
        const auto said = [&](const char* text) {
            return board_.watch().history().saidWithin(text, since_s, now_s());
        };
        return scenario_.conditions.worn_cells > 1 &&
               (said("Memory fault: check all") || said("EEPROM belongs to other firmware"));
    }

    const Scenario& scenario_;
    const std::unique_ptr<Drill> drill_;
    WatchedBoard board_;
    ScriptedFlight script_;
    EventStation station_;
    Link reader_;
    const bool talks_;
    std::array<uint16_t, PpmEncoder::kChannels> sticks_ = {1500, 1500, 1100, 1500,
                                                           1500, 1500, 1500, kFbwaSwitch_us};
    bool transmits_ = true, switched_ = false, alive_ = true, crashed_ = false;
    size_t next_ = 0;
    double over_s_ = 0, talked_s_ = 0;
    size_t shown_ = 0;
    bool tuned_ = false;
    std::map<std::string, float> read_;
    std::vector<invariants::Violation> own_;
};

bool ChaosFlight::ask(const std::string& name) {
    mavlink::ParamRequestRead request{};
    request.param_index = -1;
    request.target_system = 1;
    request.target_component = 1;
    name.copy(request.param_id, sizeof request.param_id);
    read_.erase(name);
    for (int tries = 0; tries < 5 && read_.count(name) == 0; ++tries) {
        reader_.send(request);
        for (int i = 0; i < 25 && read_.count(name) == 0; ++i) step();
    }
    return read_.count(name) != 0;
}

void ChaosFlight::readBack() {
    // by these the board changes what was set itself: it learns, counts or calibrates
    constexpr const char* kChanges[] = {"COMPASS_OFS", "COMPASS_MOT", "COMPASS_DEC",  "SYS_NUM",
                                        "INS_",        "GND_",        "ARSPD_OFFSET", "MIS_TOTAL",
                                        "FENCE_TOTAL", "RALLY_TOTAL"};
    const auto set = board_.watch().history().parametersSet();
    if (set.empty() || has(scenario_, {"frame", "restart", "command"})) return;
    constexpr double kWritten_s = 4;
    run(kWritten_s);
    const double restarted_s = now_s();
    restart("button");
    if (!listens()) return violated("board_silent", "no heartbeat after a restart");
    for (const auto& [name, value] : set) {
        if (std::any_of(std::begin(kChanges), std::end(kChanges),
                        [&n = name](const char* begins) { return n.rfind(begins, 0) == 0; }))
            continue;
        if (tuned_ && name.find("2SRV_") != name.npos) continue;
        if (!ask(name)) return violated("write_lost", name + " is not answered");
        if (read_[name] != value && !saysMemoryIsWorn(restarted_s))
            return violated("write_lost",
                            invariants::text("%s was set to %.9g and is %.9g", name.c_str(),
                                             double(value), double(read_[name])));
    }
}

}  // namespace

bool Outcome::violates(const std::string& name) const {
    return std::any_of(violations.begin(), violations.end(),
                       [&](const auto& each) { return each.name == name; });
}

Outcome flyScenario(const Scenario& scenario, const std::string& firmware, bool talks) {
    return ChaosFlight(scenario, firmware, talks).fly();
}

}  // namespace simulator::chaos
