// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/native/serial_lines.hpp"

#include <algorithm>

#include "hal/serial.hpp"
#include "simulator/devices/gps_receiver.hpp"
#include "simulator/world.hpp"

namespace simulator {

// What the rings of the chip's ports hold.
struct Rings {
    size_t rx, tx;
};
constexpr Rings kRings[SerialLines::kPorts] = {
    {127, hal::kLinkRoom}, {127, 31}, {127, hal::kLinkRoom}};

void SerialLines::open(int port, uint32_t baud) {
    Line& line = lines_[port];
    line.baud = baud;
    line.received.clear();
    line.outgoing.clear();
    line.held.clear();
    line.sent_ns = UINT64_MAX;
    line.arrives_ns = line.incoming.empty() ? UINT64_MAX : after_ns(now_us_ * 1000, line);
}

uint64_t SerialLines::after_ns(uint64_t begin_ns, const Line& line) const {
    return line.baud == 0 ? UINT64_MAX : begin_ns + 10'000'000'000ull / line.baud;
}

uint8_t SerialLines::available(int port) const {
    return static_cast<uint8_t>(lines_[port].received.size());
}

bool SerialLines::read(int port, uint8_t& byte) {
    Line& line = lines_[port];
    if (line.received.empty()) return false;
    byte = line.received.front();
    line.received.pop_front();
    return true;
}

uint8_t SerialLines::room(int port) const {
    return static_cast<uint8_t>(kRings[port].tx - lines_[port].outgoing.size() -
                                lines_[port].held.size());
}

bool SerialLines::write(int port, const uint8_t* bytes, uint8_t size) {
    Line& line = lines_[port];
    if (room(port) < size) return false;
    line.outgoing.insert(line.outgoing.end(), bytes, bytes + size);
    if (line.sent_ns == UINT64_MAX) line.sent_ns = after_ns(now_us_ * 1000, line);
    return true;
}

void SerialLines::hold(int port, const std::vector<uint8_t>& frame, uint8_t signature) {
    std::vector<uint8_t>& held = lines_[port].held;
    held.insert(held.end(), frame.begin(), frame.end());
    held.resize(held.size() + signature);
}

void SerialLines::sendHeld(int port, uint8_t size) {
    std::vector<uint8_t>& held = lines_[port].held;
    const std::vector<uint8_t> sent(held.begin(), held.begin() + size);
    held.erase(held.begin(), held.begin() + size);
    write(port, sent.data(), size);
}

void SerialLines::send(int port, const uint8_t* bytes, size_t size) {
    Line& line = lines_[port];
    line.incoming.insert(line.incoming.end(), bytes, bytes + size);
    if (line.arrives_ns == UINT64_MAX && size > 0) {
        line.arrives_ns = after_ns(now_us_ * 1000, line);
    }
}

uint64_t SerialLines::due_us() const {
    uint64_t due_ns = UINT64_MAX;
    for (const Line& line : lines_) due_ns = std::min({due_ns, line.sent_ns, line.arrives_ns});
    const uint64_t due_us = due_ns == UINT64_MAX ? kNever : (due_ns + 999) / 1000;
    return std::min(due_us, world_.gps().nextByte_us());
}

void SerialLines::run() {
    for (int port = 0; port < kPorts; ++port) {
        runOutgoing(port);
        runIncoming(port);
    }
    runGps();
}

void SerialLines::runOutgoing(int port) {
    Line& line = lines_[port];
    while (line.sent_ns <= now_us_ * 1000) {
        if (!line.outgoing.empty()) {
            const uint8_t byte = line.outgoing.front();
            line.outgoing.pop_front();
            if (port == kGps) world_.gps().receive(byte, line.baud, now_us_);
            if (listener_) listener_(port, byte, now_us_);
        }
        line.sent_ns = line.outgoing.empty() ? UINT64_MAX : after_ns(line.sent_ns, line);
    }
}

void SerialLines::runIncoming(int port) {
    Line& line = lines_[port];
    while (line.arrives_ns <= now_us_ * 1000) {
        take(port, line.incoming.front());
        line.incoming.pop_front();
        line.arrives_ns = line.incoming.empty() ? UINT64_MAX : after_ns(line.arrives_ns, line);
    }
}

void SerialLines::runGps() {
    Line& line = lines_[kGps];
    while (auto sent = world_.gps().nextByte(now_us_)) {
        if (line.baud == 0) continue;
        if (auto byte = noise_.through(*sent, world_.gps().baud(), line.baud)) take(kGps, *byte);
    }
}

void SerialLines::take(int port, uint8_t byte) {
    Line& line = lines_[port];
    if (line.received.size() >= kRings[port].rx) {
        ++line.lost;
    } else {
        line.received.push_back(byte);
    }
}

}  // namespace simulator
