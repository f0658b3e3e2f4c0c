// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/fdm/udp_peer.hpp"

#include <arpa/inet.h>
#include <netdb.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
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

// Connecting sends nothing; it makes the system choose the interface.
static sockaddr_in addressFacing(const sockaddr_in& partner) {
    const int probe = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
    sockaddr_in own{};
    socklen_t size = sizeof own;
    const bool known =
        connect(probe, reinterpret_cast<const sockaddr*>(&partner), sizeof partner) == 0 &&
        getsockname(probe, reinterpret_cast<sockaddr*>(&own), &size) == 0;
    const std::string why = std::strerror(errno);
    close(probe);
    if (!known) throw UdpError(std::string(inet_ntoa(partner.sin_addr)) + ": " + why);
    return own;
}

UdpPeer::UdpPeer(const std::string& host, uint16_t port, uint16_t own_port) : buffer_(kLongest) {
    const sockaddr_in partner = addressOf(host, port);
    sockaddr_in own = addressFacing(partner);
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

// A refusal waits on the socket as an error, for which poll() returns at once: it is taken away
// and the wait goes on.
UdpPeer::Waited UdpPeer::wait(std::chrono::milliseconds time_out) {
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + time_out;
    for (;;) {
        const auto rest = std::chrono::ceil<std::chrono::milliseconds>(end - Clock::now());
        pollfd waited = {socket_, POLLIN, 0};
        const int ready = poll(&waited, 1, static_cast<int>(std::max<int64_t>(rest.count(), 0)));
        if (ready < 0) return Waited::interrupted;
        if ((waited.revents & POLLIN) != 0) return Waited::came;
        if (ready == 0) return Waited::silence;
        int error = 0;
        socklen_t size = sizeof error;
        getsockopt(socket_, SOL_SOCKET, SO_ERROR, &error, &size);
    }
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
