// SPDX-License-Identifier: GPL-3.0-or-later
// The queue: order, reading one's own writes, the waiting reader, what is refused.
#include "hal/eeprom.hpp"

#include "report.hpp"

namespace hal {
bool imuDataReady() { return false; }
}  // namespace hal

static uint16_t status(core::Status s) { return static_cast<uint16_t>(s); }

static uint8_t byteAt(uint16_t address) {
    uint8_t byte = 0;
    while (hal::eepromRead(address, &byte, 1) == core::Status::busy) {
    }
    return byte;
}

static void drain() {
    while (!hal::eepromDrained()) hal::idle(nothingWaits);
}

static void writesInOrder() {
    const uint8_t first[] = {1, 2, 3, 4};
    const uint8_t second[] = {9, 3};
    report(1, status(hal::eepromWrite(100, first, 4)));
    report(1, status(hal::eepromWrite(101, second, 2)));
    report(2, byteAt(101));  // waits for a byte in flight, and finds the newest
    report(3, hal::eepromDrained());
    drain();
    report(4, hal::eepromDrained());
}

static void readerIsServedNextTime() {
    uint8_t bytes[8];
    for (uint8_t i = 0; i < 8; ++i) bytes[i] = static_cast<uint8_t>(i + 0x40);
    if (hal::eepromWrite(200, bytes, 8) != core::Status::ok) report(0x7F, 0);
    wait_ms(1);
    report(0x10, status(hal::eepromRead(200, bytes, 8)));  // busy
    wait_ms(20);
    report(0x11, status(hal::eepromRead(100, bytes, 2)));  // another reader may, too
    wait_ms(20);
    report(0x12, hal::eepromDrained());  // but the queue still rests
    report(0x13, status(hal::eepromRead(200, bytes, 8)));
    report(0x14, bytes[7]);
    wait_ms(1);
    report(0x15, status(hal::eepromRead(300, bytes, 1)));  // never comes back
    wait_ms(90);
    report(0x16, hal::eepromDrained());
    wait_ms(130);
    report(0x17, hal::eepromDrained());
}

static void refuses() {
    uint8_t bytes[33] = {};
    uint8_t in[6];
    report(0x20, status(hal::eepromWrite(0, bytes, 33)));
    report(0x21, status(hal::eepromWrite(4090, bytes, 7)));
    report(0x22, status(hal::eepromRead(4096, in, 1)));
    report(0x23, status(hal::eepromRead(4090, in, 6)));
    report(0x24, status(hal::eepromWrite(0, bytes, 30)));
    report(0x25, status(hal::eepromWrite(40, bytes, 5)));
    drain();
}

static void samePageAgain() {
    const uint8_t same[] = {1, 9, 3, 4};
    report(0x30, 0);
    if (hal::eepromWrite(100, same, 4) != core::Status::ok) report(0x7F, 1);
    drain();
    report(0x31, 0);
}

int main() {
    board::start();
    writesInOrder();
    readerIsServedNextTime();
    refuses();
    samePageAgain();
    report(0x40, 0);
    uint8_t record[14];
    for (uint8_t value = 1;; ++value) {  // for the power cut: records, in order
        for (uint8_t& byte : record) byte = value;
        while (hal::eepromWrite(1000, record, 14) != core::Status::ok) {
            hal::idle(nothingWaits);
        }
    }
}
