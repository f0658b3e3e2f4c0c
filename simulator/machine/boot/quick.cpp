// SPDX-License-Identifier: GPL-3.0-or-later
// Switches the watchdog off and takes the cause away, without waiting for anybody.
#include "simulator/machine/boot/boot.hpp"

void boot() {
    __asm__ volatile("clr __zero_reg__");
    wdt_reset();
    MCUSR = 0;
    WDTCSR |= (1 << WDCE) | (1 << WDE);
    WDTCSR = 0;
    _delay_ms(kStartUp_ms);
    startApplication();
}
