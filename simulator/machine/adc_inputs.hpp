// SPDX-License-Identifier: GPL-3.0-or-later
// The ADC's sixteen pins and its band gap, measured when the conversion starts, and
// the conversion that the chip starts by itself when it goes to sleep. libsimavr has the times; its
// data registers know eight pins and look at them too late.
#pragma once
#include <simavr/avr_adc.h>

#include <functional>

#include "simulator/machine/hooks.hpp"

namespace simulator {

class AdcInputs : public Mend {
public:
    explicit AdcInputs(avr_t* avr);
    void reset() override { result_ = 0, on_band_gap_ = false; }

    // An enabled converter that rests begins a conversion with the sleep; whether it did.
    bool sleepBegins();

    std::function<double(int pin)> volts;                   // of A0..A15
    std::function<double()> supply_v = [] { return 5.0; };  // AVcc, the boards' reference
    // A weak source: chosen, it takes 70 us until what is sampled is within 1 % of it (data sheet
    // 31.5, t_BG, most).
    double band_gap_v = 1.1;

private:
    void sample(uint32_t);
    uint8_t readLow(uint16_t);
    uint8_t readHigh(uint16_t);
    double pinVolts() const;
    double settling(double from_v) const;

    avr_t* avr_;
    uint16_t result_ = 0;
    double pin_v_ = 0;             // of the last conversion of a pin
    uint64_t band_gap_since_ = 0;  // the cycle of the first conversion behind it
    bool on_band_gap_ = false;
};

}  // namespace simulator
