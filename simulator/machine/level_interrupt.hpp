// SPDX-License-Identifier: GPL-3.0-or-later
// An interrupt request that is a level: it stands as long as its flag and its mask do, so it comes
// again after RETI, or at once when its handler allows interrupts. libsimavr raises each request
// once.
#pragma once
#include "simulator/machine/hooks.hpp"

namespace simulator {

// A vector may stand in libsimavr's queue of 64 although it was cleared; put in again at every
// change of mask it would fill the queue, and what finds the queue full never comes.
inline void requestInterrupt(avr_t* avr, avr_int_vector_t* vector) {
    const avr_int_pending_t& queue = avr->interrupts.pending;
    for (unsigned i = queue.read; i != queue.write; i = (i + 1) % 64) {
        if (queue.buffer[i] != vector) continue;
        vector->pending = 1;
        if (avr->sreg[S_I] && avr->interrupt_state == 0) avr->interrupt_state = 1;
        if (avr->state == cpu_Sleeping) avr->state = cpu_Running;
        return;
    }
    avr_raise_interrupt(avr, vector);
}

// Removes it from the queue as well: an entry there prevents the core from going to sleep once.
inline void withdrawInterrupt(avr_t* avr, avr_int_vector_t* vector) {
    avr_clear_interrupt(avr, vector);
    avr_int_pending_t& queue = avr->interrupts.pending;
    unsigned to = queue.read;
    for (unsigned i = queue.read; i != queue.write; i = (i + 1) % 64) {
        if (queue.buffer[i] == vector) continue;
        queue.buffer[to] = queue.buffer[i];
        to = (to + 1) % 64;
    }
    queue.write = static_cast<FIFO_CURSOR_TYPE>(to);
    if (to == queue.read && avr->interrupt_state > 0) avr->interrupt_state = 0;
}

template <class Owner, bool (Owner::*flag)() const>
class LevelInterrupt {
public:
    LevelInterrupt(avr_t* avr, avr_int_vector_t* vector, Owner* owner)
        : avr_(avr), vector_(vector), owner_(owner) {
        vector->raise_sticky = 1;
        hookLine<&LevelInterrupt::changed>(vector->irq + AVR_INT_IRQ_PENDING, this);
    }

    // To be called after the flag or the mask may have changed.
    void refresh() {
        const bool wanted = avr_regbit_get(avr_, vector_->enable) && (owner_->*flag)();
        if (wanted == bool(vector_->pending)) return;
        if (wanted) {
            requestInterrupt(avr_, vector_);
        } else {
            withdrawInterrupt(avr_, vector_);
        }
    }

private:
    void changed(uint32_t pending) {
        if (!pending) refresh();  // taken, or cleared
    }

    avr_t* avr_;
    avr_int_vector_t* vector_;
    Owner* owner_;
};

}  // namespace simulator
