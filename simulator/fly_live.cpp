// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/fly_live.hpp"

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <iostream>

#include "simulator/flight_provenance.hpp"
#include "simulator/open_page.hpp"
#include "simulator/report/page.hpp"

namespace simulator {
namespace {

constexpr uint16_t kUsualPort = 5770;

std::unique_ptr<live::Live> makeLive(const FlyOptions& options, Board& board, int usart,
                                     const ParameterSettings& settings) {
    if (options.lock_step || (!options.serve && !options.watch)) return nullptr;
    live::LiveOptions live;
    live.usart = usart;
    if (options.page)
        live.http_port = options.http ? *options.http : options.listen == 0 ? 0 : kUsualPort;
    live.any_port = !options.http;
    live.origin.provenance = provenanceJson(provenanceOf(options, settings));
    const std::filesystem::path flown = options.serve ? options.airplane : options.mission;
    live.origin.title = flown.filename().string() + ", live";
    live.origin.start = board.world().truth();
    live.page = livePage();
    live.say = [](const std::string& line) { std::cout << line << std::endl; };
    return std::make_unique<live::Live>(board, live);
}

}  // namespace

std::string dateNow() {
    const std::time_t now = std::time(nullptr);
    std::tm utc{};
    gmtime_r(&now, &utc);
    char text[32];
    std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
    return text;
}

FlyWatchers::FlyWatchers(const FlyOptions& options, Board& board, int usart,
                         const ParameterSettings& settings)
    : board_(board), live_(makeLive(options, board, usart, settings)) {
    if (const auto address = live::flightGearAddress(options.flightgear))
        flightgear_ = std::make_unique<live::FlightGear>(*address);
    if (!options.watch || FlyWatchers::address().empty()) return;
    std::cout << "page " << FlyWatchers::address() << "; Ctrl-C ends" << std::endl;
    openPage(FlyWatchers::address());
}

std::string FlyWatchers::address() const {
    if (!live_ || live_->port() == 0) return "";
    return "http://127.0.0.1:" + std::to_string(live_->port());
}

void FlyWatchers::receive(int usart, uint8_t byte, uint64_t time_us) {
    if (live_) live_->receive(usart, byte, time_us);
}

bool FlyWatchers::awaitStep(uint64_t until_us, const std::function<bool()>& stop) {
    return !live_ || live_->awaitStep(until_us, stop);
}

void FlyWatchers::step() {
    if (live_) live_->step();
    if (flightgear_) flightgear_->step(board_.world().truth(), board_.time_us());
}

void FlyWatchers::end(const std::string& why, Summary& summary) {
    if (!live_) return;
    for (const live::ChronicleEvent& each : live_->chronicle().events())
        if (each.kind == "fault") summary.events.push_back({each.time_s, each.text});
    std::stable_sort(summary.events.begin(), summary.events.end(),
                     [](const Event& a, const Event& b) { return a.time_s < b.time_s; });
    live_->end(why);
}

}  // namespace simulator
