// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/ground/tcp_port.hpp"

#include <arpa/inet.h>
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

namespace simulator {

// A client that does not read is dropped; its data would otherwise fill the memory.
constexpr size_t kLongestBacklog = 1 << 20;

static void setNonBlocking(int socket) {
    fcntl(socket, F_SETFL, fcntl(socket, F_GETFL, 0) | O_NONBLOCK);
    fcntl(socket, F_SETFD, FD_CLOEXEC);
}

TcpPort::TcpPort(uint16_t port) {
    listener_ = socket(AF_INET, SOCK_STREAM, 0);
    const int on = 1;
    setsockopt(listener_, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(port);
    auto* generic = reinterpret_cast<sockaddr*>(&address);
    socklen_t size = sizeof address;
    if (bind(listener_, generic, size) != 0 || listen(listener_, 4) != 0) {
        const std::string why = std::strerror(errno);
        close(listener_);
        throw TcpError("TCP port " + std::to_string(port) + ": " + why);
    }
    getsockname(listener_, generic, &size);
    port_ = ntohs(address.sin_port);
    setNonBlocking(listener_);
}

TcpPort::~TcpPort() {
    for (const Client& client : clients_) close(client.socket);
    close(listener_);
}

void TcpPort::letIn() {
    for (int socket; (socket = accept(listener_, nullptr, nullptr)) >= 0;) {
        const int on = 1;
        setsockopt(socket, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
        setNonBlocking(socket);
        clients_.push_back({socket, {}});
    }
}

std::vector<uint8_t> TcpPort::receive() {
    letIn();
    std::vector<uint8_t> bytes;
    std::array<uint8_t, 4096> part;
    for (auto client = clients_.begin(); client != clients_.end();) {
        ssize_t size;
        while ((size = recv(client->socket, part.data(), part.size(), 0)) > 0) {
            bytes.insert(bytes.end(), part.begin(), part.begin() + size);
        }
        const bool gone = size == 0 || errno != EAGAIN;
        if (gone || !flush(*client)) {
            close(client->socket);
            client = clients_.erase(client);
        } else {
            ++client;
        }
    }
    return bytes;
}

bool TcpPort::flush(Client& client) {
    while (!client.unsent.empty()) {
        const ssize_t sent =
            ::send(client.socket, client.unsent.data(), client.unsent.size(), MSG_NOSIGNAL);
        if (sent < 0) return errno == EAGAIN;
        client.unsent.erase(client.unsent.begin(), client.unsent.begin() + sent);
    }
    return true;
}

void TcpPort::send(const uint8_t* bytes, size_t size) {
    for (auto client = clients_.begin(); client != clients_.end();) {
        client->unsent.insert(client->unsent.end(), bytes, bytes + size);
        if (flush(*client) && client->unsent.size() < kLongestBacklog) {
            ++client;
        } else {
            close(client->socket);
            client = clients_.erase(client);
        }
    }
}

void TcpPort::send(const std::string& text) {
    send(reinterpret_cast<const uint8_t*>(text.data()), text.size());
}

void TcpPort::waitForInput(const std::vector<TcpPort*>& ports, int time_out_ms) {
    std::vector<pollfd> sockets;
    for (const TcpPort* port : ports) {
        sockets.push_back({port->listener_, POLLIN, 0});
        for (const Client& client : port->clients_) sockets.push_back({client.socket, POLLIN, 0});
    }
    poll(sockets.data(), sockets.size(), time_out_ms);
}

}  // namespace simulator
