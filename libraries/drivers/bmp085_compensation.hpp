// SPDX-License-Identifier: GPL-3.0-or-later
// The arithmetic of the BMP085, in integers exactly as its data sheet (BST-BMP085-DS000, figure 3)
// has them.
#pragma once
#include <stdint.h>

namespace drivers {

class Bmp085Compensation {
public:
    static constexpr uint8_t kWords = 11;

    // AC1..AC6, B1, B2, MB, MC, MD as they stand in the EEPROM. False: a word is 0 or 0xFFFF, which
    // none can be (data sheet 3.4); nothing changed.
    bool load(const uint16_t (&words)[kWords]);

    void temperature(uint16_t raw);
    // Of a reading with 2^oversampling samples, at most 3; after a temperature.
    int32_t pressure_pa(uint32_t raw, uint8_t oversampling) const;
    int16_t temperature_dc() const { return static_cast<int16_t>((b5_ + 8) >> 4); }  // 0.1 C

private:
    enum Word : uint8_t { ac1, ac2, ac3, ac4, ac5, ac6, b1, b2, mb, mc, md };
    int32_t whole(Word which) const { return static_cast<int16_t>(words_[which]); }

    uint16_t words_[kWords] = {};
    int32_t b5_ = 0;
};

}  // namespace drivers
