// SPDX-License-Identifier: GPL-3.0-or-later
// GoogleTest's words, as far as the tests of the pure libraries use them, for the chip: no
// exceptions, no streams, one program after the other. Values are compared as numbers, whatever
// their types: int has 16 bits here.
#pragma once
#include <stdint.h>
#include <stdio.h>

#include <string>
#include <vector>

namespace testing {

// ---- saying
void sayText(const char* text);
void sayInteger(long long value);
void sayReal(double value);

template <class T>
struct IsInteger {
    static constexpr bool value = __is_enum(T);
};
// clang-format off
#define ON_CHIP_INTEGER(type) template <> struct IsInteger<type> { static constexpr bool value = true; };
ON_CHIP_INTEGER(bool) ON_CHIP_INTEGER(char) ON_CHIP_INTEGER(signed char) ON_CHIP_INTEGER(unsigned char)
ON_CHIP_INTEGER(short) ON_CHIP_INTEGER(unsigned short) ON_CHIP_INTEGER(int) ON_CHIP_INTEGER(unsigned)
ON_CHIP_INTEGER(long) ON_CHIP_INTEGER(unsigned long)
ON_CHIP_INTEGER(long long) ON_CHIP_INTEGER(unsigned long long)
#undef ON_CHIP_INTEGER
    // clang-format on

    template <class T>
    struct Show {
    static void say(const T& value) { sayAny(value, Number<IsInteger<T>::value>()); }

private:
    template <bool>
    struct Number {};
    static void sayAny(const T& value, Number<true>) { sayInteger(static_cast<long long>(value)); }
    static void sayAny(const T&, Number<false>) { sayText("(an object)"); }
};
template <>
struct Show<float> {
    static void say(float value) { sayReal(value); }
};
template <>
struct Show<double> {
    static void say(double value) { sayReal(value); }
};
template <>
struct Show<const char*> {
    static void say(const char* value) { sayText(value); }
};
template <>
struct Show<char*> {
    static void say(const char* value) { sayText(value); }
};
template <size_t N>
struct Show<char[N]> {
    static void say(const char* value) { sayText(value); }
};
template <>
struct Show<std::string> {
    static void say(const std::string& value) {
        for (char letter : value) {
            const char text[] = {letter, 0};
            sayText(text);
        }
    }
};
template <class T>
struct Show<std::vector<T>> {
    static void say(const std::vector<T>& value) {
        sayText("{");
        for (const T& each : value) {
            Show<T>::say(each);
            sayText(" ");
        }
        sayText("}");
    }
};

// What a test adds behind a check that failed.
class Said {
public:
    Said() = default;
    Said(const Said&) = delete;
    ~Said();
    template <class T>
    const Said& operator<<(const T& value) const {
        Show<T>::say(value);
        return *this;
    }
};
struct Stop {  // return Stop() = Said() << ...: nothing, so that void tests may
    void operator=(const Said&) const {}
};

// ---- comparing: the line that is said when it fails stands with the numbers
struct Place {
    const char *file, *check, *left, *right;
    int line;
};
void failed(const Place& place);  // begins the report of a failure
bool failedCheck(const Place& place, bool expected);

template <class A, class B>
bool failedPair(const Place& place, const A& a, const B& b) {
    failed(place);
    sayText("\n  left: ");
    Show<A>::say(a);
    sayText(", right: ");
    Show<B>::say(b);
    sayText(" ");
    return false;
}

template <bool integers>
struct Meet {
    template <class A, class B>
    static bool equal(const A& a, const B& b) {
        return a == b;
    }
    template <class A, class B>
    static bool less(const A& a, const B& b) {
        return a < b;
    }
    template <class A, class B>
    static bool lessOrEqual(const A& a, const B& b) {
        return a <= b;
    }
};
template <>
struct Meet<true> {
    static bool equal(long long a, long long b) { return a == b; }
    static bool less(long long a, long long b) { return a < b; }
    static bool lessOrEqual(long long a, long long b) { return a <= b; }
};
template <class A, class B>
using MeetOf = Meet<IsInteger<A>::value && IsInteger<B>::value && !__is_enum(A) && !__is_enum(B)>;

#define ON_CHIP_COMPARISON(name, condition)                  \
    template <class A, class B>                              \
    bool name(const Place& place, const A& a, const B& b) {  \
        return (condition) ? true : failedPair(place, a, b); \
    }
ON_CHIP_COMPARISON(checkEq, (MeetOf<A, B>::equal(a, b)))
ON_CHIP_COMPARISON(checkNe, !(MeetOf<A, B>::equal(a, b)))
ON_CHIP_COMPARISON(checkLt, (MeetOf<A, B>::less(a, b)))
ON_CHIP_COMPARISON(checkLe, (MeetOf<A, B>::lessOrEqual(a, b)))
ON_CHIP_COMPARISON(checkGt, (MeetOf<B, A>::less(b, a)))
ON_CHIP_COMPARISON(checkGe, (MeetOf<B, A>::lessOrEqual(b, a)))
#undef ON_CHIP_COMPARISON
bool checkNear(const Place& place, double a, double b, double apart);
bool checkFloatEq(const Place& place, float a, float b);  // within 4 units in the last place

// ---- tests
class Test {
public:
    virtual ~Test() {}
    void run();
    static bool HasFailure();
    template <class T>
    static void RecordProperty(const char*, const T&) {}

protected:
    virtual void SetUp() {}
    virtual void TearDown() {}

private:
    virtual void TestBody() = 0;
};

struct Registered {
    const char *suite, *name;
    Test* (*make)();
    Registered* next = nullptr;
    Registered(const char* of_suite, const char* its_name, Test* (*maker)());
};

}  // namespace testing

#define ON_CHIP_TEST(suite, name, fixture)                                                 \
    class suite##_##name##_Test : public fixture {                                         \
    public:                                                                                \
        static ::testing::Test* make() { return new suite##_##name##_Test; }               \
                                                                                           \
    private:                                                                               \
        void TestBody() override;                                                          \
    };                                                                                     \
    static ::testing::Registered suite##_##name##_registered(#suite, #name,                \
                                                             suite##_##name##_Test::make); \
    void suite##_##name##_Test::TestBody()
#define TEST(suite, name) ON_CHIP_TEST(suite, name, ::testing::Test)
#define TEST_F(fixture, name) ON_CHIP_TEST(fixture, name, fixture)

#define ON_CHIP_PLACE(check, a, b) \
    ::testing::Place { __FILE__, check, a, b, __LINE__ }
// the switch keeps a dangling else of the test from meaning this if
#define ON_CHIP_EXPECT(passed) \
    switch (0)                 \
    case 0:                    \
    default:                   \
        if (passed)            \
            ;                  \
        else                   \
            ::testing::Said()
#define ON_CHIP_ASSERT(passed) \
    switch (0)                 \
    case 0:                    \
    default:                   \
        if (passed)            \
            ;                  \
        else                   \
            return ::testing::Stop() = ::testing::Said()
#define ON_CHIP_PAIR(level, check, function, a, b) \
    level(::testing::function(ON_CHIP_PLACE(check, #a, #b), a, b))
#define ON_CHIP_BOOL(level, check, a, wanted) \
    level(static_cast<bool>(a) == wanted ||   \
          ::testing::failedCheck(ON_CHIP_PLACE(check, #a, nullptr), wanted))

#define EXPECT_EQ(a, b) ON_CHIP_PAIR(ON_CHIP_EXPECT, "EQ", checkEq, a, b)
#define EXPECT_NE(a, b) ON_CHIP_PAIR(ON_CHIP_EXPECT, "NE", checkNe, a, b)
#define EXPECT_LT(a, b) ON_CHIP_PAIR(ON_CHIP_EXPECT, "LT", checkLt, a, b)
#define EXPECT_LE(a, b) ON_CHIP_PAIR(ON_CHIP_EXPECT, "LE", checkLe, a, b)
#define EXPECT_GT(a, b) ON_CHIP_PAIR(ON_CHIP_EXPECT, "GT", checkGt, a, b)
#define EXPECT_GE(a, b) ON_CHIP_PAIR(ON_CHIP_EXPECT, "GE", checkGe, a, b)
#define EXPECT_FLOAT_EQ(a, b) ON_CHIP_PAIR(ON_CHIP_EXPECT, "FLOAT_EQ", checkFloatEq, a, b)
#define EXPECT_TRUE(a) ON_CHIP_BOOL(ON_CHIP_EXPECT, "TRUE", a, true)
#define EXPECT_FALSE(a) ON_CHIP_BOOL(ON_CHIP_EXPECT, "FALSE", a, false)
#define EXPECT_NEAR(a, b, apart) \
    ON_CHIP_EXPECT(::testing::checkNear(ON_CHIP_PLACE("NEAR", #a, #b), a, b, apart))

#define ASSERT_EQ(a, b) ON_CHIP_PAIR(ON_CHIP_ASSERT, "EQ", checkEq, a, b)
#define ASSERT_NE(a, b) ON_CHIP_PAIR(ON_CHIP_ASSERT, "NE", checkNe, a, b)
#define ASSERT_LT(a, b) ON_CHIP_PAIR(ON_CHIP_ASSERT, "LT", checkLt, a, b)
#define ASSERT_LE(a, b) ON_CHIP_PAIR(ON_CHIP_ASSERT, "LE", checkLe, a, b)
#define ASSERT_GT(a, b) ON_CHIP_PAIR(ON_CHIP_ASSERT, "GT", checkGt, a, b)
#define ASSERT_GE(a, b) ON_CHIP_PAIR(ON_CHIP_ASSERT, "GE", checkGe, a, b)
#define ASSERT_FLOAT_EQ(a, b) ON_CHIP_PAIR(ON_CHIP_ASSERT, "FLOAT_EQ", checkFloatEq, a, b)
#define ASSERT_TRUE(a) ON_CHIP_BOOL(ON_CHIP_ASSERT, "TRUE", a, true)
#define ASSERT_FALSE(a) ON_CHIP_BOOL(ON_CHIP_ASSERT, "FALSE", a, false)
#define ASSERT_NEAR(a, b, apart) \
    ON_CHIP_ASSERT(::testing::checkNear(ON_CHIP_PLACE("NEAR", #a, #b), a, b, apart))

#define ADD_FAILURE() \
    ON_CHIP_EXPECT(::testing::failedCheck(ON_CHIP_PLACE("ADD_FAILURE", "", nullptr), true))
#define FAIL() ON_CHIP_ASSERT(::testing::failedCheck(ON_CHIP_PLACE("FAIL", "", nullptr), true))
