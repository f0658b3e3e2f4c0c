// SPDX-License-Identifier: GPL-3.0-or-later
// A row of a board's table of analogue inputs.
#pragma once
#include <stdint.h>

namespace avr {

struct AnalogStep {
    uint8_t mux;   // MUX4..0, with MUX5 as bit 5
    uint8_t drop;  // conversions thrown away after the switch to this input, until it has settled
    uint8_t take;
};

}  // namespace avr
