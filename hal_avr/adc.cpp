// SPDX-License-Identifier: GPL-3.0-or-later
// One scan converts each input of the table in turn, by interrupt, and then the converter rests.
// 125 kHz: 104 us a conversion, 1.4 ms a scan. Resting it is enabled, so each sleep begins a
// conversion (data sheet 11.2), of the band gap; nobody waits for its end.
#include <avr/interrupt.h>
#include <avr/io.h>

#include "core/rom.hpp"
#include "hal/analog.hpp"
#include "hal/interrupts.hpp"
#include "restart.hpp"
#include "start.hpp"
#include "wiring.hpp"

namespace {

static_assert(core::count(wiring::kAnalogSteps) == hal::kAnalogs, "one step for each input");

constexpr uint8_t kMaxReadings = 60;  // of 10 bits in 16
constexpr uint8_t kResting = (1 << ADEN) | (1 << ADPS2) | (1 << ADPS1) | (1 << ADPS0);
constexpr uint8_t kScanning = kResting | (1 << ADIE);

hal::AnalogSum sums[hal::kAnalogs];

struct {
    uint8_t step;
    uint8_t drop, take;  // still to come in this step
    volatile bool running;
} scan;

// Inline and member by member: the interrupt shall call nothing, or it saves every register.
inline __attribute__((always_inline)) void begin(uint8_t step) {
    const uint8_t mux = core::romRead(wiring::kAnalogSteps[step].mux);
    scan.step = step;
    scan.drop = core::romRead(wiring::kAnalogSteps[step].drop);
    scan.take = core::romRead(wiring::kAnalogSteps[step].take);
    ADMUX = static_cast<uint8_t>((1 << REFS0) | (mux & 0x1F));
    ADCSRB = mux & 0x20 ? 1 << MUX5 : 0;
}

inline void add(hal::AnalogSum& to, uint16_t reading) {
    if (to.count == kMaxReadings) to = {0, 0};  // nobody takes them: newer is better
    to.sum += reading;
    ++to.count;
}

}  // namespace

ISR(ADC_vect) {
    const uint16_t reading = ADC;
    if (scan.drop > 0) {
        --scan.drop;
    } else {
        add(sums[scan.step], reading);
        if (--scan.take == 0) {
            if (scan.step + 1 == hal::kAnalogs) {
                scan.running = false;
                ADCSRA = kResting;
                return;
            }
            begin(scan.step + 1);
        }
    }
    ADCSRA = kScanning | (1 << ADSC);
}

namespace avr {

// A scan ends with the band gap, and the multiplexer stays there: until the next scan every
// conversion, also one that a sleep has begun, is of it. The newest that is done is read here.
bool supplyLow() {
    constexpr uint16_t kMaxReading = 1126400 / 4200;
    if (scan.running || scan.step + 1 != hal::kAnalogs) return false;
    const uint16_t reading = ADC;
    ADCSRA = kResting | (1 << ADIF) | (1 << ADSC);
    return reading > kMaxReading;
}

// The first scan enables the converter, when its reference has been chosen.
void adcStart() {
    DIDR0 = wiring::kAnalogPins0;
    DIDR2 = wiring::kAnalogPins2;
}

}  // namespace avr

namespace hal {

void analogScan() {
    if (scan.running) return;
    scan.running = true;
    begin(wiring::kFirstAnalogStep);
    // One of supplyLow() or of a sleep that is under way ends first; the end of another is
    // forgotten.
    if (ADCSRA & (1 << ADSC)) ++scan.drop;
    ADCSRA = kScanning | (1 << ADIF) | (1 << ADSC);
}

AnalogSum analogTake(Analog input) {
    if (wiring::kFirstAnalogStep > 0 && input == Analog::airspeed) return wiring::airspeed();
    AnalogSum& sum = sums[static_cast<uint8_t>(input)];
    Locked locked;
    const AnalogSum taken = sum;
    sum = {0, 0};
    return taken;
}

}  // namespace hal
