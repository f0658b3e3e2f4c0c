// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <stdint.h>

namespace hal {

// Bytes of RAM between the variables and the stack as deep as it is now; 0: not to be known.
uint16_t freeMemory();

}  // namespace hal
