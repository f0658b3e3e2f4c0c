// SPDX-License-Identifier: GPL-3.0-or-later
// A master that does not care whether its address was refused: goes on to write, and to read. Then
// one transfer to a device that is there, during which the test disturbs the bus.
#include <util/twi.h>

#include "report.hpp"

static bool go(uint8_t control) {
    TWCR = control | _BV(TWINT) | _BV(TWEN);
    for (uint16_t i = 0; i < 4000; i++)
        if (TWCR & _BV(TWINT)) return true;
    return false;
}
static void begin(uint8_t address_rw) {
    go(_BV(TWSTA));
    TWDR = address_rw;
    go(0);
}
static void stop() {
    TWCR = _BV(TWINT) | _BV(TWEN) | _BV(TWSTO);
    for (uint16_t i = 0; i < 4000 && (TWCR & _BV(TWSTO)); i++) asm volatile("");
}

int main() {
    TWBR = 12;
    begin(0x44 << 1);
    report(1, TW_STATUS);
    TWDR = 0x12;
    go(0);
    report(2, TW_STATUS);
    stop();
    begin(0x44 << 1 | 1);
    report(3, TW_STATUS);
    report(4, go(_BV(TWEA)));
    stop();
    begin(0x1E << 1);
    report(5, TW_STATUS);
    TWDR = 0x12;
    report(6, go(0));
    report(7, TW_STATUS);
    stop();
    report(8, TWCR);
    for (;;) {
    }
}
