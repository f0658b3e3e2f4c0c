// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivers/bmp085_compensation.hpp"

namespace drivers {

constexpr int32_t kFarOut_pa = 200000;  // what follows would not fit

bool Bmp085Compensation::load(const uint16_t (&words)[kWords]) {
    for (const uint16_t word : words) {
        if (word == 0 || word == 0xFFFF) return false;
    }
    for (uint8_t i = 0; i < kWords; ++i) words_[i] = words[i];
    return true;
}

void Bmp085Compensation::temperature(uint16_t raw) {
    const int32_t x1 =
        ((static_cast<int32_t>(raw) - words_[ac6]) * static_cast<int32_t>(words_[ac5])) >> 15;
    const int32_t divisor = x1 + whole(md);
    // Only a reading far outside the sensor's range comes here.
    const int32_t x2 = divisor == 0 ? 0 : whole(mc) * 2048 / divisor;
    b5_ = x1 + x2;
}

int32_t Bmp085Compensation::pressure_pa(uint32_t raw, uint8_t oversampling) const {
    const int32_t b6 = b5_ - 4000;
    const int32_t square = (b6 * b6) >> 12;
    const int32_t x3 = ((whole(b2) * square) >> 11) + ((whole(ac2) * b6) >> 11);
    const int32_t b3 = (((whole(ac1) * 4 + x3) * (1 << oversampling)) + 2) / 4;
    const int32_t y3 = (((whole(ac3) * b6) >> 13) + ((whole(b1) * square) >> 16) + 2) >> 2;
    const uint32_t b4 =
        (static_cast<uint32_t>(words_[ac4]) * static_cast<uint32_t>(y3 + 32768)) >> 15;
    if (b4 == 0) return 0;
    const uint32_t b7 = (raw - static_cast<uint32_t>(b3)) * (50000UL >> oversampling);
    int32_t p = static_cast<int32_t>(b7 < 0x80000000UL ? b7 * 2 / b4 : b7 / b4 * 2);
    if (p > kFarOut_pa) return p;
    const int32_t z1 = (((p >> 8) * (p >> 8)) * 3038) >> 16;
    const int32_t z2 = (-7357 * p) >> 16;
    p += (z1 + z2 + 3791) >> 4;
    return p;
}

}  // namespace drivers
