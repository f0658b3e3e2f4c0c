// SPDX-License-Identifier: GPL-3.0-or-later
// One flight of the image over every CONDITION and DO of a set. Compares the log of starts and
// ends with the oracle's, the pins and parameters with what the commands promise. Writes
// OUT/summary.json and adds the emulated minutes to MINUTES.
//   command_flight FIRMWARE MISSION OUT MINUTES
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>

#include "command_log.hpp"
#include "expected.hpp"
#include "firmware/mission/command_table.hpp"
#include "firmware/mission/item.hpp"
#include "host_tests/scenarios/flight_report.hpp"
#include "simulator/invariants/watched_board.hpp"
#include "simulator/machine/apm2_board.hpp"
#include "toolchain/mission_tool/load.hpp"

using namespace simulator;
namespace fs = std::filesystem;
using mission_tool::Document;

namespace {

constexpr int kTelemetry = 2, kUsb = 0;
constexpr uint64_t kStep_us = 10'000;
constexpr uint64_t kSetUp_us = 1'000'000;  // of the program: until then the sensor is being set up
constexpr double kTimeLimit_s = 360;
constexpr double kInOtherMode_s = 3;

Document read(const std::string& path) {
    mission_tool::Reading reading;
    reading.onto = mission_tool::blankImage();
    return load(mission_tool::readFile(path), path, reading);
}

// As a ground station would send them, whatever the set.
Waypoints itemsOf(const Document& document) {
    Waypoints items;
    for (size_t i = 0; i < document.entries.size(); ++i) {
        firmware::mission::MissionItem from = {};
        firmware::mission::decodeItem(document.set, static_cast<uint8_t>(i),
                                      document.entries[i].record, from);
        WaypointItem item;
        item.index = static_cast<int>(i);
        item.frame = from.frame;
        item.command = from.command;
        item.params = {from.param1, from.param2, from.param3, from.param4};
        item.latitude_deg = from.x * 1e-7;
        item.longitude_deg = from.y * 1e-7;
        item.altitude_m = from.z;
        items.push_back(item);
    }
    return items;
}

// A change of mode ends the oracle's AUTO by its own sign for one.
oracle::Mission oracleMission(const Document& document) {
    constexpr uint8_t kChangeMode = 0x30;
    oracle::Mission mission;
    for (const mission_tool::Entry& entry : document.entries) {
        mission::Record record = entry.record;
        const bool leaves = document.set == mission::Set::apm1 && record.id == kChangeMode;
        if (leaves && record.p1 != kModeAuto) record.p1 = oracle::kLeavesAuto;
        mission.emplace_back();
        mission::pack(document.set, record, mission.back().data());
    }
    return mission;
}

class CommandFlight {
public:
    CommandFlight(const std::string& firmware, const Document& document)
        : document_(document),
          items_(itemsOf(document)),
          board_(firmware, worldAt(items_)),
          watched_(board_),
          flight_(watched_, kTelemetry, items_, kTimeLimit_s, settingsOf(document.set)),
          usb_(watched_, kUsb, [this](const mavlink::Frame& f, uint64_t) { take(f, kUsbSent); }),
          telemetry_(watched_, kTelemetry,
                     [this](const mavlink::Frame& f, uint64_t) { take(f, kTelemetrySent); }) {
        watched_.listen(
            [this](int usart, uint8_t byte, uint64_t at_us) { hear(usart, byte, at_us); });
        // whose commands are numbered otherwise than MAVLink's
        if (document.set == mission::Set::apm1)
            for (const char* of_missions : {"mission_jump", "mode_without_cause"})
                watched_.watch().excuse(of_missions);
        watchMarks();
        board_.setUsb(true);
        switchTransmitterOn(board_.world());
    }

    void fly() {
        chooseSet();
        while (!flight_.over()) {
            step();
            flight_.step(board_.time_us());
            backToAuto();
        }
        parameters_.clear();
        for (const ExpectedParameter& expected : parametersOf(document_.set)) ask(expected.name);
    }

    bool check();
    Summary summary(const std::string& firmware, const std::string& mission);
    double seconds() const { return static_cast<double>(board_.time_us()) * 1e-6; }

private:
    using Sample = std::array<float, kChannels>;

    const Telemetry& telemetry() const { return flight_.telemetry(); }

    void watchMarks() {
        const auto measure = board_.chip().on_trace;
        board_.chip().on_trace = [this, measure](uint8_t value) {
            constexpr uint16_t kGpior1 = 0x4A;
            measure(value);
            log_.mark(value, board_.chip().avr()->data[kGpior1], seconds());
        };
    }

    void hear(int usart, uint8_t byte, uint64_t at_us) {
        if (usart == kTelemetry) {
            flight_.receive(byte, at_us);
            telemetry_.receive(byte, at_us);
            ++bytes_[0];
        } else if (usart == kUsb) {
            usb_.receive(byte, at_us);
            ++bytes_[1];
        }
    }

    void take(const mavlink::Frame& frame, Channel link) {
        const auto value = as<mavlink::ParamValue>(frame);
        if (!value) return;
        const std::string name(value->param_id, strnlen(value->param_id, sizeof value->param_id));
        parameters_[name] = value->param_value;
        if (name == "WP_RADIUS") ++variable_sent_[link == kUsbSent];
    }

    void step() {
        if (!watched_.runUntil(++steps_ * kStep_us)) flight_.stop(board_.fault());
        if (board_.time_us() < board_.begun_us() + kSetUp_us)
            imu_from_ = board_.world().imu().samples();
        Sample sample;
        for (int i = 1; i <= 8; ++i)
            sample[output(i)] = static_cast<float>(board_.world().servoPulse_us(i));
        sample[kRelay] = board_.world().relayOn();
        sample[kHeight] = telemetry().position
                              ? static_cast<float>(telemetry().position->relative_alt) * 1e-3F
                              : 0;
        sent_.push_back(bytes_);
        const auto& before = sent_[sent_.size() > 100 ? sent_.size() - 101 : 0];
        sample[kTelemetryBytes] = static_cast<float>(bytes_[0] - before[0]);
        sample[kUsbBytes] = static_cast<float>(bytes_[1] - before[1]);
        sample[kTelemetrySent] = static_cast<float>(variable_sent_[0]);
        sample[kUsbSent] = static_cast<float>(variable_sent_[1]);
        samples_.push_back(sample);
    }

    // The parameter may be long in coming: the autopilot has just been switched on.
    void ask(const std::string& name) {
        for (int tries = 0; tries < 20 && parameters_.count(name) == 0; ++tries) {
            mavlink::ParamRequestRead request{};
            request.param_index = -1;
            request.target_system = 1;
            request.target_component = 1;
            std::memcpy(request.param_id, name.data(), name.size());
            usb_.send(request);
            for (int i = 0; i < 20; ++i) step();
        }
    }

    void chooseSet() {
        const auto wanted = static_cast<uint8_t>(document_.set);
        for (int tries = 0; tries < 20 && parameters_["MIS_SET"] != wanted; ++tries) {
            mavlink::ParamSet message{};
            message.param_value = wanted;
            message.target_system = 1;
            message.target_component = 1;
            std::strcpy(message.param_id, "MIS_SET");
            message.param_type = mavlink::MavParamType::real32;
            usb_.send(message);
            for (int i = 0; i < 50; ++i) step();
        }
        parameters_.clear();
        variable_sent_ = {};
    }

    void backToAuto() {
        const bool elsewhere = flight_.airborne_s() && !flight_.landed_s() &&
                               telemetry().mode() != kModeAuto && telemetry().armed();
        if (!elsewhere) {
            left_s_ = seconds();
        } else if (seconds() - left_s_ > kInOtherMode_s) {
            left_s_ = seconds();
            mavlink::CommandLong message{};
            message.command = mavlink::MavCmd::do_set_mode;
            message.param1 = mavlink::MavModeFlag::custom_mode_enabled;
            message.param2 = kModeAuto;
            message.target_system = telemetry().system;
            message.target_component = telemetry().component;
            usb_.send(message);
        }
    }

    std::string navs() const {
        std::string all;
        for (size_t i = 1; i < document_.entries.size(); ++i)
            if (document_.entries[i].is(mission::Class::nav)) all += "+" + std::to_string(i) + " ";
        return all;
    }
    bool holds(const Expected& expected) const;
    bool everyCommandRan() const;
    bool sameAsOracle() const;
    bool said(const std::string& wanted) const {
        const std::vector<Event>& texts = telemetry().texts;
        return std::any_of(texts.begin(), texts.end(),
                           [&](const Event& text) { return text.text == wanted; });
    }

    const Document& document_;
    const Waypoints items_;
    AvrBoard board_;
    WatchedBoard watched_;
    ScriptedFlight flight_;
    Link usb_, telemetry_;
    CommandLog log_;
    bool passed_ = false;
    uint64_t steps_ = 0;
    SampleCount imu_from_;
    double left_s_ = 0;
    std::array<uint64_t, 2> bytes_{};
    std::array<int, 2> variable_sent_{};
    std::vector<std::array<uint64_t, 2>> sent_;
    std::vector<Sample> samples_;
    std::map<std::string, double> parameters_;
};

bool CommandFlight::holds(const Expected& expected) const {
    const auto at_s = log_.time_s(expected.word);
    char what[160];
    if (!at_s) {
        snprintf(what, sizeof what, "%s: %s never happened", expected.what, expected.word.c_str());
        return say(false, what);
    }
    const auto index = static_cast<size_t>((*at_s + expected.after_s) * 1e6 / kStep_us);
    const double value = samples_[std::min(index, samples_.size() - 1)][expected.channel];
    snprintf(what, sizeof what, "%-40s %s%+.2f s  %.0f in %.0f..%.0f", expected.what,
             expected.word.c_str(), expected.after_s, value, expected.lowest, expected.highest);
    return say(value >= expected.lowest && value <= expected.highest, what);
}

// Jumps leave no word of their own: where they lead is the oracle's to say.
bool CommandFlight::everyCommandRan() const {
    bool all = true;
    for (uint8_t row = 0; row < firmware::mission::kCommandTable.count; ++row) {
        const uint8_t id = firmware::mission::kCommandTable.id(document_.set, row);
        const mission::Class kind = firmware::mission::kCommandTable.kind(row);
        if (id == mission::kNoId || kind == mission::Class::nav) continue;
        bool ran = false;
        for (size_t i = 1; i < document_.entries.size(); ++i) {
            if (document_.entries[i].record.id != id) continue;
            const char* letter = kind == mission::Class::condition ? "c" : "a";
            ran |= kind == mission::Class::jump || log_.time_s(letter + std::to_string(i));
        }
        if (!ran) say(false, std::string(firmware::mission::commandName(row)) + " did not run");
        all = all && ran;
    }
    return all;
}

bool CommandFlight::sameAsOracle() const {
    const bool apm1 = document_.set == mission::Set::apm1;
    const std::string said = log_.words();
    const std::string should = log_.oracles(
        apm1 ? oracle::CommandSet::apm1 : oracle::CommandSet::apm2, oracleMission(document_));
    std::printf("  engine: %s\n", said.c_str());
    if (said != should) std::printf("  oracle: %s\n", should.c_str());
    return !said.empty() && said == should;
}

bool CommandFlight::check() {
    bool passed = say(sameAsOracle(), "starts and ends of commands are the oracle's, in its order");
    passed = say(everyCommandRan(), "every CONDITION and DO of the set ran") && passed;
    for (const Expected& expected : expectedOf(document_.set)) passed = holds(expected) && passed;
    for (const ExpectedParameter& expected : parametersOf(document_.set)) {
        const auto found = parameters_.find(expected.name);
        const bool set = found != parameters_.end() &&
                         std::abs(found->second - expected.value) <= 1e-6 * expected.value;
        passed = say(set, std::string(expected.name) + " is set") && passed;
    }
    for (const std::string& text : textsOf(document_.set))
        passed = say(said(text), "it said: " + text) && passed;
    passed = say(flight_.landed_s() && !board_.world().truth().crashed, "it landed") && passed;
    passed = say(log_.navsFinished() == navs(), "every NAV was reached in its turn") && passed;
    passed = say(board_.figures().frame_overruns == 0u, "no frame was late") && passed;
    passed = say(watched_.held(), "no invariant was violated") && passed;
    passed_ = say(seconds() < kTimeLimit_s, "in six minutes") && passed;
    if (passed_) return true;
    printEvents(flight_);
    for (const CommandLog::Entry& entry : log_.entries())
        std::printf("%8.2f s  %s\n", entry.time_s, entry.word.c_str());
    return false;
}

Summary CommandFlight::summary(const std::string& firmware, const std::string& mission) {
    Summary s = summaryOf(board_, flight_, firmware);
    s.mission = fs::path(mission).filename();
    s.completed = passed_;
    const SampleCount imu = board_.world().imu().samples();
    s.setSamples({imu.made - imu_from_.made, imu.read - imu_from_.read, imu.lost - imu_from_.lost,
                  imu.repeated - imu_from_.repeated});
    return s;
}

}  // namespace

int main(int count, char** words) {
    if (count != 5) {
        std::cerr << "usage: command_flight FIRMWARE MISSION OUT MINUTES\n";
        return 2;
    }
    const fs::path out = words[3], minutes = words[4];
    emptyFolder(out);
    const Document document = read(words[2]);
    CommandFlight flight(words[1], document);
    flight.fly();
    const bool passed = flight.check();
    writeOutcome(out, minutes, flight.summary(words[1], words[2]));
    return passed ? 0 : 1;
}
