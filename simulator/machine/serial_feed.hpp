// SPDX-License-Identifier: GPL-3.0-or-later
// The far end of a serial line: bytes queued here reach the USART one after the other at the rate
// it is set to, as from a sender that agrees with it. While its receiver is off they are lost, as
// they are on the board.
#pragma once
#include <deque>

#include "simulator/machine/chip.hpp"

namespace simulator {

class SerialFeed {
public:
    SerialFeed(Chip& chip, int usart) : avr_(chip.avr()), usart_(chip.usart(usart)) {}

    void send(const uint8_t* bytes, size_t size) {
        const bool idle = waiting_.empty();
        waiting_.insert(waiting_.end(), bytes, bytes + size);
        if (idle) resume();
    }
    size_t unsent() const { return waiting_.size(); }
    void resume() {  // also after a reset, which drops the timer
        if (!waiting_.empty()) startTimer<&SerialFeed::arrived>(avr_, byteCycles(), this);
    }

private:
    static constexpr uint64_t kLostByteCycles = 10 * kClock_hz / 57600;

    uint64_t byteCycles() const {
        return usart_.receiving() ? usart_.byteCycles() : kLostByteCycles;
    }
    uint64_t arrived(uint64_t due) {
        usart_.receive(waiting_.front());
        waiting_.pop_front();
        return waiting_.empty() ? 0 : due + byteCycles();
    }

    avr_t* avr_;
    Usart& usart_;
    std::deque<uint8_t> waiting_;
};

}  // namespace simulator
