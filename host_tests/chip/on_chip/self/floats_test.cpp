// SPDX-License-Identifier: GPL-3.0-or-later
// hal_avr/arithmetic: floats get every bit as from the library's routines, which are still there
// under these names.
#include <gtest/gtest.h>
#include <string.h>

#include "core/fixed.hpp"
#include "core/maths.hpp"

namespace {

#define LIBRARY(name, code) \
    __attribute__((naked, noinline)) float name(float, float) { __asm__ volatile(code); }
LIBRARY(librarysSum, "clr r26\n clr r27\n call __addsf3x\n jmp __fp_round")
LIBRARY(librarysProduct, "call __mulsf3x\n jmp __fp_round")
LIBRARY(librarysQuotient, "call __divsf3x\n jmp __fp_round")
__attribute__((naked, noinline)) int8_t librarysOrder(float, float) {
    __asm__ volatile("call __fp_cmp\n brcc 1f\n ldi r24, 1\n 1: ret");
}

uint32_t bitsOf(float value) {
    uint32_t bits;
    memcpy(&bits, &value, 4);
    return bits;
}
// What is no number may say so in any way.
bool same(float a, float b) { return bitsOf(a) == bitsOf(b) || (a != a && b != b); }
float floatOf(uint32_t bits) {
    float value;
    memcpy(&value, &bits, 4);
    return value;
}

uint32_t random_state = 2463534242;
uint32_t random32() {
    random_state ^= random_state << 13;
    random_state ^= random_state >> 17;
    random_state ^= random_state << 5;
    return random_state;
}

// Where the special cases of a sum lie: mantissas that carry or cancel, close exponents.
uint32_t besides(uint32_t bits) {
    const uint32_t other = random32();
    switch (other >> 29) {
        case 0:
            return other * 8;  // any bits, also no number
        case 1:
            return bits ^ 0x80000000 ^ (other & 3);
        case 2:
            return (bits & 0xFF800000) | (other & 1 ? 0x7FFFFF : 0);
        case 3:
            return (bits ^ (other & 0x80000000) ^ (other & 0xFF)) + (other & 0x0F000000);
        default: {
            const uint32_t exponent = (bits >> 23 & 0xFF) + (other >> 23 & 0x3F) - 32;
            return (other & 0x807FFFFF) | (exponent & 0xFF) << 23;
        }
    }
}

constexpr uint32_t kEdges[] = {
    0,          0x80000000, 1,          0x80000001, 0x007FFFFF, 0x00800000, 0x80800000,
    0x00FFFFFF, 0x0CFFFFFF, 0x0D000000, 0x0D7FFFFF, 0x3F800000, 0xBF800000, 0x3FFFFFFF,
    0x3F7FFFFF, 0x34000000, 0x33800000, 0x33800001, 0xB3000000, 0x7E800000, 0x7EFFFFFF,
    0x7F000000, 0x7F7FFFFF, 0xFF7FFFFF, 0x7F800000, 0xFF800000, 0x7F800001, 0x7FC00000};

template <class Agree>
int differences(Agree agree, uint16_t more = 20000) {
    int found = 0;
    for (const uint32_t a : kEdges)
        for (const uint32_t b : kEdges) found += !agree(floatOf(a), floatOf(b));
    for (uint16_t i = 0; i < more; ++i) {
        const uint32_t a = random32();
        found += !agree(floatOf(a), floatOf(besides(a)));
    }
    return found;
}

TEST(Arithmetic, sums_have_the_librarys_bits) {
    EXPECT_EQ(differences([](float a, float b) { return same(a + b, librarysSum(a, b)); }), 0);
}
TEST(Arithmetic, differences_have_the_librarys_bits) {
    EXPECT_EQ(differences([](float a, float b) {
                  return same(a - b, librarysSum(a, floatOf(bitsOf(b) ^ 0x80000000)));
              }),
              0);
}
TEST(Arithmetic, products_have_the_librarys_bits) {
    EXPECT_EQ(differences([](float a, float b) { return same(a * b, librarysProduct(a, b)); }), 0);
}
TEST(Arithmetic, quotients_have_the_librarys_bits) {
    EXPECT_EQ(differences([](float a, float b) { return same(a / b, librarysQuotient(a, b)); }), 0);
}
int wrongTimes16(int32_t a, int16_t b) {
    return core::times16(a, b) != static_cast<int32_t>(static_cast<int64_t>(a) * b >> 16);
}
TEST(Arithmetic, times16_is_the_upper_part_of_the_whole_product) {
    constexpr int32_t kLong[] = {0,     1,     -1,     255,       256,      -256,
                                 65535, 65536, -65536, INT32_MAX, INT32_MIN};
    constexpr int16_t kShort[] = {0, 1, -1, 127, 128, 255, 256, -128, -256, INT16_MAX, INT16_MIN};
    int wrong = 0;
    for (const int32_t a : kLong)
        for (const int16_t b : kShort) wrong += wrongTimes16(a, b);
    for (uint16_t i = 0; i < 5000; ++i) {
        const int32_t a = static_cast<int32_t>(random32() >> (i & 15));
        wrong += wrongTimes16(a, static_cast<int16_t>(random32()));
    }
    EXPECT_EQ(wrong, 0);
}
TEST(Arithmetic, products_of_16_bits_are_those_of_32) {
    constexpr int16_t kShort[] = {0, 1, -1, 127, 128, 255, 256, -128, -256, INT16_MAX, INT16_MIN};
    int wrong = 0;
    const auto differ = [](int16_t a, int16_t b) {
        volatile int32_t long_a = a, long_b = b;  // or the compiler sees what they are
        return core::product(a, b) != long_a * long_b;
    };
    for (const int16_t a : kShort)
        for (const int16_t b : kShort) wrong += differ(a, b);
    for (uint16_t i = 0; i < 20000; ++i) {
        const uint32_t both = random32();
        wrong += differ(static_cast<int16_t>(both), static_cast<int16_t>(both >> 16));
    }
    EXPECT_EQ(wrong, 0);
}
// The upper half, rounded, of a multiple: step by step, as wide as the chip counts.
int16_t upperOf(uint32_t value, uint8_t times) {
    volatile uint32_t sum = 0x8000;
    for (uint8_t i = 0; i < times; ++i) sum += value;
    return static_cast<int16_t>(sum >> 16);
}
int wrongUpper(int16_t a, int16_t b) {
    const uint32_t product = static_cast<uint32_t>(core::product(a, b));
    const int32_t number = static_cast<int32_t>(product);
    return (core::upperOf4(number) != upperOf(product, 4)) +
           (core::upperOf16(number) != upperOf(product, 16)) +
           (core::times14(a, b) != upperOf(product, 4)) +
           (core::times12(a, b) != upperOf(product, 16));
}
TEST(Arithmetic, products_with_bits_behind_the_point_are_rounded_upper_halves) {
    constexpr int16_t kShort[] = {0, 1, -1, 127, 128, 255, 256, -128, -256, INT16_MAX, INT16_MIN};
    int wrong = 0;
    for (const int16_t a : kShort)
        for (const int16_t b : kShort) wrong += wrongUpper(a, b);
    for (uint16_t i = 0; i < 5000; ++i) {
        const uint32_t both = random32();
        wrong += wrongUpper(static_cast<int16_t>(both), static_cast<int16_t>(both >> 16));
    }
    EXPECT_EQ(wrong, 0);
}
// By multiplying back, in 64 bits as the quotient may be anything.
int wrongQuotient(uint32_t a, uint32_t b) {
    const uint32_t quotient = a / b, rest = a % b;
    return rest >= b || static_cast<uint64_t>(quotient) * b + rest != a;
}
TEST(Arithmetic, quotients_of_whole_numbers_and_their_rests_make_the_dividend) {
    constexpr uint32_t kNumbers[] = {1,          2,          3,         255,        256,
                                     257,        0x7FFF,     0x8000,    0xFFFF,     0x10000,
                                     0x10001,    0xFFFFFF,   0x1000000, 0x40000000, 0x7FFFFFFF,
                                     0x80000000, 0xFFFFFFFE, UINT32_MAX};
    int wrong = 0;
    for (const uint32_t b : kNumbers) {
        wrong += wrongQuotient(0, b);
        for (const uint32_t a : kNumbers) wrong += wrongQuotient(a, b);
    }
    for (uint16_t i = 0; i < 10000; ++i) {
        const uint32_t a = random32() >> (i & 31), b = random32() >> (i >> 5 & 31);
        if (b == 0) continue;
        wrong += wrongQuotient(a, b);
        const int32_t signed_a = static_cast<int32_t>(a), signed_b = static_cast<int32_t>(b);
        if (signed_b == -1) continue;
        wrong += signed_a / signed_b * signed_b + signed_a % signed_b != signed_a;
    }
    EXPECT_EQ(wrong, 0);
}
TEST(Arithmetic, conversions_round_to_the_nearest) {
    int wrong = 0;
    for (uint16_t i = 0; i < 20000; ++i) {
        const int16_t raw = static_cast<int16_t>(random32() >> (i & 15));
        const float value = static_cast<float>(raw) * (1.0f / 1024);
        wrong += core::fromFixed(raw, 10) != value;
        wrong += core::toFixed(value, 10) != raw;
        const float between = static_cast<float>(static_cast<int32_t>(random32()) >> (i & 31)) / 64;
        const float up = between + (between < 0 ? -0.5f : 0.5f);
        const int32_t expected =
            fabsf(between) < 8388608.0f ? static_cast<int32_t>(up) : static_cast<int32_t>(between);
        wrong += core::rounded(between) != expected;
        const int16_t narrow = expected > INT16_MAX   ? INT16_MAX
                               : expected < INT16_MIN ? INT16_MIN
                                                      : static_cast<int16_t>(expected);
        wrong += core::toFixed(between / 4096, 12) != narrow;
    }
    EXPECT_EQ(wrong, 0);
    constexpr float kArduPlaneExtension[] = {32767.6f, 1e6f, 1e38f, INFINITY};
    for (const float beyond : kArduPlaneExtension) {
        EXPECT_EQ(core::toFixed(beyond, 0), INT16_MAX);
        EXPECT_EQ(core::toFixed(-beyond, 0), INT16_MIN);
        EXPECT_EQ(core::toFixed(beyond, 14), INT16_MAX);
    }
    EXPECT_EQ(core::toFixed(0, 14), 0);
    EXPECT_EQ(core::toFixed(1e-30f, 14), 0);
    EXPECT_EQ(core::toFixed(1e-40f, 14), 0);
}
float limitedByOrder(float value, float lowest, float highest) {
    if (core::orderOf(value) < core::orderOf(lowest)) return lowest;
    return core::orderOf(highest) < core::orderOf(value) ? highest : value;
}
TEST(Arithmetic, limits_are_those_of_the_order_of_bits) {
    int found = 0;
    for (const uint32_t limit : kEdges)
        found += differences(
            [limit](float a, float b) {
                const float c = floatOf(limit);
                return bitsOf(core::limit(a, b, c)) == bitsOf(limitedByOrder(a, b, c)) &&
                       bitsOf(core::limit(a, c, b)) == bitsOf(limitedByOrder(a, c, b));
            },
            1000);
    EXPECT_EQ(found, 0);
}
TEST(Arithmetic, comparisons_say_what_the_librarys_do) {
    EXPECT_EQ(differences([](float a, float b) {
                  const int8_t order = librarysOrder(a, b);
                  const bool number = a == a && b == b;
                  return (a < b) == (order < 0) && (a == b) == (order == 0) &&
                         (a != b) == (order != 0) && (a <= b) == (order <= 0) &&
                         (a > b) == (number && order > 0) && (a >= b) == (number && order >= 0);
              }),
              0);
}

}  // namespace
