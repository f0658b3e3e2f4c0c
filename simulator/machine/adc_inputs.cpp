// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/machine/adc_inputs.hpp"

#include <algorithm>
#include <cmath>

#include "simulator/machine/registers.hpp"

namespace simulator {

AdcInputs::AdcInputs(avr_t* avr) : avr_(avr) {
    hookLine<&AdcInputs::sample>(avr_io_getirq(avr, AVR_IOCTL_ADC_GETIRQ, ADC_IRQ_OUT_TRIGGER),
                                 this);
    hookRead<&AdcInputs::readLow>(avr, kAdcl, this);
    hookRead<&AdcInputs::readHigh>(avr, kAdch, this);
}

namespace {

constexpr uint8_t kBandGap = 0x1E;

}  // namespace

// Datasheet table 26-4: MUX5 chooses the upper eight pins, 0x1E is the band gap.
double AdcInputs::pinVolts() const {
    const uint8_t mux = avr_->data[kAdmux] & 0x1F;
    const bool upper = avr_->data[kAdcsrb] & 0x08;
    return mux < 8 && volts ? volts(upper ? mux + 8 : mux) : 0;
}

// The sample is held 1.5 of the converter's clocks after the start (datasheet 26.4), here those of
// the slowest, 125 kHz.
double AdcInputs::settling(double from_v) const {
    constexpr double kHeld_us = 12, kSettles_us = 70, kSettled = 0.01, kCycles_us = 16;
    const double since_us =
        static_cast<double>(avr_->cycle - band_gap_since_) / kCycles_us + kHeld_us;
    return band_gap_v + (from_v - band_gap_v) * std::pow(kSettled, since_us / kSettles_us);
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
    const bool on_band_gap = (avr_->data[kAdmux] & 0x1F) == kBandGap;
    if (on_band_gap && !on_band_gap_) band_gap_since_ = avr_->cycle;
    on_band_gap_ = on_band_gap;
    if (!on_band_gap) pin_v_ = pinVolts();
    const double input_v = on_band_gap ? settling(pin_v_) : pin_v_;
    const double counts = input_v / supply_v() * 1024;
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
