// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/drawn/tuning.hpp"

#include <algorithm>
#include <cstring>

#include "simulator/devices/ppm_encoder.hpp"

namespace simulator::drawn {
namespace {

constexpr uint64_t kStep_us = 20'000;
constexpr double kLimit_s = 900, kClimbs_s = 25, kAnswer_s = 0.4;
constexpr float kAutotune = 8;
constexpr const char* kLearnt[] = {
    "RLL2SRV_TCONST", "RLL2SRV_P",   "RLL2SRV_I",     "RLL2SRV_D",     "PTCH2SRV_TCONST",
    "PTCH2SRV_P",     "PTCH2SRV_I",  "PTCH2SRV_D",    "COMPASS_OFS_X", "COMPASS_OFS_Y",
    "COMPASS_OFS_Z",  "ARSPD_RATIO", "COMPASS_MOT_X", "COMPASS_MOT_Y", "COMPASS_MOT_Z"};

template <class Message>
Message to(uint8_t system, const std::string& parameter) {
    Message message{};
    message.target_system = system;
    message.target_component = 1;
    std::memcpy(message.param_id, parameter.data(),
                std::min(parameter.size(), sizeof message.param_id));
    return message;
}

double cruiseOf(const ParameterSettings& settings) {
    constexpr double kDefault_mps = 13;
    for (const ParameterSetting& each : settings)
        if (each.name == "TRIM_ARSPD_CM") return each.value / 100;
    return kDefault_mps;
}

}  // namespace

Tuning::Tuning(WatchedBoard& board, const Waypoints& items, const ParameterSettings& settings)
    : board_(board),
      pilot_(cruiseOf(settings)),
      flight_(board, kTelemetry, items, kLimit_s, settings),
      usb_(board, kUsb, [this](const mavlink::Frame& frame, uint64_t) {
          if (const auto value = as<mavlink::ParamValue>(frame))
              answers_.push_back({std::string(value->param_id, strnlen(value->param_id, 16)),
                                  double{value->param_value}});
      }) {
    board_.listen([this](int usart, uint8_t byte, uint64_t at_us) {
        if (usart == kTelemetry) flight_.receive(byte, at_us);
        if (usart == kUsb) usb_.receive(byte, at_us);
    });
    board_.setUsb(true);
    switchTransmitterOn(board_.world());
}

bool Tuning::advance() {
    if (!board_.runUntil(board_.time_us() + kStep_us)) flight_.stop(board_.fault());
    if (board_.world().truth().crashed) flight_.stop("the airplane crashed");
    flight_.step(board_.time_us());
    return !flight_.over();
}

bool Tuning::advanceFor(double seconds, const std::function<void(double)>& each) {
    const uint64_t begun_us = board_.time_us();
    for (double since_s = 0; since_s < seconds;) {
        each(since_s);
        if (!advance()) return false;
        since_s = static_cast<double>(board_.time_us() - begun_us) * 1e-6;
    }
    return true;
}

void Tuning::chooseAutotune() {
    auto set = to<mavlink::ParamSet>(flight_.telemetry().system, "FLTMODE1");
    set.param_value = kAutotune;
    set.param_type = mavlink::MavParamType::real32;
    usb_.send(set);
}

std::string Tuning::fly() {
    while (!flight_.airborne_s() && advance()) {
    }
    const auto watch = [](double) {};
    if (!flight_.over() && advanceFor(kClimbs_s, watch)) {
        chooseAutotune();
        advanceFor(kAnswer_s, watch);
        advanceFor(kTuneAll_s, [this](double since_s) {
            board_.world().radio().sticks(pilot_.sticks(since_s, board_.world().truth()), true);
        });
    }
    if (flight_.over()) return flight_.completed() ? "it landed" : flight_.reason();
    return "";
}

ParameterSettings Tuning::found() {
    ParameterSettings found;
    for (const char* name : kLearnt) {
        auto ask = to<mavlink::ParamRequestRead>(flight_.telemetry().system, name);
        ask.param_index = -1;
        answers_.clear();
        usb_.send(ask);
        advanceFor(kAnswer_s, [](double) {});
        for (const ParameterSetting& each : answers_)
            if (each.name == name) {
                found.push_back(each);
                break;
            }
    }
    return found;
}

}  // namespace simulator::drawn
