// SPDX-License-Identifier: GPL-3.0-or-later
// An interrupt-driven master: writes, reads after a repeated start, calls a missing address.
#include <util/twi.h>

#include "report.hpp"

volatile uint8_t address, pointer, value, writes, wanted, got, result, done;
volatile uint8_t bytes[8];

static const uint8_t kGo = _BV(TWINT) | _BV(TWEN) | _BV(TWIE);

static void finish(uint8_t status) {
    result = status;
    TWCR = _BV(TWINT) | _BV(TWEN) | _BV(TWSTO);
    done = 1;
}

ISR(TWI_vect) {
    const uint8_t status = TW_STATUS;
    if (status == TW_START) {
        TWDR = address << 1;
        TWCR = kGo;
    } else if (status == TW_MT_SLA_ACK) {
        TWDR = pointer;
        TWCR = kGo;
    } else if (status == TW_MT_DATA_ACK && writes) {
        writes = 0;
        TWDR = value;
        TWCR = kGo;
    } else if (status == TW_MT_DATA_ACK && wanted) {
        TWCR = kGo | _BV(TWSTA);
    } else if (status == TW_REP_START) {
        TWDR = static_cast<uint8_t>(address << 1 | 1);
        TWCR = kGo;
    } else if (status == TW_MR_SLA_ACK) {
        TWCR = wanted > 1 ? kGo | _BV(TWEA) : kGo;
    } else if (status == TW_MR_DATA_ACK) {
        bytes[got++] = TWDR;
        TWCR = got + 1 < wanted ? kGo | _BV(TWEA) : kGo;
    } else {
        if (status == TW_MR_DATA_NACK) bytes[got++] = TWDR;
        finish(status);
    }
}

static void run(uint8_t at, uint8_t reg, uint8_t write, uint8_t read) {
    address = at;
    pointer = reg;
    writes = write;
    wanted = read;
    got = done = 0;
    TWCR = kGo | _BV(TWSTA);
    while (!done) {
    }
}

int main() {
    TWBR = 12;  // 400 kHz
    sei();
    value = 0x70;
    report(1, 0);
    run(0x1E, 2, 1, 0);
    report(2, result);
    run(0x1E, 3, 0, 6);
    report(3, result);
    report(4, static_cast<uint16_t>(bytes[0] << 8 | bytes[5]));
    run(0x44, 0, 0, 1);
    report(5, result);
    while (TWCR & _BV(TWSTO)) {
    }
    report(6, TWCR);
    TWCR = kGo | _BV(TWSTA);  // the test has hung the bus by now
    for (uint16_t i = 0; i < 10000; i++) asm volatile("");
    report(7, TWCR);
    TWCR = 0;
    report(8, TWCR);
    for (;;) {
    }
}
