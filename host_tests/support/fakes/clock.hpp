// SPDX-License-Identifier: GPL-3.0-or-later
// The tests' clock: it moves only on request.
#pragma once
#include <stdint.h>

namespace fakes {

void setTime_us(uint64_t now_us);
void advance_us(uint64_t by_us);
inline void advance_ms(uint32_t by_ms) { advance_us(uint64_t{1000} * by_ms); }
uint64_t time_us();  // not wrapped

// hal::idle lets this much time pass when no work waits; 100 us unless set.
void setIdleStep_us(uint32_t step_us);

void resetClock();

}  // namespace fakes
