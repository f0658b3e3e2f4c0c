// SPDX-License-Identifier: GPL-3.0-or-later
// The two products that fixed point is made of. The chip multiplies bytes: what the compiler makes
// of wider products takes two and three times as long as what hal_avr/arithmetic does by hand.
#pragma once
#include <stdint.h>

#ifdef __AVR__
extern "C" int32_t multiplyTimes16(int32_t a, int16_t b) __attribute__((const));
#endif

namespace core {

constexpr int32_t product(int16_t a, int16_t b) { return static_cast<int32_t>(a) * b; }

// The upper 32 of the 48 bits of a product; what is cut off is lost towards the lower number.
#ifdef __AVR__
inline int32_t times16(int32_t a, int16_t b) { return multiplyTimes16(a, b); }
#else
constexpr int32_t times16(int32_t a, int16_t b) {
    return static_cast<int32_t>(static_cast<int64_t>(a) * b >> 16);
}
#endif

}  // namespace core
