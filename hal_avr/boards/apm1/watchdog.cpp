// SPDX-License-Identifier: GPL-3.0-or-later
#include <avr/interrupt.h>

#include "restart.hpp"

ISR(WDT_vect) { avr::restart(); }
