// SPDX-License-Identifier: GPL-3.0-or-later
// A listening TCP port on this computer: what its clients send is one stream, and every client is
// sent everything. Nothing here blocks, but for waitForInput.
#pragma once
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace simulator {

class TcpError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

class TcpPort {
public:
    explicit TcpPort(uint16_t port);  // 0: any that is free; throws TcpError
    ~TcpPort();
    TcpPort(const TcpPort&) = delete;
    TcpPort& operator=(const TcpPort&) = delete;

    uint16_t port() const { return port_; }
    bool hasClient() const { return !clients_.empty(); }
    size_t clients() const { return clients_.size(); }

    std::vector<uint8_t> receive();  // lets new clients in, takes what has come
    void send(const uint8_t* bytes, size_t size);
    void send(const std::string& text);

    // Until any of the ports has a new client or input, or the time is over.
    static void waitForInput(const std::vector<TcpPort*>& ports, int time_out_ms);

private:
    struct Client {
        int socket;
        std::vector<uint8_t> unsent;
    };
    void letIn();
    bool flush(Client& client);

    int listener_ = -1;
    uint16_t port_ = 0;
    std::vector<Client> clients_;
};

}  // namespace simulator
