// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivers/ms5611_compensation.hpp"

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
    int32_t temperature =
        2000 + static_cast<int32_t>((static_cast<int64_t>(difference) * coefficient_[5]) >> 23);
    offset_ = (static_cast<int64_t>(coefficient_[1]) << 16) +
              ((static_cast<int64_t>(difference) * coefficient_[3]) >> 7);
    sensitivity_ = (static_cast<int64_t>(coefficient_[0]) << 15) +
                   ((static_cast<int64_t>(difference) * coefficient_[2]) >> 8);
    if (temperature < 2000) {
        const int32_t below = temperature - 2000;
        const int64_t squared = static_cast<int64_t>(below) * below;
        offset_ -= (5 * squared) >> 1;
        sensitivity_ -= (5 * squared) >> 2;
        if (temperature < -1500) {
            const int32_t far_below = temperature + 1500;
            const int64_t far_squared = static_cast<int64_t>(far_below) * far_below;
            offset_ -= 7 * far_squared;
            sensitivity_ -= (11 * far_squared) >> 1;
        }
        temperature -= static_cast<int32_t>((static_cast<int64_t>(difference) * difference) >> 31);
    }
    temperature_cc_ = temperature;
}

int32_t Ms5611Compensation::pressure_pa(uint32_t d1) const {
    return static_cast<int32_t>((((static_cast<int64_t>(d1) * sensitivity_) >> 21) - offset_) >>
                                15);
}

}  // namespace drivers
