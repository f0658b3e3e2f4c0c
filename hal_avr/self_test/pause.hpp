// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <stdint.h>

#include "hal/clock.hpp"

namespace self_test {

inline void pause_ms(uint16_t time_ms) {
    const uint32_t begin_ms = hal::now_ms();
    while (hal::now_ms() - begin_ms < time_ms) {
    }
}

}  // namespace self_test
