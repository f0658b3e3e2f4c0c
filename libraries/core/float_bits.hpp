// SPDX-License-Identifier: GPL-3.0-or-later
// Floats by their bits: what can be seen from an exponent needs none of the chip's slow arithmetic.
#pragma once
#include <stdint.h>
#include <string.h>

namespace core {

inline uint32_t bitsOf(float value) {
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    return bits;
}
inline float fromBits(uint32_t bits) {
    float value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

// Of the size without its sign, the upper half of the bits: grows with it.
inline uint16_t sizeOf(float value) { return static_cast<uint16_t>(bitsOf(value) >> 16) & 0x7FFF; }
// Against 0 by these bits alone, which takes a third of what comparing two floats does. Below 1e-40
// everything is 0, and what is no number is infinity with its sign.
inline bool isPositive(float value) { return static_cast<int16_t>(bitsOf(value) >> 16) > 0; }
inline bool isNegative(float value) { return bitsOf(value) >> 16 > 0x8000U; }
inline bool isZero(float value) { return sizeOf(value) == 0; }
constexpr uint16_t sizeOfPower(int8_t power) { return static_cast<uint16_t>((127 + power) << 7); }

// Times 2^power, for what stays a normal number; 0 stays 0.
inline float scaled(float value, int8_t power) {
    if (sizeOf(value) < sizeOfPower(-126)) return 0;
    const uint32_t bits =
        bitsOf(value) + (static_cast<uint32_t>(static_cast<int32_t>(power)) << 23);
    memcpy(&value, &bits, sizeof bits);
    return value;
}

// In the order of the numbers, for all that are numbers.
inline int32_t orderOf(float value) {
    const int32_t bits = static_cast<int32_t>(bitsOf(value));
    return bits < 0 ? bits ^ INT32_MAX : bits;
}

}  // namespace core
