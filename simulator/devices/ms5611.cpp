// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/devices/ms5611.hpp"

#include <algorithm>
#include <cmath>

namespace simulator {
namespace {

constexpr uint8_t kReset = 0x1E, kAdcRead = 0x00;
constexpr uint64_t kReload_us = 2800;                                 // after reset
constexpr uint64_t kConversion_us[] = {600, 1170, 2280, 4540, 9040};  // the longest, by OSR
constexpr int kOversamplings = 5;

// The data sheet's example coefficients C1 to C6; word 0 is the factory's, word 7 holds the CRC.
constexpr Ms5611::Prom kProm = {0x0042, 40127, 36924, 23317, 23282, 33464, 28312, 0x0500};

struct Compensation {
    double temperature, offset, sensitivity;  // TEMP in 0.01 degrees, OFF and SENS
};

// Data sheet, figures 2 and 3.
Compensation compensate(const Ms5611::Prom& c, double dt) {
    Compensation out;
    out.temperature = 2000 + dt * c[6] / 0x1p23;
    out.offset = c[2] * 0x1p16 + c[4] * dt / 0x1p7;
    out.sensitivity = c[1] * 0x1p15 + c[3] * dt / 0x1p8;
    if (out.temperature >= 2000) return out;
    const double cold = out.temperature - 2000, frost = out.temperature + 1500;
    out.offset -= 2.5 * cold * cold + (frost < 0 ? 7 * frost * frost : 0);
    out.sensitivity -= 1.25 * cold * cold + (frost < 0 ? 5.5 * frost * frost : 0);
    out.temperature -= dt * dt / 0x1p31;
    return out;
}

uint32_t asRaw(double value) {
    return static_cast<uint32_t>(std::clamp(std::round(value), 0.0, 16777215.0));
}

}  // namespace

Ms5611::Ms5611(uint64_t seed, const SensorErrors& errors)
    : errors_(errors),
      random_(seed, 2),
      drift_(errors.baro_drift_pa, errors.baro_drift_s, random_),
      prom_(kProm),
      ready_us_(kReload_us) {
    prom_[7] = static_cast<uint16_t>((prom_[7] & 0xFFF0) | crc4(prom_));
}

void Ms5611::sense(double pressure_pa, double temperature_c) {
    pressure_pa_ = pressure_pa;
    temperature_c_ = temperature_c;
}

// Application note AN520: polynomial 0x3000 over the 16 bytes, the last taken as 0.
uint8_t Ms5611::crc4(Prom prom) {
    prom[7] &= 0xFF00;
    uint16_t remainder = 0;
    for (int i = 0; i < 16; ++i) {
        remainder ^= i % 2 ? prom[i / 2] & 0xFF : prom[i / 2] >> 8;
        for (int bit = 0; bit < 8; ++bit)
            remainder = static_cast<uint16_t>(remainder << 1 ^ (remainder & 0x8000 ? 0x3000 : 0));
    }
    return remainder >> 12 & 0xF;
}

void Ms5611::select(bool chosen, uint64_t) {
    chosen_ = chosen;
    first_byte_ = chosen;
    answer_size_ = answered_ = 0;
}

uint8_t Ms5611::transfer(uint8_t mosi, uint64_t now_us) {
    if (!chosen_) return 0xFF;
    if (fault_.lost() || !powered_) return 0;
    if (first_byte_) {
        first_byte_ = false;
        if (now_us >= ready_us_) command(mosi, now_us);
        return 0xFE;
    }
    return answered_ < answer_size_ ? answer_[answered_++] : 0;
}

void Ms5611::power(bool on, uint64_t now_us) {
    powered_ = on;
    ready_us_ = now_us + kReload_us;
    converted_us_ = UINT64_MAX;
    answer_size_ = answered_ = 0;
}

void Ms5611::command(uint8_t byte, uint64_t now_us) {
    const int oversampling = (byte & 0x0F) / 2;
    if (byte == kReset) {
        ready_us_ = now_us + kReload_us;
        converted_us_ = UINT64_MAX;
    } else if (byte == kAdcRead) {
        answer(now_us >= converted_us_ ? result_ : 0, 3);
        // Asked too early, the chip aborts the conversion that is under way; a result can be read
        // once.
        converted_us_ = UINT64_MAX;
    } else if ((byte & 0xF1) == 0xA0) {
        answer(prom_[oversampling], 2);
    } else if ((byte & 0xE1) == 0x40 && oversampling < kOversamplings) {
        convert(byte & 0x10 ? Quantity::temperature : Quantity::pressure, oversampling, now_us);
    }
}

void Ms5611::convert(Quantity quantity, int oversampling, uint64_t now_us) {
    result_ = asRaw(quantity == Quantity::temperature ? rawTemperature()
                                                      : rawPressure(wrongPressure_pa(now_us)));
    converted_us_ = now_us + kConversion_us[oversampling];
}

void Ms5611::answer(uint32_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) answer_[i] = static_cast<uint8_t>(value >> 8 * (bytes - 1 - i));
    answer_size_ = static_cast<unsigned>(bytes);
}

double Ms5611::rawTemperature() const {
    double dt = 0;
    for (int i = 0; i < 20; ++i)  // the second-order term is small: this converges quickly
        dt += (temperature_c_ * 100 - compensate(prom_, dt).temperature) * 0x1p23 / prom_[6];
    return dt + prom_[5] * 256.0;
}

double Ms5611::rawPressure(double pressure_pa) const {
    const Compensation c = compensate(prom_, rawTemperature() - prom_[5] * 256.0);
    return (pressure_pa * 0x1p15 + c.offset) * 0x1p21 / c.sensitivity;
}

double Ms5611::wrongPressure_pa(uint64_t now_us) {
    const double drift = drift_.advance(static_cast<double>(now_us - drift_us_) * 1e-6, random_);
    drift_us_ = now_us;
    const double pressure_pa = pressure_pa_ + drift + errors_.baro_noise_pa * random_.normal();
    return fault_.of(pressure_pa, kBarometerFaults, random_);
}

}  // namespace simulator
