// SPDX-License-Identifier: GPL-3.0-or-later
// USART3 as SPI master: bytes against a counter, in peace and among interrupts; then the DataFlash
// driver on a chip.
#include <avr/interrupt.h>

#include "drivers/at45db.hpp"
#include "hal/serial.hpp"
#include "report.hpp"

namespace hal {
bool imuDataReady() { return false; }
}  // namespace hal

using board::FlashBus;
using board::FlashSelect;

drivers::At45db<FlashBus, FlashSelect, board::FlashReset> chip;

static uint8_t bytes[100];

// The other end answers with the number of the byte since the select.
static uint16_t wrongAnswers(uint8_t first) {
    uint16_t wrong = 0;
    for (uint8_t i = 0; i < sizeof bytes; ++i) wrong += bytes[i] != static_cast<uint8_t>(first + i);
    return wrong;
}

static void exchangeInPeace() {
    for (uint8_t i = 0; i < sizeof bytes; ++i) bytes[i] = i;
    FlashSelect::low();
    cli();
    report(1, 0);
    FlashBus::send(bytes, sizeof bytes);
    report(2, 0);
    FlashBus::receive(bytes, sizeof bytes);
    report(3, 0);
    sei();
    report(4, wrongAnswers(sizeof bytes));
    FlashBus::send(bytes, 1);
    FlashBus::receive(bytes, 1);
    report(5, bytes[0]);
    FlashSelect::high();
}

static void exchangeAmongInterrupts() {
    uint16_t wrong = 0;
    for (uint8_t round = 0; round < 200; ++round) {
        FlashSelect::low();
        FlashBus::receive(bytes, sizeof bytes);
        wrong += wrongAnswers(0);
        FlashBus::send(bytes, sizeof bytes);
        FlashBus::receive(bytes, sizeof bytes);
        wrong += wrongAnswers(200);
        FlashSelect::high();
    }
    report(6, wrong);
}

static uint16_t now_ms() { return static_cast<uint16_t>(hal::now_ms()); }

static void useChip() {
    chip.start(now_ms());
    while (!chip.known()) chip.step(now_ms());
    report(10, chip.pages());
    for (uint8_t i = 0; i < sizeof bytes; ++i) bytes[i] = i ^ 0x5A;
    report(11, static_cast<uint16_t>(chip.fill(1, 400, bytes, sizeof bytes, now_ms())));
    const uint16_t from_ms = now_ms();
    report(12, static_cast<uint16_t>(chip.store(1, 8191, from_ms)));
    report(13, static_cast<uint16_t>(chip.read(8191, 400, bytes, 14, now_ms())));
    cli();
    report(18, 0);
    const bool busy = chip.busy(from_ms);
    report(19, busy);
    sei();
    while (chip.busy(now_ms())) {
    }
    report(14, now_ms() - from_ms);
    for (uint8_t& byte : bytes) byte = 0;
    cli();
    report(15, 0);
    const core::Status status = chip.read(8191, 400, bytes, 14, from_ms);
    report(16, static_cast<uint16_t>(status));
    sei();
    uint16_t wrong = 0;
    for (uint8_t i = 0; i < 14; ++i) wrong += bytes[i] != (i ^ 0x5A);
    report(17, wrong);
}

int main() {
    board::start();
    hal::serialOpen(hal::Port::link0, 115200);
    exchangeInPeace();
    exchangeAmongInterrupts();
    useChip();
    for (;;) hal::idle(nothingWaits);
}
