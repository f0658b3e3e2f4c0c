// SPDX-License-Identifier: GPL-3.0-or-later
// The three ways in which libsimavr calls back - a register touched, a line changed, a cycle
// reached - each bound to a member function without cost. Hooks outlive a reset; cycle timers
// do not, libsimavr drops them all.
#pragma once
#include <simavr/sim_avr.h>
#include <simavr/sim_io.h>

#include <cstdint>
#include <cstring>

namespace simulator {

// What stood in a register's slot before the hook.
struct WriteChain {
    avr_io_write_t call = nullptr;
    void* param = nullptr;
    void operator()(avr_t* avr, uint16_t address, uint8_t value) const {
        if (call) {
            call(avr, address, value, param);
        } else {
            avr->data[address] = value;
        }
    }
};

template <auto method, class Owner>
WriteChain hookWrite(avr_t* avr, uint16_t address, Owner* owner) {
    auto& slot = avr->io[AVR_DATA_TO_IO(address)].w;
    const WriteChain before{slot.c, slot.param};
    slot.c = [](avr_t*, avr_io_addr_t at, uint8_t value, void* param) {
        (static_cast<Owner*>(param)->*method)(at, value);
    };
    slot.param = owner;
    return before;
}

struct ReadChain {
    avr_io_read_t call = nullptr;
    void* param = nullptr;
    uint8_t operator()(avr_t* avr, uint16_t address) const {
        return call ? call(avr, address, param) : avr->data[address];
    }
};

template <auto method, class Owner>
ReadChain hookRead(avr_t* avr, uint16_t address, Owner* owner) {
    auto& slot = avr->io[AVR_DATA_TO_IO(address)].r;
    const ReadChain before{slot.c, slot.param};
    slot.c = [](avr_t*, avr_io_addr_t at, void* param) -> uint8_t {
        return (static_cast<Owner*>(param)->*method)(at);
    };
    slot.param = owner;
    return before;
}

template <auto method, class Owner>
void hookLine(avr_irq_t* line, Owner* owner) {
    avr_irq_register_notify(
        line,
        [](avr_irq_t*, uint32_t value, void* param) {
            (static_cast<Owner*>(param)->*method)(value);
        },
        owner);
}

// libsimavr knows a timer by function and parameter: starting it again moves it. The method
// gets the cycle it was due at and returns the next one, or 0.
template <auto method, class Owner>
avr_cycle_count_t timerCallback(avr_t*, avr_cycle_count_t due, void* param) {
    return (static_cast<Owner*>(param)->*method)(due);
}

template <auto method, class Owner>
void startTimer(avr_t* avr, uint64_t cycles, Owner* owner) {
    avr_cycle_timer_register(avr, cycles ? cycles : 1, timerCallback<method, Owner>, owner);
}

template <auto method, class Owner>
void startTimerAt(avr_t* avr, uint64_t cycle, Owner* owner) {
    startTimer<method>(avr, cycle > avr->cycle ? cycle - avr->cycle : 1, owner);
}

template <auto method, class Owner>
void stopTimer(avr_t* avr, Owner* owner) {
    avr_cycle_timer_cancel(avr, timerCallback<method, Owner>, owner);
}

// A peripheral by its kind ("uart", "timer", ...).
template <class Peripheral>
Peripheral* findPeripheral(avr_t* avr, const char* kind) {
    for (avr_io_t* io = avr->io_port; io; io = io->next)
        if (strcmp(io->kind, kind) == 0) return reinterpret_cast<Peripheral*>(io);
    return nullptr;
}

// One of several of a kind, by its one-letter name ('0'.. for timers, 'A'.. for ports).
template <class Peripheral>
Peripheral* findPeripheral(avr_t* avr, const char* kind, char name) {
    for (avr_io_t* io = avr->io_port; io; io = io->next) {
        auto* candidate = reinterpret_cast<Peripheral*>(io);
        if (strcmp(io->kind, kind) == 0 && candidate->name == name) return candidate;
    }
    return nullptr;
}

// The bits that a write to a flag register really writes: SBI touches the one it names, while
// libsimavr reads and writes back the whole register (datasheet 13.2.3, note on CBI and SBI).
inline uint8_t writtenBits(const avr_t* avr, uint8_t value) {
    const bool sbi = avr->flash[avr->pc + 1] == 0x9A;
    return sbi ? static_cast<uint8_t>(1 << (avr->flash[avr->pc] & 7)) : value;
}

// What stands between the library and the chip's datasheet, one subject each.
class Mend {
public:
    virtual ~Mend() = default;
    virtual void reset() {}  // after every reset, the peripherals' own included
};

}  // namespace simulator
