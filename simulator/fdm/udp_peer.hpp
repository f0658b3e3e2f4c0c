// SPDX-License-Identifier: GPL-3.0-or-later
// A datagram socket with one partner, open to nobody else: it is bound to the address of this
// computer that faces the partner, 127.0.0.1 for one on this computer.
#pragma once
#include <chrono>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace simulator {

class UdpError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

class UdpPeer {
public:
    // Throws UdpError when there is no such host or the port of our own is taken.
    UdpPeer(const std::string& host, uint16_t port, uint16_t own_port);
    ~UdpPeer();
    UdpPeer(const UdpPeer&) = delete;
    UdpPeer& operator=(const UdpPeer&) = delete;

    void send(const std::vector<uint8_t>& bytes);

    // The whole time out unless something came: a partner that refuses is silent, no more.
    enum class Waited { came, silence, interrupted };
    Waited wait(std::chrono::milliseconds time_out);
    std::optional<std::string> newest();  // of what has come; the older ones are left behind

private:
    int socket_ = -1;
    std::vector<char> buffer_;
};

}  // namespace simulator
