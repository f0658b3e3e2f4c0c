// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/fdm/udp_peer.hpp"

#include <arpa/inet.h>
#include <netdb.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace simulator {

constexpr size_t kLongest = 65536;

static sockaddr_in addressOf(const std::string& host, uint16_t port) {
    addrinfo hints{}, *found = nullptr;
    hints.ai_family = AF_INET;
    hints.ai_socktype = SOCK_DGRAM;
    const int failed = getaddrinfo(host.c_str(), nullptr, &hints, &found);
    if (failed != 0) throw UdpError(host + ": " + gai_strerror(failed));
    sockaddr_in address;
    std::memcpy(&address, found->ai_addr, sizeof address);
    freeaddrinfo(found);
    address.sin_port = htons(port);
    return address;
}

UdpPeer::UdpPeer(const std::string& host, uint16_t port, uint16_t own_port) : buffer_(kLongest) {
    const sockaddr_in partner = addressOf(host, port);
    sockaddr_in own{};
    own.sin_family = AF_INET;
    own.sin_addr.s_addr = htonl(INADDR_ANY);
    own.sin_port = htons(own_port);
    socket_ = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    if (bind(socket_, reinterpret_cast<const sockaddr*>(&own), sizeof own) != 0) {
        const std::string why = std::strerror(errno);
        close(socket_);
        throw UdpError("UDP port " + std::to_string(own_port) + ": " + why);
    }
    connect(socket_, reinterpret_cast<const sockaddr*>(&partner), sizeof partner);
}

UdpPeer::~UdpPeer() { close(socket_); }

// A partner that is not there yet answers by refusing: the next wait finds silence.
void UdpPeer::send(const std::vector<uint8_t>& bytes) {
    if (::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL) < 0 && errno == ECONNREFUSED)
        (void)::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
}

UdpPeer::Waited UdpPeer::wait(int time_out_ms) {
    pollfd waited = {socket_, POLLIN, 0};
    const int ready = poll(&waited, 1, time_out_ms);
    if (ready < 0) return Waited::interrupted;
    return ready > 0 && (waited.revents & POLLIN) != 0 ? Waited::came : Waited::silence;
}

std::optional<std::string> UdpPeer::newest() {
    std::optional<std::string> last;
    for (;;) {
        const ssize_t size = recv(socket_, buffer_.data(), buffer_.size(), 0);
        if (size >= 0) {
            last = std::string(buffer_.data(), static_cast<size_t>(size));
        } else if (errno != ECONNREFUSED) {
            return last;
        }
    }
}

}  // namespace simulator
