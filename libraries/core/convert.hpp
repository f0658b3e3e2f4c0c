// SPDX-License-Identifier: GPL-3.0-or-later
// Between floats and whole numbers, rounded to the nearest, halves away from zero; and limits of
// floats in the order of their bits. real() of 16 bits is half the work of a cast, and hundredths()
// takes the place of its factor at each of many places. The chip's are by hand in
// hal_avr/arithmetic, a third of what the compiler makes of these.
#pragma once
#include "core/float_bits.hpp"

#ifdef __AVR__
extern "C" {
int16_t fixedFromFloat(float value, int8_t power) __attribute__((const));
float floatFromFixed(int16_t raw, int8_t fraction) __attribute__((const));
float floatFromInt16(int16_t value) __attribute__((const));
float floatFromAngle(int16_t raw) __attribute__((const));
float floatFromCentidegrees(int16_t value) __attribute__((const));
float floatFromFixed30(int32_t raw) __attribute__((const));
float thousandthsOfInt16(int16_t value) __attribute__((const));
float thousandthsOfInt32(int32_t value) __attribute__((const));
float hundredthsOfInt16(int16_t value) __attribute__((const));
float hundredthsOfInt32(int32_t value) __attribute__((const));
int32_t roundedFloat(float value) __attribute__((const));
float limitFloat(float value, float lowest, float highest) __attribute__((const));
float limitShare(float value) __attribute__((const));
}
#endif

namespace core {

template <class Whole>
constexpr bool fitsInt16() {
    return sizeof(Whole) == 1 || (sizeof(Whole) == 2 && static_cast<Whole>(-1) < 0);
}

#ifdef __AVR__
inline int32_t truncated(float value) { return static_cast<int32_t>(value); }
inline int32_t rounded(float value) { return roundedFloat(value); }
inline int16_t toFixed(float value, int8_t power) { return fixedFromFloat(value, power); }
inline float fromFixed(int16_t raw, int8_t fraction) { return floatFromFixed(raw, fraction); }
// What does not fit into 16 bits would be cut without a word.
template <class Whole>
inline float real(Whole value) {
    static_assert(fitsInt16<Whole>(), "cast it");
    return floatFromInt16(value);
}
inline float fromAngle(int16_t raw) { return floatFromAngle(raw); }
inline float fromCentidegrees(int16_t value) { return floatFromCentidegrees(value); }
inline float fromFixed30(int32_t raw) { return floatFromFixed30(raw); }
inline float thousandths(int16_t value) { return thousandthsOfInt16(value); }
inline float thousandths(int32_t value) { return thousandthsOfInt32(value); }
inline float hundredths(int16_t value) { return hundredthsOfInt16(value); }
inline float hundredths(int32_t value) { return hundredthsOfInt32(value); }
// Where one bound follows from the other it need not be brought: the third argument takes registers
// that the caller has to save.
// They take and return bits, of which the compiler makes no copies.
__attribute__((noinline)) inline int32_t limitedFromZero(int32_t bits, int32_t highest) {
    if (bits < 0) return 0;
    if (highest < bits) return highest;
    return bits;
}
__attribute__((noinline)) inline uint32_t limitedInSize(uint32_t bits, uint32_t largest) {
    constexpr uint32_t kSign = UINT32_C(1) << 31;
    if ((bits & kSign) != 0) largest |= kSign;
    if (largest < bits) return largest;
    return bits;
}
__attribute__((always_inline)) inline float limitedByBits(float value, float lowest,
                                                          float highest) {
    const bool from_zero = __builtin_constant_p(lowest) && bitsOf(lowest) == 0;
    if (from_zero && __builtin_constant_p(highest) && highest == 1) return limitShare(value);
    if (from_zero)
        return fromBits(static_cast<uint32_t>(limitedFromZero(
            static_cast<int32_t>(bitsOf(value)), static_cast<int32_t>(bitsOf(highest)))));
    if (__builtin_constant_p(lowest) && __builtin_constant_p(highest) && lowest == -highest)
        return fromBits(limitedInSize(bitsOf(value), bitsOf(highest)));
    return limitFloat(value, lowest, highest);
}
#else
// Of what is no number, or beyond 32 bits, any: on this computer a cast of it may do anything.
inline int32_t truncated(float value) {
    return sizeOf(value) < sizeOfPower(31) ? static_cast<int32_t>(value) : 0;
}
inline int32_t rounded(float value) {
    const uint16_t size = sizeOf(value);
    if (size < sizeOfPower(-1)) return 0;
    if (size >= sizeOfPower(23)) return truncated(value);  // whole
    const int32_t halves = static_cast<int32_t>(scaled(value, 1));
    return (halves + (halves < 0 ? 0 : 1)) >> 1;
}
// Times 2^power; what is beyond 16 bits stays at their end.
inline int16_t toFixed(float value, int8_t power) {
    if (sizeOf(value) >= sizeOfPower(static_cast<int8_t>(15 - power)))
        return value < 0 ? INT16_MIN : INT16_MAX;
    const int32_t whole = rounded(scaled(value, power));
    return static_cast<int16_t>(whole > INT16_MAX ? INT16_MAX : whole);
}
// Times 2^-fraction.
inline float fromFixed(int16_t raw, int8_t fraction) {
    return scaled(static_cast<float>(raw), static_cast<int8_t>(-fraction));
}
template <class Whole>
inline float real(Whole value) {  // on the chip of 16 bits at most: here an int is of 32
    return static_cast<float>(value);
}
// Of a turn's 65536 parts, in radians.
inline float fromAngle(int16_t raw) {
    return static_cast<float>(raw) * (1.0f / (32768.0f / 3.14159265f));
}
inline float fromCentidegrees(int16_t value) {
    return static_cast<float>(value) * (3.14159265f / 18000.0f);
}
inline float fromFixed30(int32_t raw) { return static_cast<float>(raw) * (1.0f / (1L << 30)); }
inline float thousandths(int32_t value) { return static_cast<float>(value) * 0.001f; }
inline float hundredths(int32_t value) { return static_cast<float>(value) * 0.01f; }
inline float limitedByBits(float value, float lowest, float highest) {
    const int32_t order = orderOf(value);
    if (order < orderOf(lowest)) return lowest;
    return orderOf(highest) < order ? highest : value;
}
#endif

}  // namespace core
