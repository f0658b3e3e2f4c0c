// SPDX-License-Identifier: GPL-3.0-or-later
// The arithmetic of the MS5611: PROM check and both orders of compensation. The data sheet's 64
// bits are kept in 32: what they lose is below 0.05 Pa. What depends on temperature alone is worked
// out once a temperature.
#pragma once
#include <stdint.h>

namespace drivers {

class Ms5611Compensation {
public:
    static constexpr uint8_t kPromWords = 8;

    // AN520: the 4-bit CRC over the eight words with the low byte of the last taken as zero.
    static uint8_t crc4(const uint16_t (&prom)[kPromWords]);

    // False: the CRC is wrong or a coefficient is missing; nothing changed.
    bool load(const uint16_t (&prom)[kPromWords]);

    void temperature(uint32_t d2);
    int32_t pressure_pa(uint32_t d1) const;
    int32_t temperature_cc() const { return temperature_cc_; }  // 0.01 C

private:
    void cold(int32_t difference);

    uint16_t coefficient_[6] = {};
    int32_t temperature_cc_ = 0;
    int32_t offset_ = 0;       // 2^-6 of OFF - OFF2
    int32_t sensitivity_ = 0;  // 2^-2 of SENS - SENS2
};

}  // namespace drivers
