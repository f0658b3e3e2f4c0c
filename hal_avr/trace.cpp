// SPDX-License-Identifier: GPL-3.0-or-later
#include "hal/trace.hpp"

#include <avr/io.h>

#include "hal/interrupts.hpp"

namespace hal {

void trace(uint8_t value) { GPIOR0 = value; }
void traceItem(uint8_t value, uint8_t item) {
    Locked locked;  // interrupts keep a register there
    GPIOR1 = item;
    GPIOR0 = value;
}

}  // namespace hal
