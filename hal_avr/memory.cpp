// SPDX-License-Identifier: GPL-3.0-or-later
#include "hal/memory.hpp"

#include <avr/io.h>

extern uint8_t __heap_start;  // the linker's end of the variables

namespace hal {

uint16_t freeMemory() { return SP - reinterpret_cast<uint16_t>(&__heap_start); }

}  // namespace hal
