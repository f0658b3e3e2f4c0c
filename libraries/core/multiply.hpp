// SPDX-License-Identifier: GPL-3.0-or-later
// The products that fixed point is made of.
#pragma once
#include <stdint.h>

#ifdef __AVR__
extern "C" {  // hal_avr
int32_t multiplyTimes16(int32_t a, int16_t b) __attribute__((const));
int16_t multiplyTimes14(int16_t a, int16_t b) __attribute__((const));
int16_t multiplyTimes12(int16_t a, int16_t b) __attribute__((const));
}
#endif

namespace core {

constexpr int32_t product(int16_t a, int16_t b) { return static_cast<int32_t>(a) * b; }

// The upper half, rounded; of values that leave half a bit of room.
constexpr int16_t upper(int32_t value) { return static_cast<int16_t>((value + 0x8000) >> 16); }

// The upper 32 of the 48 bits of a product; what is cut off is lost towards the lower number.
#ifdef __AVR__
inline int32_t times16(int32_t a, int16_t b) { return multiplyTimes16(a, b); }
#else
constexpr int32_t times16(int32_t a, int16_t b) {
    return static_cast<int32_t>(static_cast<int64_t>(a) * b >> 16);
}
#endif

// The upper half, rounded, of so many times the value.
constexpr int16_t upperOf4(int32_t value) { return upper(value * 4); }
constexpr int16_t upperOf16(int32_t value) { return upper(value * 16); }
constexpr int32_t kMaxOf16 = 0x7FF0000;  // times 16 it still fits, rounded up as well
// The product of two numbers one of which has so many bits behind the point, rounded, in the form
// of the other.
#ifdef __AVR__
inline int16_t times14(int16_t a, int16_t b) { return multiplyTimes14(a, b); }
inline int16_t times12(int16_t a, int16_t b) { return multiplyTimes12(a, b); }
#else
constexpr int16_t times14(int16_t a, int16_t b) { return upperOf4(product(a, b)); }
constexpr int16_t times12(int16_t a, int16_t b) { return upperOf16(product(a, b)); }
#endif

}  // namespace core
