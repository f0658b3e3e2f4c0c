// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/fdm/udp_peer.hpp"

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

using simulator::UdpPeer;
using std::chrono::milliseconds;

namespace {

class Socket {
public:
    explicit Socket(const char* address, uint16_t port = 0)
        : socket_(socket(AF_INET, SOCK_DGRAM, 0)) {
        sockaddr_in own{};
        own.sin_family = AF_INET;
        own.sin_addr.s_addr = inet_addr(address);
        own.sin_port = htons(port);
        bound = bind(socket_, reinterpret_cast<sockaddr*>(&own), sizeof own) == 0;
        socklen_t size = sizeof own;
        getsockname(socket_, reinterpret_cast<sockaddr*>(&own), &size);
        number = ntohs(own.sin_port);
    }
    ~Socket() { close(socket_); }

    bool bound;
    uint16_t number;

private:
    int socket_;
};

// A port that nobody listens on, with a free one above it.
uint16_t freePort() {
    for (;;) {
        const Socket one("127.0.0.1");
        if (one.number < 65535 && Socket("127.0.0.1", one.number + 1).bound) return one.number;
    }
}

}  // namespace

// With a partner on this computer: whoever is elsewhere is not even heard.
TEST(UdpPeer, is_bound_to_the_loopback_alone) {
    const uint16_t port = freePort();
    const UdpPeer peer("127.0.0.1", port, port + 1);

    EXPECT_FALSE(Socket("127.0.0.1", port + 1).bound);
    EXPECT_TRUE(Socket("127.0.0.2", port + 1).bound);  // of another address of the same computer
}

// A partner that is not there refuses each packet; that is no reason to stop waiting.
TEST(UdpPeer, waits_the_whole_time_although_it_is_refused) {
    using Clock = std::chrono::steady_clock;
    const uint16_t port = freePort();
    UdpPeer peer("127.0.0.1", port, port + 1);
    peer.send({1, 2, 3});
    peer.send({1, 2, 3});
    const auto before = Clock::now();

    EXPECT_EQ(peer.wait(milliseconds(100)), UdpPeer::Waited::silence);
    EXPECT_GE(Clock::now() - before, milliseconds(100));
}
