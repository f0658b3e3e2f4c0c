// SPDX-License-Identifier: GPL-3.0-or-later
// What an interrupt costs: libsimavr enters one in no time, the chip needs 5 cycles, and 5 more
// out of sleep (datasheet 7.8.1). Counts the cycles of every vector, those nested in it left out.
#pragma once
#include <array>
#include <vector>

#include "simulator/machine/hooks.hpp"

namespace simulator {

class Interrupts : public Mend {
public:
    struct Count {
        uint64_t runs = 0;
        uint64_t cycles = 0;
        uint32_t max_cycles = 0;
    };

    explicit Interrupts(avr_t* avr);
    void reset() override { nesting_.clear(); }

    void slept() { from_sleep_ = true; }
    const Count& count(int vector) const { return counts_[vector]; }
    uint64_t cycles() const { return cycles_; }  // of all that have ended
    bool running() const { return !nesting_.empty(); }
    uint64_t entered() const { return entered_; }

    static constexpr int kVectors = 57;

private:
    struct Vector {  // what the hook of one vector needs to know
        Interrupts* owner;
        int number;
        void changed(uint32_t running) {
            if (running) {
                owner->enter(number);
            } else {
                owner->leave();
            }
        }
    };
    struct Running {
        int vector;
        uint64_t since;
        uint64_t nested_cycles;
    };

    void enter(int vector);
    void leave();

    avr_t* avr_;
    bool from_sleep_ = false;
    uint64_t cycles_ = 0, entered_ = 0;
    std::array<Vector, kVectors> vectors_ = {};
    std::array<Count, kVectors> counts_ = {};
    std::vector<Running> nesting_;
};

}  // namespace simulator
