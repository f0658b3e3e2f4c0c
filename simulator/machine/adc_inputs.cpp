// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/machine/adc_inputs.hpp"

#include <algorithm>

#include "simulator/machine/registers.hpp"

namespace simulator {

AdcInputs::AdcInputs(avr_t* avr) : avr_(avr) {
    hookLine<&AdcInputs::sample>(avr_io_getirq(avr, AVR_IOCTL_ADC_GETIRQ, ADC_IRQ_OUT_TRIGGER),
                                 this);
    hookRead<&AdcInputs::readLow>(avr, kAdcl, this);
    hookRead<&AdcInputs::readHigh>(avr, kAdch, this);
}

// Datasheet table 26-4: MUX5 chooses the upper eight pins, 0x1E is the band gap.
double AdcInputs::inputVolts() const {
    const uint8_t mux = avr_->data[kAdmux] & 0x1F;
    const bool upper = avr_->data[kAdcsrb] & 0x08;
    if (mux < 8) return volts ? volts(upper ? mux + 8 : mux) : 0;
    return mux == 0x1E ? band_gap_v : 0;
}

bool AdcInputs::sleepBegins() {
    enum : uint8_t { kEnable = 0x80, kStart = 0x40, kFlag = 0x10 };
    const uint8_t control = avr_->data[kAdcsra];
    if ((control & (kEnable | kStart)) != kEnable) return false;
    const auto& write = avr_->io[AVR_DATA_TO_IO(kAdcsra)].w;
    write.c(avr_, kAdcsra, static_cast<uint8_t>((control | kStart) & ~kFlag), write.param);
    return true;
}

void AdcInputs::sample(uint32_t) {
    const double counts = inputVolts() / supply_v() * 1024;
    result_ = static_cast<uint16_t>(std::clamp(counts, 0.0, 1023.0));
}

uint8_t AdcInputs::readLow(uint16_t) {
    const bool left = avr_->data[kAdmux] & 0x20;
    return static_cast<uint8_t>(left ? result_ << 6 : result_);
}

uint8_t AdcInputs::readHigh(uint16_t) {
    const bool left = avr_->data[kAdmux] & 0x20;
    return static_cast<uint8_t>(left ? result_ >> 2 : result_ >> 8);
}

}  // namespace simulator
