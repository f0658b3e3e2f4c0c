// SPDX-License-Identifier: GPL-3.0-or-later
// Servo pulses, while the EEPROM is read without a pause: each read halts the processor for four
// cycles.
#include "servo_pulses.hpp"

int main() {
    startServoPulses();
    for (;;) {
        EECR |= _BV(EERE);
        ++EEARL;
    }
}
