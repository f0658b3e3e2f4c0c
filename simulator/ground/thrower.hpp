// SPDX-License-Identifier: GPL-3.0-or-later
// Who lets an airplane go that has no wheels: he throws it when the autopilot has said for three
// heartbeats that it is armed and in AUTO.
#pragma once
#include "simulator/ground/link.hpp"

namespace simulator {

class Thrower {
public:
    Thrower(Board& board, int usart)
        : board_(board),
          link_(board, usart, [this](const mavlink::Frame& f, uint64_t) { take(f); }) {}

    void receive(uint8_t byte, uint64_t time_us) { link_.receive(byte, time_us); }

private:
    void take(const mavlink::Frame& frame);

    Board& board_;
    Link link_;
    int beats_ = 0;
};

}  // namespace simulator
