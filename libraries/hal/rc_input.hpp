// SPDX-License-Identifier: GPL-3.0-or-later
// The receiver's pulses, decoded from the PPM-sum of the on-board encoder.
#pragma once
#include <stdint.h>

namespace hal {

constexpr uint8_t kRcChannels = 8;

// Copies the newest frame, 0.5 us steps halved to us, not clamped; channels the frame did not have
// keep 0. True once for every frame received; false: there is none, and nothing need be copied.
bool rcRead(uint16_t (&pulse_us)[kRcChannels]);

// The newest frame that had as many pulses as its transmitter usually sends, known when the next
// one begins. For switches: an edge too many or too few gives a channel its neighbour's pulse. True
// once for each; false: nothing is copied.
bool rcReadWhole(uint16_t (&pulse_us)[kRcChannels]);

// Of the newest frame, for whoever is in an interrupt; 0: the frame did not have it.
uint16_t rcPulse_us(uint8_t channel);

uint32_t rcAge_us();  // since the last complete frame; large before the first

}  // namespace hal
