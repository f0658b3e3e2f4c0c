// SPDX-License-Identifier: GPL-3.0-or-later
#include "fakes/clock.hpp"

#include "hal/clock.hpp"

namespace {
uint64_t now = 0;
uint32_t idle_step_us = 100;
}  // namespace

namespace fakes {

void setTime_us(uint64_t now_us) { now = now_us; }
void advance_us(uint64_t by_us) { now += by_us; }
uint64_t time_us() { return now; }
void setIdleStep_us(uint32_t step_us) { idle_step_us = step_us; }

void resetClock() {
    now = 0;
    idle_step_us = 100;
}

}  // namespace fakes

namespace hal {

uint32_t now_us() { return static_cast<uint32_t>(now); }
uint16_t ticks() { return static_cast<uint16_t>(now * kTicksPerUs); }
uint32_t now_ms() { return static_cast<uint32_t>(now / 1000); }

// There are no frames.
void beginFrame() {}
uint32_t frame_ms() { return now_ms(); }

void idle(bool (*work_waits)()) {
    if (!work_waits()) now += idle_step_us;
}

}  // namespace hal
