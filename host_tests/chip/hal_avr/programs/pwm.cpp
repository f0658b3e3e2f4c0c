// SPDX-License-Identifier: GPL-3.0-or-later
// Writes widths at every phase of the period, silences and wakes outputs.
#include "hal/servo_output.hpp"

#include "report.hpp"

namespace hal {
bool imuDataReady() { return false; }
}  // namespace hal

static void pause(uint8_t count) {
    while (count-- > 0) {
        for (volatile uint8_t i = 255; i > 0; --i) {
        }
    }
}

// 1000..2000 us in steps of 0.5 us, another at every call.
static uint16_t nextWidth() {
    static uint16_t step;
    step = static_cast<uint16_t>((step + 773) % 2001);
    return static_cast<uint16_t>(2000 + step);
}

static void changeAtEveryPhase() {
    for (uint16_t i = 0; i < 600; ++i) {
        for (uint8_t output = 0; output < hal::kServos; ++output) {
            hal::servoWrite(output, nextWidth());
        }
        pause(static_cast<uint8_t>(i));
    }
}

static void silenceAtEveryPhase() {
    for (uint8_t i = 0; i < 120; ++i) {
        hal::servoWrite(2, 3000);
        pause(static_cast<uint8_t>(2 * i));
        hal::servoWrite(2, 0);
        pause(static_cast<uint8_t>(100 + i));
    }
}

static void writeAll(uint16_t pulse_halfus) {
    for (uint8_t output = 0; output < hal::kServos; ++output) {
        hal::servoWrite(output, pulse_halfus);
    }
}

// As a program does that begins again through address 0.
static void startAgainAfter(uint16_t time_ms, uint8_t number) {
    hal::servoStart(50);
    wait_ms(3);
    writeAll(3000);
    wait_ms(time_ms);
    hal::servoStart(50);
    wait_ms(3);
    report(number, 0);
    writeAll(3000);
    wait_ms(50);
    report(number + 1, 0);
}

int main() {
    board::start();
    hal::servoStart(50);
    wait_ms(50);
    report(1, 0);  // silent so far
    for (uint8_t output = 0; output < hal::kServos; ++output) {
        hal::servoWrite(output, static_cast<uint16_t>(2000 + 201 * output));
    }
    wait_ms(100);
    report(2, hal::servoRead(3));
    changeAtEveryPhase();
    wait_ms(40);
    report(3, 0);
    for (uint8_t output = 0; output < hal::kServos; ++output) hal::servoWrite(output, 0);
    report(4, hal::servoRead(3));
    wait_ms(40);
    report(5, 0);
    silenceAtEveryPhase();
    wait_ms(40);
    report(6, 0);
    hal::servoStart(400);
    hal::servoWrite(0, 4400);
    hal::servoWrite(7, 6000);  // longer than the period
    wait_ms(100);
    report(7, hal::servoRead(7));
    startAgainAfter(38, 8);   // in the middle of a pulse that the period began
    startAgainAfter(41, 10);  // of one that the first writing began
    for (;;) hal::idle(nothingWaits);
}
