// SPDX-License-Identifier: GPL-3.0-or-later
// Time and rest. Defined by hal_avr/clock.cpp, simulator/native and host_tests/support/fakes.
#pragma once
#include <stdint.h>

namespace hal {

uint32_t now_us();  // since reset; wraps after 71.6 minutes: compare differences only
uint32_t now_ms();  // since reset; wraps after 49.7 days
// now_ms() at the last beginFrame(), in a fifth of its 90 cycles: what a frame measures and reports
// is of its beginning.
void beginFrame();
uint32_t frame_ms();

// For what is timed often and takes less than 32 ms, after which it wraps.
uint16_t ticks();
constexpr uint8_t kTicksPerUs = 2;

// Sleeps through interrupts until `work_waits` says that there is something to do. It is asked at
// once and after each that may bring work (a byte of a link, a sample): nothing that comes between
// the question and the sleep is slept over. It must be quick. Returns after 4 ms at the latest, so
// that a silent sensor cannot stop the frames.
void idle(bool (*work_waits)());

}  // namespace hal
