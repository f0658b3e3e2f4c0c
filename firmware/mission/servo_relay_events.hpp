// SPDX-License-Identifier: GPL-3.0-or-later
// Outputs that mission commands move: held ones, and the one event that repeats. A repeat goes on
// over NAVs and modes until it is counted out, replaced or stopped, the mission restarts, or the
// airplane is disarmed.
#pragma once
#include <stdint.h>

namespace firmware {
namespace mission {

constexpr uint8_t kRelayOutput = 9;  // 1..8 are the servo outputs

// The output belongs to the mission until the mode changes. Refusals are reported.
void holdOutput(uint8_t output, uint16_t pulse_us);

// 0 and 1 are the ends of the channel's travel.
uint16_t servoPulse_us(uint8_t output, int32_t value);

// `cycles` times half at the value, half at what was read when it began; the relay is inverted.
void repeatCycles(uint8_t output, uint16_t pulse_us, uint16_t cycles, uint8_t cycle_s);
// `count` times (0: for ever) to the value and one second later back, every `delay_s`.
void repeatToggles(uint8_t output, uint16_t pulse_us, uint16_t count, uint16_t delay_s);
void stopEvents();  // leaves the output at what was first read
bool eventRuns();

void runEvents();  // 10 Hz: the event that repeats

}  // namespace mission
}  // namespace firmware
