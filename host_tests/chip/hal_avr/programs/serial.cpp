// SPDX-License-Identifier: GPL-3.0-or-later
// Sends back what comes in, on all ports; and what happens when nobody reads.
#include "hal/serial.hpp"

#include <avr/interrupt.h>

#include "hal/interrupts.hpp"
#include "report.hpp"

namespace hal {
bool imuDataReady() { return false; }
}  // namespace hal

using hal::Port;

static void echo(Port port) {
    uint8_t bytes[16];
    uint8_t size = 0;
    const uint8_t room = hal::serialRoom(port);
    while (size < sizeof(bytes) && size < room && hal::serialRead(port, bytes[size])) ++size;
    if (size > 0 && !hal::serialWrite(port, bytes, size)) report(0x7F, size);
}

static void echoFor(uint16_t time_ms) {
    const uint32_t start_ms = hal::now_ms();
    while (hal::now_ms() - start_ms < time_ms) {
        echo(Port::link0);
        echo(Port::gps);
        echo(Port::link1);
    }
}

static void writesAllOrNothing() {
    uint8_t bytes[200] = {};
    report(4, hal::serialRoom(Port::link1));
    report(5, hal::serialWrite(Port::link1, bytes, 200));
    report(6, hal::serialWrite(Port::link1, bytes, 60));
    report(7, hal::serialRoom(Port::link1));
}

// As when the last byte has gone out before the interrupt is switched on for it.
static void startsWithNothingToSend() {
    wait_ms(20);
    report(10, hal::serialWrite(Port::link1, nullptr, 0));
    wait_ms(20);
    report(11, hal::serialRoom(Port::link1));
}

int main() {
    board::start();
    report(0x20, hal::usbConnected());
    hal::serialOpen(Port::link0, 115200);
    hal::serialOpen(Port::gps, 38400);
    hal::serialOpen(Port::link1, 57600);
    report(1, 0);
    echoFor(300);
    report(2, hal::serialLost(Port::link0));
    wait_ms(100);  // 200 bytes come and nobody reads
    report(3, hal::serialAvailable(Port::link0));
    report(0x21, hal::serialLost(Port::link0));
    report(0x23, hal::serialAvailable(Port::gps));
    report(0x24, hal::serialLost(Port::gps));
    report(0x25, hal::serialRoom(Port::gps));
    {
        hal::Locked locked;
        const uint16_t start = TCNT5;
        while (static_cast<uint16_t>(TCNT5 - start) < 2 * 1000) {
        }  // 1 ms: eleven bytes come and three fit into the receiver
    }
    wait_ms(20);
    report(0x22, hal::serialLost(Port::link1));
    writesAllOrNothing();
    startsWithNothingToSend();
    hal::serialOpen(Port::link0, 57600);
    report(8, hal::serialAvailable(Port::link0));
    echoFor(100);
    report(9, hal::serialLost(Port::link0));
    for (;;) hal::idle(nothingWaits);
}
