// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/devices/bmp085.hpp"

#include <algorithm>
#include <cmath>

namespace simulator {
namespace {

constexpr uint8_t kWordsAt = 0xAA, kWordsEnd = 0xC0, kIdentity = 0xD0, kControl = 0xF4;
constexpr uint8_t kResult = 0xF6, kResultEnd = 0xF9;
constexpr uint8_t kTemperature = 0x2E, kPressure = 0x34;
constexpr uint64_t kConversion_us[] = {4500, 7500, 13500, 25500};  // by oversampling
constexpr uint64_t kTemperature_us = 4500;
constexpr uint64_t kStart_us = 10'000;  // table 1: from power-on to the first communication

// The data sheet's example.
constexpr Bmp085::Words kExample = {408,  -72, -14383, 32741, 32757, 23153,
                                    6190, 4,   -32768, -8711, 2868};
enum Word { ac1, ac2, ac3, ac4, ac5, ac6, b1, b2, mb, mc, md };

// The raw value for which a function that grows has this value.
template <class Function>
double solve(Function of, double value, double least, double most) {
    for (int i = 0; i < 50; ++i) {
        const double middle = (least + most) / 2;
        (of(middle) < value ? least : most) = middle;
    }
    return (least + most) / 2;
}

}  // namespace

Bmp085::Bmp085(uint64_t seed, const SensorErrors& errors)
    : errors_(errors),
      random_(seed, 8),
      drift_(errors.baro_drift_pa, errors.baro_drift_s, random_),
      words_(kExample) {}

void Bmp085::sense(double pressure_pa, double temperature_c) {
    pressure_pa_ = pressure_pa;
    temperature_c_ = temperature_c;
}

void Bmp085::power(bool on, uint64_t now_us) {
    powered_ = on;
    ready_us_ = now_us + kStart_us;
    converted_us_ = UINT64_MAX;
    next_ = result_ = kNoResult;
    control_ = pointer_ = 0;
    pointer_next_ = false;
}

bool Bmp085::start(bool read, uint64_t now_us) {
    advance(now_us);
    pointer_next_ = !read;
    return !silent() && now_us >= ready_us_;
}

bool Bmp085::write(uint8_t byte, uint64_t now_us) {
    if (silent()) return false;
    advance(now_us);
    if (pointer_next_) {
        pointer_ = byte;
        pointer_next_ = false;
    } else {
        if (pointer_ == kControl) control(byte, now_us);
        ++pointer_;
    }
    return true;
}

uint8_t Bmp085::read(bool, uint64_t now_us) {
    if (silent()) return 0xFF;
    advance(now_us);
    return readRegister(pointer_++);
}

uint8_t Bmp085::readRegister(uint8_t at) const {
    if (at >= kWordsAt && at < kWordsEnd) {
        const int word = words_[static_cast<size_t>(at - kWordsAt) / 2];
        return static_cast<uint8_t>(at % 2 == 0 ? word >> 8 : word);
    }
    if (at >= kResult && at < kResultEnd)
        return static_cast<uint8_t>(result_ >> 8 * (kResultEnd - 1 - at));
    if (at == kControl) return control_;
    return at == kIdentity ? 0x55 : 0;
}

void Bmp085::control(uint8_t value, uint64_t now_us) {
    control_ = value;
    const int oversampling = value >> 6;
    if (value == kTemperature) {
        next_ = static_cast<uint32_t>(std::clamp(std::round(rawTemperature()), 0.0, 65535.0)) << 8;
        converted_us_ = now_us + kTemperature_us;
    } else if ((value & 0x3F) == kPressure) {
        next_ = rawPressure(wrongPressure_pa(now_us), oversampling) << (8 - oversampling);
        converted_us_ = now_us + kConversion_us[oversampling];
    }
}

// What is read before a conversion's end is the result of the one before.
void Bmp085::advance(uint64_t now_us) {
    if (now_us < converted_us_) return;
    result_ = next_;
    converted_us_ = UINT64_MAX;
}

// Data sheet, figure 3, without the rounding of its integers.
double Bmp085::b5Of(double raw) const {
    const double x1 = (raw - words_[ac6]) * words_[ac5] / 0x1p15;
    return x1 + words_[mc] * 0x1p11 / (x1 + words_[md]);
}

double Bmp085::pressure_pa(double raw, double b5, int oversampling) const {
    const double scale = 1 << oversampling;
    const double b6 = b5 - 4000, square = b6 * b6 / 0x1p12;
    const double b3 =
        ((words_[ac1] * 4 + words_[b2] * square / 0x1p11 + words_[ac2] * b6 / 0x1p11) * scale + 2) /
        4;
    const double x3 = (words_[ac3] * b6 / 0x1p13 + words_[b1] * square / 0x1p16 + 2) / 4;
    const double b4 = words_[ac4] * (x3 + 32768) / 0x1p15;
    const double p = (raw - b3) * (50000 / scale) * 2 / b4;
    const double x1 = p / 0x1p8 * (p / 0x1p8) * 3038 / 0x1p16, x2 = -7357 * p / 0x1p16;
    return p + (x1 + x2 + 3791) / 16;
}

double Bmp085::rawTemperature() const {
    const auto temperature_dc = [this](double raw) { return (b5Of(raw) + 8) / 16; };
    return solve(temperature_dc, temperature_c_ * 10, 22000, 50000);
}

uint32_t Bmp085::rawPressure(double pressure, int oversampling) const {
    const double b5 = b5Of(std::round(rawTemperature()));
    const auto of = [&](double raw) { return pressure_pa(raw, b5, oversampling); };
    const double most = 65535 << oversampling;
    return static_cast<uint32_t>(std::round(solve(of, pressure, 0, most)));
}

double Bmp085::wrongPressure_pa(uint64_t now_us) {
    const double drift = drift_.advance(static_cast<double>(now_us - drift_us_) * 1e-6, random_);
    drift_us_ = now_us;
    const double pressure_pa = pressure_pa_ + drift + errors_.baro_noise_pa * random_.normal();
    return fault_.of(pressure_pa, kBarometerFaults, random_);
}

}  // namespace simulator
