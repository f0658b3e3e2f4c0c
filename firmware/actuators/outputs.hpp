// SPDX-License-Identifier: GPL-3.0-or-later
// From the surfaces to the servo pulses. Outputs 1..4 are aileron, elevator, throttle, rudder;
// 5..8 follow the receiver. A mission command may hold any of them, but never the throttle.
#pragma once
#include <stdint.h>

namespace firmware {
namespace actuators {

// RCn_FUNCTION, and the camera's.
constexpr int8_t kFlapFunction = 2, kAutoFlapFunction = 3;
constexpr int8_t kLeftFlaperonFunction = 24, kRightFlaperonFunction = 25;
bool isOutputFunction(int8_t number);

void startOutputs();  // all eight at rest
void runOutputs();    // 100 Hz, after runAttitudeControl

// Outputs are numbered 1..8 as on the board. The output belongs to the caller until it is
// released; 0 us: no pulse. False: not an output that can be given away, nothing changed.
bool outputOverride(uint8_t output, uint16_t pulse_us);
void outputRelease(uint8_t output);
void outputReleaseAll();    // at a change of mode
void holdSurfacesAtEnds();  // nose up, to the right: a spiral, until a change of mode

// From the interrupt that flies while the program hangs; `output` from 0. The program knows of it
// when it runs again.
void outputPassStick(uint8_t output, uint16_t pulse_us);

uint16_t outputPulse_us(uint8_t output);  // present pulse, 0: silent

}  // namespace actuators
}  // namespace firmware
