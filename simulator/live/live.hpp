// SPDX-License-Identifier: GPL-3.0-or-later
// A flight that is watched and acted upon while it goes on: a page over HTTP, commands as a ground
// station or the simulator itself gives them, and a line on the terminal for whatever happens.
// The one who flies waits for each step here and reports it when it is done.
#pragma once
#include <memory>

#include "simulator/live/chronicle.hpp"
#include "simulator/live/document.hpp"
#include "simulator/live/flight_clock.hpp"
#include "simulator/live/gate.hpp"
#include "simulator/live/station.hpp"

namespace simulator::live {

struct LiveOptions {
    int usart = 0;                      // where the page's ground station is
    std::optional<uint16_t> http_port;  // empty: no page; 0: any
    bool any_port = false;              // another when that one is taken
    double speed = 1;                   // times real time, 0: as fast as it goes
    Origin origin;
    std::string page;  // HTML
    std::function<void(const std::string& line)> say = [](const std::string&) {};
};

class Live {
public:
    Live(Board& board, const LiveOptions& options);  // throws TcpError

    uint16_t port() const { return http_ ? http_->port() : 0; }

    // For the board's listener: every byte of every USART.
    void receive(int usart, uint8_t byte, uint64_t time_us);

    // Waits until the step to `until_us` is due, serving meanwhile; false: `stop` says so.
    bool awaitStep(uint64_t until_us, const std::function<bool()>& stop);
    // After the step.
    void step();
    // Of ground stations on the MAVLink ports.
    void setClients(size_t clients);
    // Says why it is over to whoever looks on.
    void end(const std::string& why);

    Station& station() { return station_; }
    const Chronicle& chronicle() const { return chronicle_; }

private:
    void serve(HttpServer::Client client, const Request& request);
    void take(const Order& order, HttpServer::Client client);
    std::string takeHere(const Order& order);
    std::string setFault(const Order& order);
    std::string setWind(const Order& order);
    std::string setSticks(const Order& order);
    void sendHistory(HttpServer::Client client, const std::string& last_seen);
    void announce(const char* name, const std::string& json, bool droppable = false);
    void announceStatus(bool again);
    void poll(std::chrono::milliseconds wait);
    void sample();
    std::string document() const;
    double now_s() const { return static_cast<double>(board_.time_us()) * 1e-6; }
    void sayEvent(const ChronicleEvent& event);

    Board& board_;
    const LiveOptions options_;
    Station station_;
    mavlink::PeerParser others_;  // of the other line
    Chronicle chronicle_;
    FlightClock clock_;
    std::unique_ptr<HttpServer> http_;
    FlightClock::Clock::time_point polled_{}, status_at_{};
    std::string status_;
    uint64_t sampled_us_ = 0;
    std::vector<std::pair<long, std::string>> history_;  // one sample a second, by its time in ms
    unsigned plans_seen_ = 0;
    size_t clients_ = 0, pages_ = 0;
    std::string ended_;
};

}  // namespace simulator::live
