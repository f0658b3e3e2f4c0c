// SPDX-License-Identifier: GPL-3.0-or-later
// Counts data-ready edges, while the bus is locked now and then.
#include "report.hpp"

static volatile uint16_t samples;

namespace hal {
bool imuDataReady() {
    samples = samples + 1;
    return true;
}
}  // namespace hal

int main() {
    using board::SensorBus;
    board::start();
    SensorBus::fast();
    for (;;) {
        report(1, samples);
        {
            const SensorBus::Lock locked;
            report(2, samples);
            { const SensorBus::Lock twice; }
            board::BarometerSelect::low();
            for (uint8_t i = 0; i < 20; ++i) SensorBus::transfer(i);
            board::BarometerSelect::high();
            report(3, samples);
        }
    }
}
