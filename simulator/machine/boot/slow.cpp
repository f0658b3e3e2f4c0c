// SPDX-License-Identifier: GPL-3.0-or-later
// As the second board's, with the time that its bootloader takes where no USB is plugged in: 400,
// 200 and 500 ms of flashes and waiting, but nothing after a watchdog's reset.
#include "simulator/machine/boot/boot.hpp"

constexpr uint16_t kFlashes_ms = 400 + 200 + 500;

void boot() {
    __asm__ volatile("clr __zero_reg__");
    wdt_reset();
    const bool by_watchdog = MCUSR & (1 << WDRF);
    MCUSR = 0;
    WDTCSR |= (1 << WDCE) | (1 << WDE);
    WDTCSR = 0;
    if (!by_watchdog) _delay_ms(kFlashes_ms);
    _delay_ms(kStartUp_ms);
    startApplication();
}
