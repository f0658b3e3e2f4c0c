// SPDX-License-Identifier: GPL-3.0-or-later
// Pins and bus: levels after start, bytes at both rates.
#include "report.hpp"

namespace hal {
bool imuDataReady() { return false; }
}  // namespace hal

int main() {
    using board::SensorBus;
    board::start();
    report(1, 0);
    board::LedA::on();
    board::Relay::high();
    report(2, 0);
    SensorBus::fast();
    board::ImuSelect::low();
    report(3, SensorBus::transfer(0xF5));
    SensorBus::transfer(0x11);
    hal::trace(4);
    report(5, 0);
    SensorBus::slow();
    report(6, SensorBus::transfer(0x22));
    board::ImuSelect::high();
    report(7, 0);
    for (;;) hal::idle(nothingWaits);
}
