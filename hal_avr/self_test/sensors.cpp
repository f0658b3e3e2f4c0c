// SPDX-License-Identifier: GPL-3.0-or-later
#include "board.hpp"
#include "hal/analog.hpp"
#include "hal/clock.hpp"
#include "hal/i2c.hpp"
#include "hal/imu_interrupt.hpp"
#include "self_test/parts.hpp"
#include "self_test/report.hpp"
#include "self_test/span.hpp"

namespace self_test {

namespace {

board::Inertial inertial;
board::Barometer barometer;

constexpr uint8_t kFrame_ms = 10;
constexpr uint16_t kFrames = 1000;
constexpr uint16_t kStartUp_ms = 1000;  // of both sensors: data sheets, and retries

// Between two looks at the clock nothing but interrupts takes time.
void watchInterrupts(uint32_t until_ms, Span& looks) {
    uint16_t last = hal::ticks();
    while (static_cast<int32_t>(hal::now_ms() - until_ms) < 0) {
        last = hal::ticks();
        for (uint8_t i = 0; i < 50; ++i) {
            const uint16_t now = hal::ticks();
            looks.take(now - last);
            last = now;
        }
    }
}

struct Counts {
    uint32_t inertial = 0, barometer = 0;
};

void step(Counts& counts) {
    inertial.step(hal::now_ms());
    drivers::ImuSums sums;
    if (inertial.take(sums)) counts.inertial += sums.periods;
    counts.barometer += barometer.step(hal::now_us());
    hal::analogScan();
}

// Steps both for this long, and watches the interrupts in between.
Counts run(uint16_t frames, Span& looks) {
    Counts counts;
    uint32_t next_ms = hal::now_ms();
    for (uint16_t i = 0; i < frames; ++i) {
        step(counts);
        next_ms += kFrame_ms;
        watchInterrupts(next_ms, looks);
    }
    return counts;
}

void report(const char* name, uint32_t count, uint16_t bad, uint16_t restarts) {
    text(name);
    number(count);
    text(TEXT(" bad "));
    number(bad);
    line(TEXT(" restarts "), restarts);
}

bool readsIdentification() {
    constexpr uint8_t kAddress = 0x1E, kFirst = 10;  // HMC5883L data sheet: 10 to 12 are "H43"
    uint8_t id[3] = {};
    while (!hal::i2cStart(hal::I2cUser::compass, kAddress, &kFirst, 1, sizeof id)) {
    }
    core::Status status;
    while ((status = hal::i2cResult(hal::I2cUser::compass, id, sizeof id)) == core::Status::busy) {
    }
    return status == core::Status::ok && id[0] == 'H' && id[1] == '4' && id[2] == '3';
}

}  // namespace

void startSensors() {
    inertial.start();
    barometer.start();
}

void testSupply() {
    constexpr uint8_t kReadings = 200;
    Span supply_mv;
    for (uint8_t i = 0; i < kReadings; ++i) {
        hal::analogScan();
        hal::AnalogSum sum;
        while ((sum = hal::analogTake(hal::Analog::board_voltage)).count == 0) {
        }
        supply_mv.take(static_cast<uint16_t>(1126400UL * sum.count / sum.sum));
    }
    text(TEXT("supply mV least "));
    number(supply_mv.least);
    text(TEXT(" most "));
    number(supply_mv.most);
    line(TEXT(" readings "), kReadings);
}

void testSensors() {
    Span looks;
    run(kStartUp_ms / kFrame_ms, looks);
    looks = {};
    const uint16_t before[] = {inertial.badReads(), inertial.restarts(), barometer.badReads(),
                               barometer.restarts()};
    const Counts counts = run(kFrames, looks);
    text(TEXT("interrupted us "));
    microseconds(looks.most - looks.least);
    endLine();
    report(TEXT("inertial samples "), counts.inertial, inertial.badReads() - before[0],
           inertial.restarts() - before[1]);
    report(TEXT("barometer readings "), counts.barometer, barometer.badReads() - before[2],
           barometer.restarts() - before[3]);
}

void testCompass() {
    constexpr uint8_t kTries = 100;
    uint8_t right = 0;
    for (uint8_t i = 0; i < kTries; ++i) right += readsIdentification();
    text(TEXT("compass asked "));
    number(kTries);
    line(TEXT(" right "), right);
}

}  // namespace self_test

namespace hal {

bool imuDataReady() {
    self_test::inertial.onDataReady();
    return false;
}

}  // namespace hal
