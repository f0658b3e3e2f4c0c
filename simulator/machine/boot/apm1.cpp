// SPDX-License-Identifier: GPL-3.0-or-later
// Knows no watchdog: one that is on stays on, and bites while the bootloader listens for a
// programmer, for ever. That is a second (Arduino's stk500boot for the ATmega2560).
#include "simulator/machine/boot/boot.hpp"

void boot() {
    __asm__ volatile("clr __zero_reg__");
    MCUSR = 0;
    _delay_ms(kStartUp_ms + 1000);
    startApplication();
}
