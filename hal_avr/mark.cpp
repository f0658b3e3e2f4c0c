// SPDX-License-Identifier: GPL-3.0-or-later
#include "hal/mark.hpp"

#include <avr/io.h>

namespace hal {

void mark(uint8_t value) { GPIOR0 = value; }

}  // namespace hal
