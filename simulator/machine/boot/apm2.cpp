// SPDX-License-Identifier: GPL-3.0-or-later
// Goes on at once after a watchdog's reset, switches the watchdog off and takes the cause away.
// After any other it waits where no USB is plugged in for 400, 200 and 500 ms (ArduPilot's tree,
// APM2_2560_bootloader); where USB is, here, as long: nobody flashes an emulated board.
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
