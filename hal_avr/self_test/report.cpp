// SPDX-License-Identifier: GPL-3.0-or-later
#include "self_test/report.hpp"

#include <stdlib.h>
#include <string.h>

#include "hal/serial.hpp"

namespace self_test {

namespace {

void write(const char* bytes, uint8_t size) {
    while (!hal::serialWrite(hal::Port::link0, bytes, size)) {
    }
}

}  // namespace

void openReport() { hal::serialOpen(hal::Port::link0, 115200); }

void text(const char* in_flash) {
    for (char next; (next = static_cast<char>(pgm_read_byte(in_flash))) != 0; ++in_flash)
        write(&next, 1);
}

void number(uint32_t value) {
    char digits[11];
    ultoa(value, digits, 10);
    write(digits, static_cast<uint8_t>(strlen(digits)));
}

void microseconds(uint16_t halves) {
    number(halves / 2);
    text((halves & 1) != 0 ? TEXT(".5") : TEXT(".0"));
}

void endLine() { text(TEXT("\r\n")); }

void line(const char* in_flash, uint32_t value) {
    text(in_flash);
    number(value);
    endLine();
}

}  // namespace self_test
