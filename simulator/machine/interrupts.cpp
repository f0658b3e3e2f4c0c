// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/machine/interrupts.hpp"

#include <algorithm>

#include "simulator/machine/wait.hpp"

namespace simulator {

constexpr uint64_t kEntry = 5, kWakeUp = 5, kReti = 5;  // cycles, 22-bit program counter

Interrupts::Interrupts(avr_t* avr) : avr_(avr) {
    for (int i = 0; i < avr->interrupts.vector_count; i++) {
        avr_int_vector_t* vector = avr->interrupts.vector[i];
        Vector& hook = vectors_.at(vector->vector);
        hook = {this, vector->vector};
        hookLine<&Vector::changed>(vector->irq + AVR_INT_IRQ_RUNNING, &hook);
    }
}

void Interrupts::enter(int vector) {
    ++entered_;
    nesting_.push_back({vector, avr_->cycle, 0});
    const uint64_t cost = kEntry + (from_sleep_ ? kWakeUp : 0);
    from_sleep_ = false;
    wait(avr_, cost);
}

void Interrupts::leave() {
    if (nesting_.empty()) return;
    const Running ended = nesting_.back();
    nesting_.pop_back();
    const uint64_t whole = avr_->cycle + kReti - ended.since;
    const uint64_t own = whole - ended.nested_cycles;
    Count& count = counts_[ended.vector];
    count.runs++;
    count.cycles += own;
    count.max_cycles = std::max(count.max_cycles, static_cast<uint32_t>(own));
    cycles_ += own;
    if (!nesting_.empty()) nesting_.back().nested_cycles += whole;
}

}  // namespace simulator
