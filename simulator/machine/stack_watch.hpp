// SPDX-License-Identifier: GPL-3.0-or-later
// The lowest stack pointer ever, exact: libsimavr moves it through the register hooks with every
// push, call and interrupt, so each new value passes here.
#pragma once
#include "simulator/machine/hooks.hpp"
#include "simulator/machine/registers.hpp"

namespace simulator {

class StackWatch : public Mend {
public:
    explicit StackWatch(avr_t* avr) : avr_(avr) {
        hookWrite<&StackWatch::writeLow>(avr, kSpl, this);
        hookWrite<&StackWatch::writeHigh>(avr, kSph, this);
    }

    uint32_t maxBytes() const { return lowest_ > kRamEnd ? 0u : kRamEnd - lowest_; }

private:
    // OUT SPL or OUT SPH, the two halves of a program's own move of the stack (1011 1AAr rrrr
    // AAAA).
    bool movedBy(uint16_t out) const {
        const uint8_t* code = avr_->flash + avr_->pc;
        return ((code[0] | code[1] << 8) & 0xFE0F) == out;
    }
    // avr-gcc writes SPH first, the hardware's own moves SPL first: a value counts when its second
    // half is there.
    void writeLow(uint16_t, uint8_t value) {
        avr_->data[kSpl] = value;
        if (movedBy(0xBE0D)) look();
    }
    void writeHigh(uint16_t, uint8_t value) {
        if (avr_->data[kSph] == value && value << 8 > lowest_) return;
        avr_->data[kSph] = value;
        if (!movedBy(0xBE0E)) look();
    }
    void look() {
        const uint16_t now = static_cast<uint16_t>(avr_->data[kSph] << 8 | avr_->data[kSpl]);
        if (now < lowest_ && now > 0x1FF) lowest_ = now;
    }

    avr_t* avr_;
    uint16_t lowest_ = 0xFFFF;
};

}  // namespace simulator
