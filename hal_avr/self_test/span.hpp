// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <stdint.h>

namespace self_test {

// The least and the most of what was taken; most is 0 while there was nothing.
struct Span {
    uint16_t least = 0xFFFF, most = 0;
    void take(uint16_t value) {
        if (value < least) least = value;
        if (value > most) most = value;
    }
};

}  // namespace self_test
