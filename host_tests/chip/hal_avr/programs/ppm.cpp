// SPDX-License-Identifier: GPL-3.0-or-later
// Reports every frame of the receiver, and its age every 10 ms.
#include "hal/rc_input.hpp"

#include "report.hpp"

namespace hal {
bool imuDataReady() { return false; }
}  // namespace hal

int main() {
    board::start();
    uint16_t pulse_us[hal::kRcChannels];
    report(0x30, hal::rcAge_us() == UINT32_MAX);
    uint32_t next_ms = 10;
    for (;;) {
        if (hal::rcRead(pulse_us)) {
            for (uint8_t i = 0; i < hal::kRcChannels; ++i) report(i + 1, pulse_us[i]);
            report(0x20, 0);
        }
        if (hal::now_ms() >= next_ms) {
            next_ms += 10;
            const uint32_t age_us = hal::rcAge_us();
            report(0x21, age_us / 100 > 0xFFFF ? 0xFFFF : static_cast<uint16_t>(age_us / 100));
        }
    }
}
