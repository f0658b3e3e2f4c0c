// SPDX-License-Identifier: GPL-3.0-or-later
// Reports each input's sum after one scan, then scans at 50 Hz.
#include "hal/analog.hpp"

#include "report.hpp"

namespace hal {
bool imuDataReady() { return false; }
}  // namespace hal

static void take() {
    for (uint8_t i = 0; i < hal::kAnalogs; ++i) {
        const hal::AnalogSum taken = hal::analogTake(static_cast<hal::Analog>(i));
        report(static_cast<uint8_t>(0x10 + i), taken.count);
        report(static_cast<uint8_t>(0x20 + i), taken.sum);
    }
}

int main() {
    board::start();
    take();
    report(1, 0);
    hal::analogScan();
    hal::analogScan();  // the first still runs
    wait_ms(5);
    take();
    report(2, 0);
    for (uint8_t i = 0; i < 40; ++i) {  // nobody takes them
        hal::analogScan();
        wait_ms(5);
    }
    take();
    report(3, 0);
    for (;;) hal::idle(nothingWaits);
}
