// SPDX-License-Identifier: GPL-3.0-or-later
// One of the six timers: exact counts where libsimavr's scaling loses a tick, starting from the
// count that was written, compare values that wait for the end of the period and a TOP in ICRn
// that counts at once (datasheet 17.3, 17.9.3 and table 17-2). The level a match gives a compare's
// output stays in its register while the port has the pin, until the next match, a forced one or a
// reset (17.7.1, 17.7.3, 17.8).
#pragma once
#include <simavr/avr_ioport.h>
#include <simavr/avr_timer.h>

#include <array>
#include <functional>
#include <vector>

#include "simulator/machine/hooks.hpp"

namespace simulator {

class Timer : public Mend {
public:
    Timer(avr_t* avr, char name);
    void reset() override;

    uint32_t prescaler() const;  // 0: stopped, or clocked from a pin
    uint16_t count(uint64_t cycle) const;
    // An edge on the capture pin at this cycle, which may lie a few cycles back.
    void captureEdge(bool rising, uint64_t cycle);

    std::function<void(int compare)> on_compare;  // the program has written a compare value
    // An edge of a compare's pin, low while the port has it, and the cycle of it.
    void onPin(int compare, std::function<void(bool high, uint64_t cycle)> changed);
    // What the pins of a port show, with those that a compare of this timer drives at its level.
    uint8_t driven(const avr_ioport_t& port, uint8_t pins) const;

private:
    struct Compare {
        WriteChain write;  // the library's own
        bool waiting = false;
        uint8_t low = 0, high = 0;
    };

    // A compare's output register and its pin.
    struct Output {
        Timer* timer = nullptr;
        int compare = 0;
        bool latch = false, pin = false;
        std::vector<std::function<void(bool, uint64_t)>> changed;

        void raised(uint32_t value) { timer->matched(compare, value & 1); }
    };

    bool wide() const { return io_->r_tcnth != 0; }
    bool countsUp() const { return io_->wgm_op_mode_kind != avr_timer_wgm_pwm; }
    bool buffered(int compare) const;
    int compareAt(uint16_t address) const;
    void setCount(uint16_t count);
    void reconfigure();

    void writeControl(uint16_t address, uint8_t value);
    void writeCount(uint16_t address, uint8_t value);
    void writeHigh(uint16_t, uint8_t value) { temp_ = value; }
    void writeTop(uint16_t address, uint8_t value);
    void writeCompare(uint16_t address, uint8_t value);
    void setCompare(int compare);
    uint8_t readCount(uint16_t address);
    uint8_t readCompare(uint16_t address);
    void writeForce(uint16_t address, uint8_t value);
    bool fromMatch(int compare, bool high) const;
    uint64_t edge(int compare, bool high) const;
    void matched(int compare, bool high);
    void force(int compare);
    void show(int compare, uint64_t cycle);
    void overflowed(uint32_t raised);
    uint64_t takeOver(uint64_t);

    avr_t* avr_;
    avr_timer_t* io_;
    WriteChain write_control_[2];
    std::array<Compare, AVR_TIMER_COMP_COUNT> compares_ = {};
    std::array<Output, AVR_TIMER_COMP_COUNT> outputs_;
    uint8_t temp_ = 0;  // the high byte on its way, one for all 16-bit registers of a timer
};

}  // namespace simulator
