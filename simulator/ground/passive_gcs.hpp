// SPDX-License-Identifier: GPL-3.0-or-later
// A second ground station: asks for all streams at their highest rate and only listens.
#pragma once
#include "simulator/ground/link.hpp"

namespace simulator {

class PassiveGcs {
public:
    PassiveGcs(Board& board, int usart)
        : link_(board, usart, [this](const mavlink::Frame& frame, uint64_t) { take(frame); }) {}

    int usart() const { return link_.usart(); }
    void receive(uint8_t byte, uint64_t time_us) { link_.receive(byte, time_us); }
    void step(uint64_t now_us);
    unsigned messages() const { return messages_; }

private:
    void take(const mavlink::Frame& frame);

    Link link_;
    unsigned messages_ = 0;
    uint8_t system_ = 0, component_ = 0;
    uint64_t asked_us_ = 0;
    int tries_ = 0;
};

}  // namespace simulator
