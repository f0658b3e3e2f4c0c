// SPDX-License-Identifier: GPL-3.0-or-later
// HTTP/1.1 on a loopback port, with streams of server-sent events. One thread, nothing blocks: the
// simulation polls. A client that does not finish its request, does not read, or exceeds a limit
// is dropped; it never holds up the others or the flight.
#pragma once
#include <chrono>
#include <functional>
#include <list>

#include "simulator/live/http_request.hpp"

namespace simulator::live {

struct Response {
    int status = 200;
    std::string type = "text/plain; charset=utf-8", body;
    std::string more_headers = {};  // whole lines
};

const char* reasonOf(int status);

class HttpServer {
public:
    using Client = uint64_t;  // never given twice
    using Clock = std::chrono::steady_clock;

    struct Limits {
        size_t clients = 32;
        size_t backlog = 16 << 20, droppable = 1 << 18;  // bytes a client may leave unread
        std::chrono::milliseconds request{10'000};       // from a request's first byte to its last
        std::chrono::milliseconds idle{60'000};          // between requests
        std::chrono::milliseconds stalled{20'000};       // reads nothing of what waits for it
    };

    explicit HttpServer(uint16_t port) : HttpServer(port, Limits{}) {}
    HttpServer(uint16_t port, const Limits& limits);  // 0: any that is free; throws TcpError
    ~HttpServer();
    HttpServer(const HttpServer&) = delete;
    HttpServer& operator=(const HttpServer&) = delete;

    uint16_t port() const { return port_; }
    size_t streams() const;  // clients that listen to events

    std::function<Clock::time_point()> now = Clock::now;

    // Called for each request; it is answered now or later, once, by respond() or stream().
    std::function<void(Client, const Request&)> on_request = [](Client, const Request&) {};

    // Of a client that has gone: nothing.
    void respond(Client client, const Response& response);
    void stream(Client client, const std::string& first_events);
    // To every stream; a droppable event is left out where a client is behind.
    void broadcast(const std::string& event, bool droppable = false);

    // Lets clients in, reads, answers and drops; waits for input for at most that long.
    void poll(std::chrono::milliseconds wait = std::chrono::milliseconds(0));
    // Writes what the clients still take within that time.
    void flush(std::chrono::milliseconds within);

private:
    struct Connection {
        Client id;
        int socket;
        RequestParser parser = {};
        std::string unsent = {};
        enum class Doing { reading, waiting_for_answer, streaming, closing } doing = Doing::reading;
        bool keep_alive = false, shut = false, gone = false;
        Clock::time_point since = {};    // of the present wait
        Clock::time_point written = {};  // when it last took something
    };

    void letIn();
    void wait(std::chrono::milliseconds time) const;
    void read(Connection& connection);
    void take(Connection& connection, bool whole);
    void write(Connection& connection);
    void answer(Connection& connection, const Response& response, bool keep_alive);
    void dropLate(Connection& connection);
    Connection* find(Client client);

    const Limits limits_;
    int listener_ = -1;
    uint16_t port_ = 0;
    Client last_ = 0;
    std::list<Connection> connections_;
};

}  // namespace simulator::live
