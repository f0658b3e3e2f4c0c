// SPDX-License-Identifier: GPL-3.0-or-later
// Flights of a mission in wind during which sensors fail, alone or in pairs, and come back. Fails
// when the airplane does not stay in the air and in hand, when nothing reports what
// docs/failsafes.md says, or when the mission is not flown on afterwards. Without an inertial
// sensor a pilot flies, who sees the airplane. Natively each flight has a process of its own.
//   fault_flight native MISSION singles|pairs|SENSOR:HOW...
//   fault_flight apm2|apm1 FIRMWARE MISSION MINUTES SENSOR:HOW...
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <stdexcept>

#include "host_tests/scenarios/flight_report.hpp"
#include "simulator/devices/ppm_encoder.hpp"
#include "simulator/invariants/watched_board.hpp"
#include "simulator/machine/apm2_board.hpp"
#include "simulator/native/native_board.hpp"

using namespace simulator;
namespace fs = std::filesystem;

namespace {

constexpr uint64_t kStep_us = 20'000;
constexpr double kFrom_s = 42, kTo_s = 72, kJumpTo_s = 56,
                 kDriftTo_s = 102;  // of the faults, since power-on
constexpr double kAgain_s = 20;     // by then everything is as before
constexpr uint32_t kModeManual = 0, kModeCircle = 1;
constexpr double kDegree = M_PI / 180;

struct Expected {
    Faulty sensor;
    const char* begins;  // the text
    const char* ends;
};
constexpr Expected kExpected[] = {
    {Faulty::imu, "Inertial sensor lost", "Inertial back"},
    {Faulty::barometer, "Barometer lost", "Barometer back"},
    {Faulty::airspeed, "Airspeed lost", "Airspeed back"},
    {Faulty::compass, "Compass lost", "Compass back"},
    {Faulty::gps, "GPS lost", "GPS back"},
};

using Faults = std::vector<Fault>;

bool has(const Faults& faults, Faulty sensor) {
    return std::any_of(faults.begin(), faults.end(),
                       [&](const Fault& fault) { return fault.sensor == sensor; });
}

// The compass and the fixes stand in for the gyro of yaw, and take back what the others drift.
bool leavesAttitude(const Fault& fault) {
    return fault.sensor == Faulty::imu &&
           (fault.kind == FaultKind::drift || fault.kind == FaultKind::dead_yaw);
}
bool needsPilot(const Faults& faults) {
    return std::any_of(faults.begin(), faults.end(), [](const Fault& fault) {
        return fault.sensor == Faulty::imu && !leavesAttitude(fault);
    });
}

std::string nameOf(const Faults& faults) {
    std::string name;
    for (const Fault& fault : faults)
        name += (name.empty() ? "" : " ") + std::string(nameOf(fault.sensor)) + ":" +
                nameOf(fault.kind);
    return name;
}

class FaultFlight {
public:
    FaultFlight(Board& board, int telemetry, const Waypoints& items, const Faults& faults)
        : faults_(faults), board_(board), flight_(board, telemetry, items, 900) {
        board_.listen([this, telemetry](int usart, uint8_t byte, uint64_t at_us) {
            if (usart == telemetry) flight_.receive(byte, at_us);
        });
        board_.setUsb(false);
        switchTransmitterOn(board_.world());
        for (const Fault& fault : faults) over_s_ = std::max(over_s_, fault.to_s);
    }

    // Nothing when all is well.
    std::string fly() {
        const double end_s = over_s_ + kAgain_s;
        for (uint64_t step = 1; !flight_.over() && seconds() < end_s; ++step) {
            if (!board_.runUntil(step * kStep_us)) flight_.stop(board_.fault());
            flight_.step(board_.time_us());
            if (flight_.telemetry().mode() == kModeManual && seconds() > kFrom_s) steer();
            watch();
        }
        return check();
    }

    double seconds() const { return static_cast<double>(board_.time_us()) * 1e-6; }
    const ScriptedFlight& flight() const { return flight_; }

private:
    // Wings level at the height where he took over.
    void steer() {
        const Truth& t = board_.world().truth();
        if (seconds() - steered_s_ > 1) height_m_ = std::max(60.0, t.height_m);
        steered_s_ = seconds();
        const auto pull = [](double wanted, double is, double gain) {
            return static_cast<int>(std::clamp((wanted - is) * gain, -300.0, 300.0));
        };
        const double climb_rad = std::clamp((height_m_ - t.height_m) * 0.01, -0.1, 0.15);
        const int roll = pull(0, t.roll_rad + 0.3 * t.roll_rate_rads, 350);
        const int pitch = pull(climb_rad + 0.03, t.pitch_rad + 0.3 * t.pitch_rate_rads, 500);
        const auto us = [](int by) { return static_cast<uint16_t>(1500 + by); };
        board_.world().radio().sticks({us(roll), us(pitch), us(40), 1500, 1500, 1500, 1500, 1425},
                                      true);
    }

    void watch() {
        const Truth& t = board_.world().truth();
        if (seconds() < kFrom_s) return;
        lowest_m_ = std::min(lowest_m_, t.height_m);
        highest_m_ = std::max(highest_m_, t.height_m);
        max_bank_deg_ = std::max(max_bank_deg_, std::abs(t.roll_rad) / kDegree);
        circled_ = circled_ || flight_.telemetry().mode() == kModeCircle;
        manual_ = manual_ || flight_.telemetry().mode() == kModeManual;
    }

    bool reported(const std::string& text) const {
        const auto& texts = flight_.telemetry().texts;
        return std::any_of(texts.begin(), texts.end(), [&](const Event& each) {
            return each.text.find(text) != each.text.npos;
        });
    }

    std::string check() const {
        char text[160];
        if (!flight_.reason().empty()) return flight_.reason();
        std::snprintf(text, sizeof text, "height %.0f to %.0f m, bank up to %.0f deg", lowest_m_,
                      highest_m_, max_bank_deg_);
        // an airplane that turns over while nobody knows is still in hand when it is caught
        const double max_deg = needsPilot(faults_) ? 100 : 65;
        if (lowest_m_ < 20 || highest_m_ > 180 || max_bank_deg_ > max_deg) return text;
        for (const Expected& each : kExpected) {
            if (!has(faults_, each.sensor) || isJumpOfGps()) continue;
            if (each.sensor == Faulty::imu && !needsPilot(faults_)) continue;
            if (each.sensor == Faulty::compass && isDriftOf(Faulty::compass)) continue;
            if (!reported(each.begins)) return std::string("not reported: ") + each.begins;
            if (!isDriftOf(each.sensor) && !reported(each.ends))
                return std::string("not reported: ") + each.ends;
        }
        if (isJumpOfGps() && !reported("GPS jump refused")) return "the jump was not refused";
        if (manual_ != needsPilot(faults_)) return manual_ ? "MANUAL" : "no MANUAL";
        if (has(faults_, Faulty::gps) && !isJumpOfGps() && !manual_ && !circled_)
            return "no CIRCLE";
        if (flight_.telemetry().mode() != kModeAuto) return "AUTO was not gone back to";
        return "";
    }
    // Believable at any moment: a compass is followed, others are trusted again when they can be.
    bool isDriftOf(Faulty sensor) const {
        return std::any_of(faults_.begin(), faults_.end(), [sensor](const Fault& fault) {
            return fault.sensor == sensor && fault.kind == FaultKind::drift;
        });
    }
    bool isJumpOfGps() const {
        return std::any_of(faults_.begin(), faults_.end(), [](const Fault& fault) {
            return fault.sensor == Faulty::gps && fault.kind == FaultKind::jump;
        });
    }

    const Faults faults_;
    Board& board_;
    ScriptedFlight flight_;
    double over_s_ = 0, steered_s_ = -10, height_m_ = 0;
    double lowest_m_ = 1e9, highest_m_ = 0, max_bank_deg_ = 0;
    bool circled_ = false, manual_ = false;
};

Fault faultOf(Faulty sensor, FaultKind kind) {
    const double to_s = kind == FaultKind::jump    ? kJumpTo_s
                        : kind == FaultKind::drift ? kDriftTo_s
                                                   : kTo_s;
    return {sensor, kind, kFrom_s, to_s};
}

std::vector<Faults> singles() {
    std::vector<Faults> all;
    for (const Expected& each : kExpected)
        for (int kind = 1; kind < kFaultKinds; ++kind)
            if (canFail(each.sensor, static_cast<FaultKind>(kind)) &&
                (each.sensor != Faulty::imu || static_cast<FaultKind>(kind) != FaultKind::jump))
                all.push_back({faultOf(each.sensor, static_cast<FaultKind>(kind))});
    return all;
}

std::vector<Faults> pairs() {
    constexpr FaultKind kKinds[] = {FaultKind::lost, FaultKind::stuck, FaultKind::noisy,
                                    FaultKind::nonsense};
    std::vector<Faults> all;
    for (const Expected& one : kExpected)
        for (const Expected* other = &one + 1; other != std::end(kExpected); ++other)
            for (FaultKind a : kKinds)
                for (FaultKind b : kKinds)
                    all.push_back({faultOf(one.sensor, a), faultOf(other->sensor, b)});
    return all;
}

WorldOptions worldOf(const Waypoints& items, const Faults& faults) {
    WorldOptions world = worldAt(items, 4, 320);
    world.gusts = true;
    world.seed = 7;
    world.faults = faults;
    return world;
}

bool flyAndTell(Board& board, int telemetry, const Waypoints& items, const Faults& faults,
                double& seconds) {
    WatchedBoard watched(board);
    FaultFlight flight(watched, telemetry, items, faults);
    std::string why = flight.fly();
    if (why.empty() && !watched.held()) why = "an invariant was violated";
    seconds = flight.seconds();
    std::printf("%s  %s%s%s\n", why.empty() ? "ok    " : "FAILED", nameOf(faults).c_str(),
                why.empty() ? "" : ": ", why.c_str());
    if (!why.empty()) printEvents(flight.flight());
    std::fflush(stdout);
    return why.empty();
}

int flyNatively(const Waypoints& items, const std::vector<Faults>& flights) {
    constexpr int kAtOnce = 2;
    int failed = 0, running = 0;
    const auto wait = [&] {
        int status = 0;
        ::wait(&status);
        --running;
        failed += status != 0;
    };
    for (const Faults& faults : flights) {
        if (running == kAtOnce) wait();
        ++running;
        if (fork() != 0) continue;
        NativeBoard board(worldOf(items, faults));
        double seconds;
        _exit(flyAndTell(board, kApm2Wiring.telemetry_usart, items, faults, seconds) ? 0 : 1);
    }
    while (running > 0) wait();
    std::printf("%zu flights, %d failed\n", flights.size(), failed);
    return failed == 0 ? 0 : 1;
}

int flyImage(const std::string& name, const std::string& firmware, const Waypoints& items,
             const Faults& faults, const fs::path& minutes) {
    const BoardWiring& wiring = name == "apm1" ? kApm1Wiring : kApm2Wiring;
    AvrBoard board(firmware, worldOf(items, faults), wiring);
    double seconds = 0;
    const bool well = flyAndTell(board, wiring.telemetry_usart, items, faults, seconds);
    std::string file = "fault_" + name + "_" + nameOf(faults);
    std::replace(file.begin(), file.end(), ' ', '_');
    writeMinutes(minutes / file, seconds / 60);
    return say(board.figures().frame_overruns == 0u, "no frame was late") && well ? 0 : 1;
}

Faults parseFaults(char** words, char** end) {
    Faults faults;
    for (; words < end; ++words) {
        const auto fault = parseFault(std::string(*words) + "@1");
        if (!fault) throw std::invalid_argument(std::string("not a fault: ") + *words);
        faults.push_back(faultOf(fault->sensor, fault->kind));
    }
    return faults;
}

}  // namespace

int main(int count, char** words) {
    const bool native = count > 1 && std::string(words[1]) == "native";
    if (count < (native ? 4 : 6)) {
        std::cerr << "usage: fault_flight native MISSION singles|pairs|FAULT...\n"
                     "       fault_flight apm2|apm1 FIRMWARE MISSION MINUTES FAULT...\n";
        return 2;
    }
    const Waypoints items = readWaypoints(words[native ? 2 : 3]);
    if (!native)
        return flyImage(words[1], words[2], items, parseFaults(words + 5, words + count), words[4]);
    const std::string what = words[3];
    if (what == "singles") return flyNatively(items, singles());
    if (what == "pairs") return flyNatively(items, pairs());
    return flyNatively(items, {parseFaults(words + 3, words + count)});
}
