// SPDX-License-Identifier: GPL-3.0-or-later
// MEAS MS5611 barometer on SPI, one conversion a frame: a temperature, then four pressures.
#pragma once
#include <stdint.h>

#include "core/based.hpp"
#include "drivers/ms5611_compensation.hpp"

namespace drivers {

template <class Bus, class Select>
class Ms5611 {
public:
    void start() {
        Select::output();
        Select::high();
        state_ = State::reset;
        phase_ = 0;
    }
    // Every frame of 10 ms. True: a new pressure is there.
    bool step(uint32_t now_us);

    int32_t pressure_pa() const { return pressure_pa_; }
    int32_t temperature_cc() const { return compensation_.temperature_cc(); }  // 0.01 C
    bool healthy() const { return healthy_; }
    uint16_t badReads() const { return bad_reads_; }
    uint16_t restarts() const { return restarts_; }

private:
    enum class State : uint8_t { reset, prom, convert };
    static constexpr uint8_t kReset = 0x1E, kReadProm = 0xA0, kReadAdc = 0x00;
    static constexpr uint8_t kConvertPressure = 0x48, kConvertTemperature = 0x58;  // OSR 4096
    static constexpr uint8_t kPressuresPerTemperature = 4;
    static constexpr uint16_t kReset_us = 4000;  // data sheet: 2.8 ms
    // The data sheet's longest at OSR 4096, and the time a step may take from when it was called
    // to its command: the reading and the computing before it, and interrupts.
    static constexpr uint16_t kConversion_us = 9040 + 250;
    static constexpr uint32_t kRetry_us = 250000;

    static void command(uint8_t code) {
        const typename Bus::Lock lock;
        Select::low();
        Bus::transfer(code);
        Select::high();
    }
    static uint16_t promWord(uint8_t index);
    static uint32_t adc();
    void readPromWord(uint32_t now_us);
    bool convert(uint32_t now_us);
    bool use(uint32_t value, uint32_t now_us);
    void startConversion(uint32_t now_us) {
        command(phase_ == 0 ? kConvertTemperature : kConvertPressure);
        since_us_ = now_us;
    }
    void fail(uint32_t now_us) {
        ++restarts_;
        healthy_ = false;
        state_ = State::reset;
        phase_ = 0;
        since_us_ = now_us;
        pause_us_ = kRetry_us;
    }

    Ms5611Compensation compensation_;
    int32_t pressure_pa_ = 0;
    uint32_t since_us_ = 0;
    uint32_t good_us_ = 0;
    uint32_t pause_us_ = 0;
    uint16_t bad_reads_ = 0;
    uint16_t restarts_ = 0;
    // While the PROM is read nothing else is known yet, but it must not overwrite what was good.
    uint16_t prom_[Ms5611Compensation::kPromWords] = {};
    State state_ = State::reset;
    uint8_t phase_ = 0;  // of the conversion under way: 0 temperature, then pressures; PROM word
    uint8_t bad_in_a_row_ = 0;
    bool healthy_ = false;
};

template <class Bus, class Select>
uint16_t Ms5611<Bus, Select>::promWord(uint8_t index) {
    const typename Bus::Lock lock;
    Select::low();
    Bus::transfer(static_cast<uint8_t>(kReadProm + 2 * index));
    const uint8_t high = Bus::transfer(0);
    const uint8_t low = Bus::transfer(0);
    Select::high();
    return static_cast<uint16_t>(static_cast<uint16_t>(high) << 8 | low);
}

template <class Bus, class Select>
uint32_t Ms5611<Bus, Select>::adc() {
    const typename Bus::Lock lock;
    Select::low();
    Bus::transfer(kReadAdc);
    const uint8_t high = Bus::transfer(0);
    const uint8_t middle = Bus::transfer(0);
    const uint8_t low = Bus::transfer(0);
    Select::high();
    return static_cast<uint32_t>(high) << 16 | static_cast<uint16_t>(middle << 8) | low;
}

template <class Bus, class Select>
bool Ms5611<Bus, Select>::step(uint32_t now_us) {
    switch (state_) {
        case State::reset:
            if (now_us - since_us_ < pause_us_) return false;
            pause_us_ = 0;
            command(kReset);
            since_us_ = now_us;
            state_ = State::prom;
            return false;
        case State::prom:
            if (now_us - since_us_ >= kReset_us) readPromWord(now_us);
            return false;
        case State::convert:
            return core::based(*this).convert(now_us);
    }
    return false;
}

template <class Bus, class Select>
void Ms5611<Bus, Select>::readPromWord(uint32_t now_us) {
    // Twice, each time behind a reset, which has the chip load it: on a noisy bus one in sixteen
    // wrong PROMs has the right CRC, and would last.
    const uint8_t index = phase_ % Ms5611Compensation::kPromWords;
    const uint16_t word = promWord(index);
    if (phase_ != index && word != prom_[index]) return fail(now_us);
    prom_[index] = word;
    if (++phase_ == Ms5611Compensation::kPromWords) state_ = State::reset;
    if (phase_ < 2 * Ms5611Compensation::kPromWords) return;
    if (!compensation_.load(prom_)) return fail(now_us);
    state_ = State::convert;
    good_us_ = now_us;
    bad_in_a_row_ = 0;
    phase_ = 0;
    startConversion(now_us);
}

template <class Bus, class Select>
bool Ms5611<Bus, Select>::convert(uint32_t now_us) {
    if (now_us - since_us_ < kConversion_us) return false;
    const uint32_t value = adc();
    const uint8_t converted = phase_;
    const bool good = use(value, now_us);
    if (state_ != State::convert) return false;
    // A temperature that could not be read is asked for again: pressures need it.
    if (good || converted != 0) phase_ = phase_ < kPressuresPerTemperature ? phase_ + 1 : 0;
    startConversion(now_us);
    return good && converted != 0;
}

// Limits: the data sheet's ranges of operation, 10..1200 mbar and -40..85 C.
template <class Bus, class Select>
bool Ms5611<Bus, Select>::use(uint32_t value, uint32_t now_us) {
    bool good = value != 0 && value != 0xFFFFFF;
    if (good && phase_ == 0) {
        compensation_.temperature(value);
        good = temperature_cc() >= -4000 && temperature_cc() <= 8500;
    } else if (good) {
        const int32_t pressure_pa = compensation_.pressure_pa(value);
        good = pressure_pa >= 1000 && pressure_pa <= 120000;
        if (good) {
            pressure_pa_ = pressure_pa;
            good_us_ = now_us;
            healthy_ = true;
        }
    }
    if (good) {
        bad_in_a_row_ = 0;
        return true;
    }
    ++bad_reads_;
    if (now_us - good_us_ > 200000) healthy_ = false;
    if (++bad_in_a_row_ > 20) fail(now_us);
    return false;
}

}  // namespace drivers
