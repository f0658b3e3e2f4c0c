// SPDX-License-Identifier: GPL-3.0-or-later
// Runs every test that is linked in and reports to run_on_chip.cpp: letters through GPIOR1, then 0
// (all passed) or 1 through GPIOR0.
#include <avr/io.h>
#include <gtest/gtest.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

namespace {
struct LeftOut {
    const char *suite, *name, *why;
};
#define LEFT_OUT(suite, name, why) {#suite, #name, why},
const LeftOut kLeftOut[] = {
#include ON_CHIP_LEFT_OUT
    {"", "", ""}};
}  // namespace

void* operator new(size_t size) {
    void* memory = malloc(size);
    if (memory == nullptr) abort();
    return memory;
}
void operator delete(void* memory) { free(memory); }
void operator delete(void* memory, size_t) { free(memory); }
extern "C" void __cxa_pure_virtual() { abort(); }

namespace testing {
namespace {

Registered *first, *last;
bool any_failure;
int failures, ran, left_out;

int put(char letter, FILE*) {
    GPIOR1 = static_cast<uint8_t>(letter);
    return 0;
}
FILE out;

[[noreturn]] void end(bool passed) {
    GPIOR0 = passed ? 0 : 1;
    for (;;) {
    }
}

const LeftOut* leftOut(const Registered& test) {
    for (const LeftOut& each : kLeftOut)
        if (strcmp(each.suite, test.suite) == 0 && strcmp(each.name, test.name) == 0) return &each;
    return nullptr;
}

// A row of the table without its test would hide the next mistake.
void refuseStaleRows() {
    for (const LeftOut& each : kLeftOut) {
        if (each.suite[0] == 0) continue;
        bool found = false;
        for (Registered* test = first; test; test = test->next) found |= leftOut(*test) == &each;
        if (found) continue;
        printf("left_out: there is no test %s.%s\n", each.suite, each.name);
        end(false);
    }
}

void runOne(const Registered& test) {
    if (const LeftOut* row = leftOut(test)) {
        printf("[ LEFT OUT ] %s.%s: %s\n", test.suite, test.name, row->why);
        ++left_out;
        return;
    }
    printf("[ RUN      ] %s.%s\n", test.suite, test.name);
    any_failure = false;
    Test* made = test.make();
    made->run();
    delete made;
    ++ran;
    if (any_failure) ++failures;
    printf("[ %s ] %s.%s\n", any_failure ? " FAILED " : "     OK ", test.suite, test.name);
}

}  // namespace

void sayText(const char* text) { fputs(text, stdout); }
void sayInteger(long long value) {
    char digits[24];
    uint8_t at = sizeof digits - 1;
    const bool negative = value < 0;
    unsigned long long rest = negative ? 0 - static_cast<unsigned long long>(value)
                                       : static_cast<unsigned long long>(value);
    digits[at] = 0;
    do {
        digits[--at] = static_cast<char>('0' + rest % 10);
        rest /= 10;
    } while (rest != 0);
    if (negative) digits[--at] = '-';
    sayText(digits + at);
}
void sayReal(double value) {
    char text[20];
    sayText(dtostre(value, text, 7, 0));
}

Said::~Said() { sayText("\n"); }

void failed(const Place& place) {
    any_failure = true;
    printf("%s:%d: %s(%s", place.file, place.line, place.check, place.left);
    if (place.right) printf(", %s", place.right);
    sayText(") ");
}
bool failedCheck(const Place& place, bool) {
    failed(place);
    return false;
}
bool checkNear(const Place& place, double a, double b, double apart) {
    const double difference = a < b ? b - a : a - b;
    return difference <= apart || failedPair(place, a, b);
}
bool checkFloatEq(const Place& place, float a, float b) {
    const float difference = a < b ? b - a : a - b, size = a < 0 ? -a : a;
    return difference <= 4 * 1.2e-7f * size || a == b || failedPair(place, a, b);
}

void Test::run() {
    SetUp();
    TestBody();
    TearDown();
}
bool Test::HasFailure() { return any_failure; }

Registered::Registered(const char* of_suite, const char* its_name, Test* (*maker)())
    : suite(of_suite), name(its_name), make(maker) {
    (first ? last->next : first) = this;
    last = this;
}

}  // namespace testing

int main() {
    using namespace testing;
    fdev_setup_stream(&out, put, nullptr, _FDEV_SETUP_WRITE);
    stdout = &out;
    refuseStaleRows();
    for (Registered* test = first; test; test = test->next) runOne(*test);
    printf("%d tests, %d failed, %d left out\n", ran, failures, left_out);
    end(failures == 0 && ran > 0);
}
