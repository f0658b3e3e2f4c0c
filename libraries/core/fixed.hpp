// SPDX-License-Identifier: GPL-3.0-or-later
// Fixed point for what runs in every frame: on this chip a product of floats costs as much as five
// of these. Numbers that others read are kept in 16 bits and read as floats.
#pragma once
#include <math.h>
#include <stdint.h>

#include "core/convert.hpp"
#include "core/multiply.hpp"

namespace core {

constexpr int16_t narrowed(int32_t value) {
    return static_cast<int16_t>(value > INT16_MAX ? INT16_MAX
                                                  : (value < INT16_MIN ? INT16_MIN : value));
}

// The upper half of 64 bits, three of its last steps uncertain.
inline int32_t timesUpper(int32_t a, int32_t b) {
    const int16_t low = static_cast<int16_t>(static_cast<uint16_t>(b) >> 1);
    return times16(a, static_cast<int16_t>(b >> 16)) + (times16(a, low) * 2 >> 16);
}

// What the compiler can work out, it does.
constexpr int32_t steps(float value, float twice) {
    return (static_cast<int32_t>(value * twice) + (value < 0 ? -1 : 1)) / 2;
}

inline int16_t toAngle(float rad, float twice) {
    return static_cast<int16_t>(
        static_cast<uint16_t>((static_cast<int32_t>(rad * twice) + 1) >> 1));
}

// -2^(15 - kFraction) .. 2^(15 - kFraction), in steps of 2^-kFraction; what is beyond stays at the
// end. From a float and to one it goes by name only, as on the chip each is a call; a constant's
// steps are worked out by the compiler.
template <uint8_t kFraction>
class Fixed {
public:
    static constexpr float kSteps = 1UL << kFraction;
    static constexpr int32_t kOne = 1L << kFraction;

    Fixed() = default;
    // Always inlined: else the compiler calls it with the address of a copy on the stack.
    __attribute__((always_inline)) explicit constexpr Fixed(float value)
        : raw(__builtin_constant_p(value) ? narrowed(steps(value, 2 * kSteps))
                                          : toFixed(value, kFraction)) {}
    static constexpr Fixed fromRaw(int32_t raw) { return Fixed(narrowed(raw), 0); }
    float toFloat() const { return fromFixed(raw, kFraction); }

    int16_t raw;

private:
    constexpr Fixed(int16_t steps, int) : raw(steps) {}
};

// The same in 32 bits, where small steps are summed up: -2^(31 - kFraction) .. 2^(31 - kFraction).
// Sums wrap; whoever sums keeps them in bounds.
template <uint8_t kFraction>
struct Fixed32 {
    static constexpr float kSteps = 1UL << kFraction;
    static constexpr int32_t kOne = 1L << kFraction;

    static constexpr Fixed32 fromRaw(int32_t raw) { return Fixed32{raw}; }
    float toFloat() const {
        return kFraction == 30 ? fromFixed30(raw) : static_cast<float>(raw) * (1.0f / kSteps);
    }
    // With fewer bits behind the point, what is cut off lost towards the lower number.
    template <uint8_t kFewer>
    constexpr Fixed32<kFewer> as() const {
        static_assert(kFewer <= kFraction, "there are no more bits");
        return Fixed32<kFewer>{raw >> (kFraction - kFewer)};
    }

    int32_t raw;
};

// An angle whose 16 bits are a whole turn: it wraps by itself.
class Angle {
public:
    static constexpr float kSteps = 32768.0f / 3.14159265f;  // a radian's

    Angle() = default;
    explicit constexpr Angle(float rad)  // a few turns at most
        : raw(__builtin_constant_p(rad) ? static_cast<int16_t>(steps(rad, 2 * kSteps))
                                        : toAngle(rad, 2 * kSteps)) {}
    static constexpr Angle fromRaw(int16_t raw) { return Angle(raw, 0); }
    float toFloat() const { return fromAngle(raw); }  // rad

    int16_t raw;

private:
    constexpr Angle(int16_t steps, int) : raw(steps) {}
};

// 0..35999.
constexpr uint16_t wrap360_cd(Angle angle) {
    return static_cast<uint16_t>(uint32_t{static_cast<uint16_t>(angle.raw)} * 36000 >> 16);
}

// The way from one to the other, at most half a turn.
constexpr Angle between(Angle from, Angle to) {
    return Angle::fromRaw(static_cast<int16_t>(
        static_cast<uint16_t>(static_cast<uint16_t>(to.raw) - static_cast<uint16_t>(from.raw))));
}

template <uint8_t kFraction>
struct FixedVector {
    static constexpr FixedVector from(float x, float y, float z) {
        return {Fixed<kFraction>(x), Fixed<kFraction>(y), Fixed<kFraction>(z)};
    }

    Fixed<kFraction> x, y, z;
};

// The formats by what is kept in them.
using Ratio = Fixed<14>;        // -2..2: a share of full deflection or throttle, a sine, a cosine
using Gain = Fixed<12>;         // -8..8
using BodyRate = Fixed<10>;     // -32..32 rad/s
using Acceleration = Fixed<8>;  // -128..128 m/s2
using BodyRates = FixedVector<10>;
using Accelerations = FixedVector<8>;

}  // namespace core
