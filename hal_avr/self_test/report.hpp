// SPDX-License-Identifier: GPL-3.0-or-later
// The report of the self-test: lines of text over USB, 115200 baud. Each call waits until the port
// has room.
#pragma once
#include <avr/pgmspace.h>
#include <stdint.h>

namespace self_test {

void openReport();
void text(const char* in_flash);  // TEXT("...")
void number(uint32_t value);
void microseconds(uint16_t halves);  // of half microseconds: "900.5"
void endLine();

// A line of a name and a number.
void line(const char* in_flash, uint32_t value);

}  // namespace self_test

#define TEXT(literal) PSTR(literal)
