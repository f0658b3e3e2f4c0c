// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/ground/server.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "simulator/constants.hpp"
#include "simulator/devices/gps_kinds.hpp"
#include "simulator/devices/ppm_encoder.hpp"
#include "simulator/devices/supply.hpp"

namespace simulator {

using Clock = std::chrono::steady_clock;

constexpr uint64_t kStep_us = 10'000;
constexpr auto kInputWithin = std::chrono::seconds(5);

static uint16_t following(uint16_t base, int offset) {
    return base == 0 ? 0 : static_cast<uint16_t>(base + offset);
}

Server::Server(Board& board, uint16_t base, std::array<int, kLines> usarts, bool lock_step)
    : board_(board), lines_{Line(base, usarts[0]), Line(following(base, 1), usarts[1])} {
    if (lock_step) control_ = std::make_unique<TcpPort>(following(base, 2));
}

std::vector<TcpPort*> Server::ports() {
    std::vector<TcpPort*> all = {&lines_[0].tcp, &lines_[1].tcp};
    if (control_) all.push_back(control_.get());
    return all;
}

void Server::fromBoard(int usart, uint8_t byte) {
    for (Line& line : lines_) {
        if (line.usart == usart) line.from_board.push_back(byte);
    }
}

void Server::takeInput() {
    for (Line& line : lines_) {
        const auto bytes = line.tcp.receive();
        line.in += bytes.size();
        if (!bytes.empty()) board_.send(line.usart, bytes.data(), bytes.size());
    }
}

void Server::giveOutput() {
    for (Line& line : lines_) {
        line.out += line.from_board.size();
        line.tcp.send(line.from_board.data(), line.from_board.size());
        line.from_board.clear();
    }
}

bool Server::advance(uint64_t until_us) {
    bool goes_on = true;
    while (goes_on && !stop_() && board_.time_us() < until_us) {
        goes_on = board_.runUntil(std::min(board_.time_us() + kStep_us, until_us));
    }
    giveOutput();
    return goes_on;
}

void Server::run(const std::function<bool(uint64_t)>& await, const std::function<void()>& stepped) {
    for (uint64_t until_us = board_.time_us() + kStep_us; await(until_us); until_us += kStep_us) {
        takeInput();
        if (!advance(until_us)) return;
        stepped();
    }
}

void Server::runLockStep(const std::function<bool()>& stop) {
    stop_ = stop;  // an hour may be granted at once
    granted_us_ = board_.time_us();
    while (!stop() && board_.fault().empty()) {
        TcpPort::waitForInput({control_.get()}, 200);
        for (const uint8_t byte : control_->receive()) {
            if (byte != '\n') {
                command_ += static_cast<char>(byte);
                continue;
            }
            control_->send(answer(command_) + "\n");
            command_.clear();
        }
    }
}

std::string Server::answer(const std::string& line) {
    std::istringstream words(line);
    std::string verb, rest;
    words >> verb;
    std::getline(words, rest);
    while (!rest.empty() && (rest.back() == '\r' || rest.back() == ' ')) rest.pop_back();
    if (verb == "advance") return answerAdvance(rest);
    if (verb == "state" && rest.empty()) return truthJson(board_.world().truth());
    if (verb == "sticks") return answerSticks(rest);
    if (verb == "usb" && (rest == " in" || rest == " out")) {
        board_.setUsb(rest == " in");
        return "ok";
    }
    if (verb == "launch" && rest.empty()) {
        board_.world().launch();
        return "ok";
    }
    if (verb == "servos" && rest.empty()) return answerServos();
    if (verb == "load" && rest.empty()) return answerLoad();
    if (verb == "reset" && rest.empty()) {
        board_.reset();
        return "ok";
    }
    if (verb == "fault") return answerFault(rest);
    if (verb == "gps") return answerGps(rest);
    if (verb == "flash") return answerFlash(rest);
    return answerHands(verb, rest);
}

std::string Server::answerServos() {
    auto widths = nlohmann::json::array();
    for (int output = 1; output <= 8; ++output)
        widths.push_back(board_.world().servoPulse_us(output));
    return widths.dump();
}

std::string Server::answerLoad() {
    const auto load = board_.figures().cpu_load;
    return load ? std::to_string(*load) : "error: the natively compiled board has none";
}

std::string Server::answerFault(const std::string& rest) {
    World& world = board_.world();
    if (rest == " none") {
        world.setFaults({});
        return "ok";
    }
    std::istringstream words(rest);
    std::string what;
    double for_s = 0;
    words >> what >> for_s;
    const auto fault = parseFault(what + "@0");
    if (!words || !(for_s > 0) || !fault) return "error: fault takes PART:HOW SECONDS, or 'none'";
    std::vector<Fault> all = world.faults();
    all.push_back(*fault);
    all.back().from_s = static_cast<double>(board_.time_us()) * 1e-6 + 0.001;
    all.back().to_s = all.back().from_s + for_s;
    world.setFaults(all);
    if (fault->sensor != Faulty::supply) return "ok";
    // by brown-out, and again by power-on
    for (const double level_v : {least_v::kChip, least_v::kPowerOnReset})
        if (fault->volts < level_v) board_.expectRestart();
    return "ok";
}

std::string Server::answerGps(const std::string& rest) {
    std::istringstream words(rest);
    std::string kind;
    uint32_t baud = 0;
    const auto kinds = gpsKinds();
    if (!(words >> kind >> baud) || std::find(kinds.begin(), kinds.end(), kind) == kinds.end())
        return "error: gps takes KIND BAUD";
    board_.world().plugGps(kind, baud);
    return "ok";
}

std::string Server::answerFlash(const std::string& rest) {
    const size_t name = rest.find_first_not_of(' ');
    if (name == rest.npos) return "error: flash takes the FILE of an image";
    const std::string wrong = board_.flash(rest.substr(name));
    return wrong.empty() ? "ok" : "error: " + wrong;
}

std::string Server::answerSupply(double volts) {
    if (!(volts >= Supply::kLowest_v && volts <= Supply::kHighest_v))
        return "error: supply takes 4.5 to 5.5 V";
    board_.world().supply().adjust(volts);
    return "ok";
}

// What a person does with a board in the hands.
std::string Server::answerHands(const std::string& verb, const std::string& rest) {
    std::istringstream words(rest);
    double value[3];
    int count = 0;
    while (count < 3 && words >> value[count]) ++count;
    World& world = board_.world();
    if (verb == "turn-to" && count == 3)
        world.turnTo(value[0] * kRadians, value[1] * kRadians, value[2] * kRadians);
    else if (verb == "turn" && count == 3)
        world.turn(value[0] * kRadians, value[1] * kRadians, value[2] * kRadians);
    else if (verb == "lift" && count == 1)
        world.lift(value[0]);
    else if (verb == "blow" && count == 1)
        world.blow(value[0]);
    else if (verb == "supply" && count == 1)
        return answerSupply(value[0]);
    else
        return "error: expected 'advance MS [BYTES0 [BYTES1]]', 'state', 'sticks ...', "
               "'usb in|out', 'launch', 'servos', 'load', 'reset', 'fault ...', "
               "'gps KIND BAUD', "
               "'flash FILE', 'turn-to R P Y', 'turn P Q R', 'lift M', 'blow MPS' or 'supply V'";
    return "ok";
}

std::string Server::answerAdvance(const std::string& rest) {
    constexpr uint64_t kMax_ms = 3'600'000;
    std::istringstream numbers(rest);
    uint64_t grant_ms = 0;
    std::array<uint64_t, kLines> wanted{};
    if (rest.find('-') != std::string::npos || !(numbers >> grant_ms) || grant_ms > kMax_ms) {
        return "error: advance takes milliseconds, 0 to 3600000";
    }
    for (uint64_t& bytes : wanted) {
        if (!(numbers >> bytes)) break;
    }
    awaitInput(wanted);
    granted_us_ += grant_ms * 1000;
    if (!advance(granted_us_)) return "error: " + board_.fault();
    if (board_.time_us() < granted_us_) return "error: stopped";
    return "at " + std::to_string(granted_us_ / 1000) + " " + std::to_string(lines_[0].out) + " " +
           std::to_string(lines_[1].out);
}

void Server::awaitInput(const std::array<uint64_t, kLines>& wanted) {
    const auto give_up = Clock::now() + kInputWithin;
    takeInput();
    while ((lines_[0].in < wanted[0] || lines_[1].in < wanted[1]) && Clock::now() < give_up) {
        TcpPort::waitForInput({&lines_[0].tcp, &lines_[1].tcp}, 20);
        takeInput();
    }
}

std::string Server::answerSticks(const std::string& rest) {
    std::array<uint16_t, PpmEncoder::kChannels> pulses{};
    if (rest == " off") {
        board_.world().radio().sticks(pulses, false);
        return "ok";
    }
    std::istringstream numbers(rest);
    for (uint16_t& pulse : pulses) {
        if (!(numbers >> pulse) || pulse < 800 || pulse > 2200) {
            return "error: sticks takes eight pulses of 800 to 2200 us, or 'off'";
        }
    }
    board_.world().radio().sticks(pulses, true);
    return "ok";
}

std::string truthJson(const Truth& truth) {
    return nlohmann::ordered_json({{"time_us", truth.time_us},
                                   {"latitude_deg", truth.latitude_deg},
                                   {"longitude_deg", truth.longitude_deg},
                                   {"altitude_m", truth.altitude_m},
                                   {"height_m", truth.height_m},
                                   {"north_m", truth.north_m},
                                   {"east_m", truth.east_m},
                                   {"velocity_north_mps", truth.velocity_north_mps},
                                   {"velocity_east_mps", truth.velocity_east_mps},
                                   {"velocity_down_mps", truth.velocity_down_mps},
                                   {"roll_rad", truth.roll_rad},
                                   {"pitch_rad", truth.pitch_rad},
                                   {"yaw_rad", truth.yaw_rad},
                                   {"airspeed_mps", truth.airspeed_mps},
                                   {"throttle", truth.throttle},
                                   {"on_ground", truth.on_ground},
                                   {"crashed", truth.crashed}})
        .dump();
}

}  // namespace simulator
