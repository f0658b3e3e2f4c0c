// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivers/ms5611_compensation.hpp"

#include "core/fixed.hpp"
#include "core/maths.hpp"

namespace drivers {

uint8_t Ms5611Compensation::crc4(const uint16_t (&prom)[kPromWords]) {
    uint16_t remainder = 0;
    for (uint8_t i = 0; i < 2 * kPromWords; ++i) {
        const uint16_t word = prom[i / 2];
        if (i % 2 == 0) {
            remainder ^= word >> 8;
        } else if (i != 2 * kPromWords - 1) {
            remainder ^= word & 0xFF;
        }
        for (uint8_t bit = 0; bit < 8; ++bit) {
            const bool carry = (remainder & 0x8000) != 0;
            remainder = static_cast<uint16_t>(remainder << 1);
            if (carry) remainder ^= 0x3000;
        }
    }
    return static_cast<uint8_t>(remainder >> 12);
}

bool Ms5611Compensation::load(const uint16_t (&prom)[kPromWords]) {
    if (crc4(prom) != (prom[7] & 0x0F)) return false;
    for (uint8_t i = 1; i <= 6; ++i) {
        if (prom[i] == 0) return false;  // eight zero words have a valid CRC
    }
    for (uint8_t i = 0; i < 6; ++i) coefficient_[i] = prom[i + 1];
    return true;
}

// Data sheet, "Pressure and temperature calculation", figures 2 and 3.
void Ms5611Compensation::temperature(uint32_t d2) {
    const int32_t difference = static_cast<int32_t>(d2) -
                               static_cast<int32_t>(static_cast<uint32_t>(coefficient_[4]) << 8);
    // times a coefficient, without the lowest 11 bits
    const auto times = [scaled = difference * 64](uint16_t coefficient) {
        return core::timesUpper(scaled, static_cast<int32_t>(uint32_t{coefficient} << 15));
    };
    temperature_cc_ = 2000 + (times(coefficient_[5]) >> 12);
    offset_ = (int32_t{1024} * coefficient_[1]) + (times(coefficient_[3]) >> 2);
    sensitivity_ = (int32_t{8192} * coefficient_[0]) + times(coefficient_[2]) * 2;
    if (temperature_cc_ < 2000) cold(difference);
}

void Ms5611Compensation::cold(int32_t difference) {
    constexpr int32_t kLowest = -10000;  // what is below no sensor measures
    const int32_t low = core::limit<int32_t>(temperature_cc_ - 2000, kLowest, 0);
    const int32_t squared = low * low;
    offset_ -= 5 * squared >> 7;
    sensitivity_ -= 5 * squared >> 4;
    if (temperature_cc_ < -1500) {
        const int32_t very_low = low + 3500, square = very_low * very_low;
        offset_ -= 7 * square >> 6;
        sensitivity_ -= 11 * square >> 3;
    }
    temperature_cc_ -= core::timesUpper(difference * 64, difference * 64) >> 11;
}

int32_t Ms5611Compensation::pressure_pa(uint32_t d1) const {
    const int32_t raw = core::timesUpper(static_cast<int32_t>(d1 << 7), sensitivity_);
    return (raw - offset_) >> 9;
}

}  // namespace drivers
