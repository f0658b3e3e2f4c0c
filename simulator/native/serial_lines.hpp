// SPDX-License-Identifier: GPL-3.0-or-later
// The three serial ports of the native board: bytes cross their line one after the other at the
// rate the firmware opened, 10 bits a byte. The module on the GPS port has a rate of its own.
#pragma once
#include <array>
#include <cstdint>
#include <deque>
#include <vector>

#include "simulator/board.hpp"
#include "simulator/line_noise.hpp"

namespace simulator {

class World;

class SerialLines {
public:
    static constexpr int kPorts = 3;  // by USART: link0, GPS, link1
    static constexpr int kGps = 1;
    static constexpr uint64_t kNever = UINT64_MAX;

    SerialLines(const uint64_t& now_us, World& world) : now_us_(now_us), world_(world) {}

    // ---- the firmware's side
    void open(int port, uint32_t baud);
    void restart() { lines_ = {}; }  // what was under way is lost
    uint8_t available(int port) const;
    bool read(int port, uint8_t& byte);
    uint8_t room(int port) const;
    bool write(int port, const uint8_t* bytes, uint8_t size);
    // frames that wait for their signatures, each with so many bytes behind it
    void hold(int port, const std::vector<uint8_t>& frame, uint8_t signature);
    std::vector<uint8_t>& held(int port) { return lines_[port].held; }
    void sendHeld(int port, uint8_t size);
    uint16_t lost(int port) const { return lines_[port].lost; }

    // ---- the other end of the cable
    void listen(Board::Listener listener) { listener_ = std::move(listener); }
    void send(int port, const uint8_t* bytes, size_t size);
    size_t unsent(int port) const { return lines_[port].incoming.size(); }

    uint64_t due_us() const;
    void run();

private:
    struct Line {
        uint32_t baud = 0;
        std::deque<uint8_t> received, outgoing, incoming;
        std::vector<uint8_t> held;
        uint64_t sent_ns = UINT64_MAX, arrives_ns = UINT64_MAX;  // end of the byte on the wire
        uint16_t lost = 0;
    };

    void runOutgoing(int port);
    void runIncoming(int port);
    void runGps();
    void take(int port, uint8_t byte);
    uint64_t after_ns(uint64_t begin_ns, const Line& line) const;

    const uint64_t& now_us_;
    World& world_;
    Board::Listener listener_;
    std::array<Line, kPorts> lines_;
    LineNoise noise_;
};

}  // namespace simulator
