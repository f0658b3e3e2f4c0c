// SPDX-License-Identifier: GPL-3.0-or-later
#include "hal/mark.hpp"

#include <avr/io.h>

namespace hal {

void mark(uint8_t value) { GPIOR0 = value; }
void markItem(uint8_t value, uint8_t item) {
    GPIOR1 = item;
    GPIOR0 = value;
}

}  // namespace hal
