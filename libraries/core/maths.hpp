// SPDX-License-Identifier: GPL-3.0-or-later
// Small arithmetic that every room needs: limits, angle wrapping, unit conversion.
#pragma once
#include <math.h>
#include <stdint.h>

#include "core/convert.hpp"
#include "core/float_bits.hpp"

namespace core {

constexpr float kPi = 3.14159265f;
constexpr float kGravity_mss = 9.80665f;

constexpr float radians(float degrees) { return degrees * (kPi / 180.0f); }
constexpr float degrees(float radians) { return radians * (180.0f / kPi); }
constexpr float radiansFromCentidegrees(float cd) { return cd * (kPi / 18000.0f); }
constexpr float centidegrees(float radians) { return radians * (18000.0f / kPi); }

template <class T>
constexpr T limit(T value, T lowest, T highest) {
    return value < lowest ? lowest : (highest < value ? highest : value);
}

// Comparing floats takes five times as long as comparing their bits. What is no number counts as
// infinity with its sign, so what comes back lies between the two whatever goes in.
template <>
__attribute__((always_inline)) inline float limit(float value, float lowest, float highest) {
    return limitedByBits(value, lowest, highest);
}

template <class T>
constexpr T square(T value) {
    return value * value;
}

// Not inlined: it stands in a dozen places, and takes 40 bytes in each.
__attribute__((noinline)) inline float squaredLength(float a, float b) { return a * a + b * b; }

// Nor are these: a constant beside a float takes 12 bytes in each of 20 places.
__attribute__((noinline)) inline float inverse(float value) { return 1 / value; }
__attribute__((noinline)) inline float half(float value) { return value * 0.5f; }
// Between two values: `from` at a share of 0, `to` at 1; a low-pass filter, where `from` is its
// output.
__attribute__((noinline)) inline float lerp(float from, float to, float share) {
    return from + (to - from) * share;
}
__attribute__((noinline)) inline int32_t inHundredths(float value) { return rounded(value * 100); }

// Not inlined either, as their loops are long.
// -180..180 degrees
__attribute__((noinline)) constexpr int32_t wrap180_cd(int32_t angle_cd) {
    while (angle_cd > 18000) angle_cd -= 36000;
    while (angle_cd <= -18000) angle_cd += 36000;
    return angle_cd;
}
// 0..360 degrees
__attribute__((noinline)) constexpr int32_t wrap360_cd(int32_t angle_cd) {
    while (angle_cd >= 36000) angle_cd -= 36000;
    while (angle_cd < 0) angle_cd += 36000;
    return angle_cd;
}
// -pi..pi; for sums of a few such angles
__attribute__((noinline)) inline float wrapPi(float angle_rad) {
    while (angle_rad > kPi) angle_rad -= 2 * kPi;
    while (angle_rad < -kPi) angle_rad += 2 * kPi;
    return angle_rad;
}

struct Vector3 {
    float x, y, z;
};
constexpr Vector3 operator+(const Vector3& a, const Vector3& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
constexpr Vector3 operator-(const Vector3& a, const Vector3& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
constexpr Vector3 operator*(const Vector3& a, float s) { return {a.x * s, a.y * s, a.z * s}; }
constexpr float dot(const Vector3& a, const Vector3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
constexpr Vector3 cross(const Vector3& a, const Vector3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace core
