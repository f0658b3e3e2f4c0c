// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/live/http_server.hpp"

#include <fcntl.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <vector>

#include "simulator/ground/tcp_port.hpp"

namespace simulator::live {
namespace {

constexpr std::chrono::milliseconds kLinger{2'000};  // for a client to read why it is dropped

void setNonBlocking(int socket) {
    fcntl(socket, F_SETFL, fcntl(socket, F_GETFL, 0) | O_NONBLOCK);
    fcntl(socket, F_SETFD, FD_CLOEXEC);
}

// Nothing of a flight is kept or guessed at by a browser, and no other page may embed it.
constexpr char kAlways[] =
    "Cache-Control: no-store\r\nX-Content-Type-Options: nosniff\r\n"
    "Cross-Origin-Resource-Policy: same-origin\r\nX-Frame-Options: DENY\r\n"
    "Referrer-Policy: no-referrer\r\n";

std::string head(const Response& response) {
    return "HTTP/1.1 " + std::to_string(response.status) + " " + reasonOf(response.status) +
           "\r\nContent-Type: " + response.type + "\r\n" + kAlways + response.more_headers;
}

}  // namespace

const char* reasonOf(int status) {
    struct Row {
        int status;
        const char* reason;
    };
    static constexpr Row kRows[] = {{200, "OK"},
                                    {400, "Bad Request"},
                                    {403, "Forbidden"},
                                    {404, "Not Found"},
                                    {405, "Method Not Allowed"},
                                    {408, "Request Timeout"},
                                    {413, "Content Too Large"},
                                    {414, "URI Too Long"},
                                    {415, "Unsupported Media Type"},
                                    {431, "Request Header Fields Too Large"},
                                    {503, "Service Unavailable"}};
    for (const Row& row : kRows)
        if (row.status == status) return row.reason;
    return "Error";
}

HttpServer::HttpServer(uint16_t port, const Limits& limits) : limits_(limits) {
    listener_ = socket(AF_INET, SOCK_STREAM, 0);
    const int on = 1;
    setsockopt(listener_, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(port);
    auto* generic = reinterpret_cast<sockaddr*>(&address);
    socklen_t size = sizeof address;
    if (bind(listener_, generic, size) != 0 || listen(listener_, 16) != 0) {
        const std::string why = std::strerror(errno);
        close(listener_);
        throw TcpError("HTTP port " + std::to_string(port) + ": " + why);
    }
    getsockname(listener_, generic, &size);
    port_ = ntohs(address.sin_port);
    setNonBlocking(listener_);
}

HttpServer::~HttpServer() {
    for (const Connection& each : connections_) close(each.socket);
    close(listener_);
}

size_t HttpServer::streams() const {
    return static_cast<size_t>(std::count_if(
        connections_.begin(), connections_.end(),
        [](const Connection& each) { return each.doing == Connection::Doing::streaming; }));
}

HttpServer::Connection* HttpServer::find(Client client) {
    for (Connection& each : connections_)
        if (each.id == client) return &each;
    return nullptr;
}

void HttpServer::letIn() {
    for (int socket; (socket = accept(listener_, nullptr, nullptr)) >= 0;) {
        const int on = 1;
        setsockopt(socket, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
        setNonBlocking(socket);
        connections_.push_back({++last_, socket});
        connections_.back().since = now();
        if (connections_.size() > limits_.clients)
            answer(connections_.back(), {503, "text/plain", "too many clients\n"}, false);
    }
}

void HttpServer::wait(std::chrono::milliseconds time) const {
    std::vector<pollfd> sockets = {{listener_, POLLIN, 0}};
    for (const Connection& each : connections_) {
        const bool reads = each.doing != Connection::Doing::waiting_for_answer;
        const int events = (reads ? POLLIN : 0) | (each.unsent.empty() ? 0 : POLLOUT);
        sockets.push_back({each.socket, static_cast<short>(events), 0});
    }
    ::poll(sockets.data(), sockets.size(), static_cast<int>(time.count()));
}

void HttpServer::poll(std::chrono::milliseconds time) {
    if (time.count() > 0) wait(time);
    letIn();
    for (Connection& each : connections_) {
        read(each);
        write(each);
        dropLate(each);
    }
    for (auto each = connections_.begin(); each != connections_.end();) {
        if (each->gone) close(each->socket);
        each = each->gone ? connections_.erase(each) : std::next(each);
    }
}

void HttpServer::flush(std::chrono::milliseconds within) {
    const auto end = Clock::now() + within;
    const auto waits = [](const Connection& each) { return !each.unsent.empty(); };
    while (Clock::now() < end && std::any_of(connections_.begin(), connections_.end(), waits))
        poll(std::chrono::milliseconds(10));
}

// One that waits for its answer is not read: what it sends on stays with the system.
void HttpServer::read(Connection& connection) {
    std::array<char, 4096> part;
    while (connection.doing != Connection::Doing::waiting_for_answer && !connection.gone) {
        const ssize_t size = recv(connection.socket, part.data(), part.size(), 0);
        if (size == 0 || (size < 0 && errno != EAGAIN && errno != EINTR)) connection.gone = true;
        if (size <= 0) return;
        if (connection.doing != Connection::Doing::reading) continue;  // of no interest any more
        if (!connection.parser.begun()) connection.since = now();
        const std::string_view bytes(part.data(), static_cast<size_t>(size));
        take(connection, connection.parser.put(bytes));
    }
}

void HttpServer::take(Connection& connection, bool whole) {
    if (const int error = connection.parser.error(); error != 0) {
        const std::string why = std::string(reasonOf(error)) + "\n";
        return answer(connection, {error, "text/plain", why}, false);
    }
    if (!whole) return;
    connection.doing = Connection::Doing::waiting_for_answer;
    connection.keep_alive = connection.parser.request().keep_alive;
    on_request(connection.id, connection.parser.request());
}

void HttpServer::answer(Connection& connection, const Response& response, bool keep_alive) {
    connection.unsent +=
        head(response) + "Content-Length: " + std::to_string(response.body.size()) +
        "\r\nConnection: " + (keep_alive ? "keep-alive" : "close") + "\r\n\r\n" + response.body;
    connection.doing = keep_alive ? Connection::Doing::reading : Connection::Doing::closing;
    connection.since = connection.written = now();
}

void HttpServer::respond(Client client, const Response& response) {
    Connection* connection = find(client);
    if (!connection || connection->doing != Connection::Doing::waiting_for_answer) return;
    answer(*connection, response, connection->keep_alive);
    if (connection->keep_alive) take(*connection, connection->parser.next());
}

void HttpServer::stream(Client client, const std::string& first_events) {
    Connection* connection = find(client);
    if (!connection || connection->doing != Connection::Doing::waiting_for_answer) return;
    connection->unsent +=
        head({200, "text/event-stream", ""}) + "Connection: keep-alive\r\n\r\n" + first_events;
    connection->doing = Connection::Doing::streaming;
    connection->written = now();
}

void HttpServer::broadcast(const std::string& event, bool droppable) {
    for (Connection& each : connections_) {
        if (each.doing != Connection::Doing::streaming) continue;
        if (droppable && each.unsent.size() > limits_.droppable) continue;
        if (each.unsent.empty()) each.written = now();
        each.unsent += event;
        if (each.unsent.size() > limits_.backlog) each.gone = true;
    }
}

void HttpServer::write(Connection& connection) {
    size_t sent = 0;
    while (sent < connection.unsent.size() && !connection.gone) {
        const ssize_t size = send(connection.socket, connection.unsent.data() + sent,
                                  connection.unsent.size() - sent, MSG_NOSIGNAL);
        if (size < 0 && errno != EAGAIN) connection.gone = true;
        if (size <= 0) break;
        sent += static_cast<size_t>(size);
        connection.written = now();
    }
    connection.unsent.erase(0, sent);
    const bool said_all = connection.unsent.empty();
    if (connection.doing != Connection::Doing::closing || !said_all || connection.shut) return;
    shutdown(connection.socket, SHUT_WR);  // closed at once, an answer could be lost on its way
    connection.shut = true;
}

void HttpServer::dropLate(Connection& connection) {
    const auto time = now();
    const auto waited = time - connection.since;
    if (!connection.unsent.empty()) {
        if (time - connection.written > limits_.stalled) connection.gone = true;
    } else if (connection.doing == Connection::Doing::closing) {
        if (waited > kLinger) connection.gone = true;
    } else if (connection.doing == Connection::Doing::reading) {
        if (connection.parser.begun() && waited > limits_.request)
            answer(connection, {408, "text/plain", "Request Timeout\n"}, false);
        if (!connection.parser.begun() && waited > limits_.idle) connection.gone = true;
    }
}

}  // namespace simulator::live
