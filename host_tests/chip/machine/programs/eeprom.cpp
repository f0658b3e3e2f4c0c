// SPDX-License-Identifier: GPL-3.0-or-later
// Polled writes and reads, then four bytes through EE_READY.
#include <avr/eeprom.h>

#include "report.hpp"

static uint8_t* at(uint16_t address) { return reinterpret_cast<uint8_t*>(address); }

volatile uint8_t queued, calls;
ISR(EE_READY_vect) {
    calls++;
    if (queued == 4) {
        EECR &= ~_BV(EERIE);
        return;
    }
    EEAR = 0x200 + queued;
    EEDR = 0x30 + queued;
    EECR |= _BV(EEMPE);
    EECR |= _BV(EEPE);
    queued++;
}

int main() {
    report(1, eeprom_read_byte(at(0x10)));
    eeprom_write_byte(at(0x11), 0xA5);
    report(2, 0);
    eeprom_write_byte(at(0x12), 0xA6);
    report(3, 0);
    eeprom_busy_wait();
    report(4, eeprom_read_byte(at(0x11)));
    EEAR = 0x13;
    EEDR = 0x77;
    EECR |= _BV(EEPE);  // without EEMPE: refused
    report(5, EECR);
    sei();
    report(6, 0);
    EECR |= _BV(EERIE);
    while (EECR & _BV(EERIE)) {
    }
    report(7, calls);
    for (;;) {
    }
}
