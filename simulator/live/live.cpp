// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/live/live.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "simulator/devices/ppm_encoder.hpp"
#include "simulator/ground/tcp_port.hpp"

namespace simulator::live {
namespace {

using Milliseconds = std::chrono::milliseconds;
using Do = Order::Do;

constexpr uint64_t kSample_us = 100'000;
constexpr long kRemembered_ms = 1000;
constexpr size_t kMaxHistory = 7200;  // two hours; of a longer flight every other one goes
constexpr Milliseconds kPoll{2}, kMaxWait{20}, kStatus{1000};
constexpr double kForEver_s = 1e9;

std::unique_ptr<HttpServer> openServer(const LiveOptions& options) {
    if (!options.http_port) return nullptr;
    try {
        return std::make_unique<HttpServer>(*options.http_port);
    } catch (const TcpError&) {
        if (!options.any_port) throw;
        return std::make_unique<HttpServer>(static_cast<uint16_t>(0));
    }
}

std::string eventText(const char* name, const std::string& json) {
    return std::string("event: ") + name + "\ndata: " + json + "\n\n";
}

}  // namespace

Live::Live(Board& board, const LiveOptions& options)
    : board_(board), options_(options), station_(board, options.usart), http_(openServer(options)) {
    clock_.setSpeed(options.speed, FlightClock::Clock::now(), board.time_us());
    station_.on_text = [this](const mavlink::Statustext& text, uint64_t time_us) {
        chronicle_.text(std::string(text.text, strnlen(text.text, sizeof text.text)), text.severity,
                        static_cast<double>(time_us) * 1e-6);
    };
    chronicle_.on_event = [this](const ChronicleEvent& event) {
        announce("event", dumped(eventJson(event)));
        sayEvent(event);
    };
    chronicle_.on_band = [this](const Band& band) { announce("band", dumped(bandJson(band))); };
    if (!http_) return;
    http_->on_request = [this](HttpServer::Client client, const Request& request) {
        serve(client, request);
    };
}

void Live::sayEvent(const ChronicleEvent& event) {
    if (event.kind == "item") return;
    char time[32];
    std::snprintf(time, sizeof time, "%8.1f s  ", event.time_s);
    std::string text = event.text;  // another firmware's could move the terminal's cursor
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
    options_.say(std::string(time) + (event.kind == "mode" ? "mode " : "") + text);
}

void Live::receive(int usart, uint8_t byte, uint64_t time_us) {
    if (usart == station_.usart()) return station_.receive(byte, time_us);
    for (bool whole = others_.put(byte); whole; whole = others_.next())
        station_.overhear(others_.frame());
}

bool Live::awaitStep(uint64_t until_us, const std::function<bool()>& stop) {
    for (;;) {
        if (stop()) return false;
        const auto now = FlightClock::Clock::now();
        const auto wait = clock_.wait(now, until_us);
        const auto rest = wait ? std::chrono::duration_cast<Milliseconds>(*wait) : kMaxWait;
        const bool due = wait && *wait == FlightClock::Clock::duration::zero();
        if (due && now - polled_ < kPoll) return true;
        // the last part of a millisecond is waited for without sleeping
        poll(due ? Milliseconds(0) : std::clamp(rest, Milliseconds(0), kMaxWait));
        if (due) return true;
    }
}

void Live::poll(Milliseconds wait) {
    polled_ = FlightClock::Clock::now();
    announceStatus(polled_ - status_at_ > kStatus);
    if (!http_) {
        if (wait.count() > 0) TcpPort::waitForInput({}, static_cast<int>(wait.count()));
        return;
    }
    http_->poll(wait);
    if (http_->streams() == pages_) return;
    pages_ = http_->streams();
    options_.say(std::to_string(pages_) + (pages_ == 1 ? " page looks on" : " pages look on"));
}

void Live::step() {
    station_.step(board_.time_us());
    chronicle_.look(station_.telemetry(), board_.world(), now_s());
    clock_.measured(FlightClock::Clock::now(), board_.time_us());
    if (station_.plans().changes() != plans_seen_) {
        plans_seen_ = station_.plans().changes();
        announce("flight", document());
    }
    if (board_.time_us() / kSample_us == sampled_us_ / kSample_us && sampled_us_ != 0) return;
    sampled_us_ = board_.time_us();
    sample();
}

void Live::sample() {
    if (!http_) return;
    const std::string json = sampleJson(board_, station_.telemetry());
    const long time_ms = static_cast<long>(board_.time_us() / 1000);
    const std::string event = "id: " + std::to_string(time_ms) + "\n" + eventText("samples", json);
    http_->broadcast(event, true);
    if (!history_.empty() && time_ms < history_.back().first + kRemembered_ms) return;
    history_.emplace_back(time_ms, event);
    if (history_.size() < kMaxHistory) return;
    for (size_t i = 0; 2 * i < history_.size(); ++i) history_[i] = history_[2 * i];
    history_.resize((history_.size() + 1) / 2);
}

void Live::announce(const char* name, const std::string& json, bool droppable) {
    if (http_) http_->broadcast(eventText(name, json), droppable);
}

void Live::announceStatus(bool again) {
    if (!http_) return;
    const Telemetry& said = station_.telemetry();
    const auto now = FlightClock::Clock::now();
    Json json = {{"armed", said.armed()},
                 {"mode", said.heard() ? modeName(said.mode()) : "unknown"},
                 {"item", said.current()},
                 {"paused", clock_.paused()},
                 {"times", clock_.times() > 0 ? Json(clock_.times()) : Json("max")},
                 {"clients", clients_}};
    if (!ended_.empty()) json["ended"] = ended_;
    const std::string fixed = dumped(json);
    if (fixed == status_ && !again) return;
    status_ = fixed;
    status_at_ = now;
    json["speed"] = std::round(clock_.measured(now, board_.time_us()) * 100) / 100;
    announce("status", dumped(json));
}

void Live::setClients(size_t clients) {
    if (clients == clients_) return;
    options_.say(clients > clients_ ? "client connected" : "client disconnected");
    clients_ = clients;
}

void Live::end(const std::string& why) {
    constexpr Milliseconds kFarewell{500};
    ended_ = why;
    announceStatus(true);
    if (http_) http_->flush(kFarewell);
}

std::string Live::document() const {
    return documentJson(options_.origin, station_.plans(), chronicle_);
}

void Live::serve(HttpServer::Client client, const Request& request) {
    if (const auto refused = refusal(request, port())) return http_->respond(client, *refused);
    if (request.path == "/live") return sendHistory(client, request.header("last-event-id"));
    if (request.path == "/") {
        return http_->respond(client, {200, "text/html; charset=utf-8", options_.page});
    }
    try {
        take(readOrder(request.body), client);
    } catch (const OrderError& error) {
        http_->respond(client, answerJson(400, false, error.what()));
    }
}

// One that was here before has what came before its last sample.
void Live::sendHistory(HttpServer::Client client, const std::string& last_seen) {
    const long seen_ms = std::strtol(last_seen.c_str(), nullptr, 10);
    std::string events = "retry: 1000\n\n" + eventText("flight", document());
    for (const auto& [time_ms, event] : history_)
        if (last_seen.empty() || time_ms > seen_ms) events += event;
    http_->stream(client, events);
    announceStatus(true);
}

void Live::take(const Order& order, HttpServer::Client client) {
    const auto answer = [this, client](bool ok, const std::string& text) {
        http_->respond(client, answerJson(200, ok, text));
    };
    const bool to_autopilot = order.what == Do::arm || order.what == Do::disarm ||
                              order.what == Do::takeoff || order.what == Do::mode ||
                              order.what == Do::go_to;
    if (!to_autopilot) {
        const std::string refused = takeHere(order);
        return answer(refused.empty(), refused.empty() ? "done" : refused);
    }
    if (clock_.paused()) return answer(false, "paused: the autopilot hears nothing");
    station_.give(order, answer);
}

// Why it was refused; empty: done.
std::string Live::takeHere(const Order& order) {
    const auto now = FlightClock::Clock::now();
    switch (order.what) {
        case Do::pause:
        case Do::resume:
            clock_.pause(order.what == Do::pause, now, board_.time_us());
            return "";
        case Do::speed:
            clock_.setSpeed(order.times, now, board_.time_us());
            return "";
        case Do::fault:
            return setFault(order);
        case Do::wind:
            return setWind(order);
        default:
            return setSticks(order);
    }
}

// The same as --fault from now on, or until now.
std::string Live::setFault(const Order& order) {
    std::vector<Fault> faults = board_.world().faults();
    const double now = now_s();
    bool found = false;
    for (Fault& each : faults) {
        const bool meant = each.sensor == order.fault.sensor && each.kind == order.fault.kind &&
                           each.volts == order.fault.volts;
        if (!meant || now < each.from_s || now >= each.to_s) continue;
        found = true;
        if (!order.on) each.to_s = now;
    }
    if (found && order.on) return "it has failed already";
    if (!found && !order.on) return "it does not fail now";
    if (order.on) {
        faults.push_back(order.fault);
        faults.back().from_s = now;
        faults.back().to_s = kForEver_s;
    }
    board_.world().setFaults(faults);
    return "";
}

std::string Live::setWind(const Order& order) {
    if (!board_.world().setWind(order.wind_mps, order.wind_from_deg))
        return "the flight model elsewhere brings its own air";
    char text[64];
    std::snprintf(text, sizeof text, "wind %g m/s from %g deg", order.wind_mps,
                  order.wind_from_deg);
    chronicle_.add({now_s(), "fault", text});
    return "";
}

// Channels 1 to 4 in the order of RCMAP's defaults; the others stay.
std::string Live::setSticks(const Order& order) {
    constexpr double kCentre_us = 1500, kTravel_us = 400, kIdle_us = 1100;
    auto pulses = board_.world().radio().sticks();
    const auto deflected = [](double way) {
        return static_cast<uint16_t>(std::lround(kCentre_us + kTravel_us * way));
    };
    pulses[0] = deflected(order.roll);
    pulses[1] = deflected(order.pitch);
    pulses[2] = static_cast<uint16_t>(std::lround(kIdle_us + 2 * kTravel_us * order.throttle));
    pulses[3] = deflected(order.yaw);
    board_.world().radio().sticks(pulses, true);
    return "";
}

}  // namespace simulator::live
