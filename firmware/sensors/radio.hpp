// SPDX-License-Identifier: GPL-3.0-or-later
// The pilot's sticks and switches: receiver pulses, or the ground station's in their place, scaled
// by RCn_MIN/TRIM/MAX/REV/DZ. With RUDDER_ONLY the yaw stick is
// that of roll, too.
#pragma once
#include <stdint.h>

namespace firmware {
namespace sensors {

void runRadio();  // 100 Hz, first of all: a stick must not wait

// Both switches are those of the last good frame: one whose throttle is not below THR_FS_VALUE.
// Position 1..6 of the mode switch (FLTMODE_CH), 0 when the pulse is no position or the radio is
// lost. Two equal readings in a row count.
uint8_t modeSwitchPosition();
// A switch on a channel, 1 to 8, is above 1750 us. Not on channel 0, nor with the radio lost.
bool switchIsUp(int8_t channel);
// Of a switch with three positions on a channel, 1 to 8. Unknown: never received, or the radio is
// lost.
enum class SwitchPosition : uint8_t { unknown, low, middle, high };
SwitchPosition switchPosition(uint8_t channel);

}  // namespace sensors
}  // namespace firmware
