// SPDX-License-Identifier: GPL-3.0-or-later
// Cycles in which the processor runs no instruction of its own: it is halted, or enters an
// interrupt.
#pragma once
#include <simavr/sim_avr.h>

namespace simulator {

// libsimavr counts what it runs until its next cycle timer: uncounted waits would make that late.
inline void wait(avr_t* avr, uint64_t cycles) {
    avr->cycle += cycles;
    avr->run_cycle_count = avr->run_cycle_count > cycles ? avr->run_cycle_count - cycles : 1;
}

}  // namespace simulator
