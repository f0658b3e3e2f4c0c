// SPDX-License-Identifier: GPL-3.0-or-later
// The products of core/fixed.hpp, which on this chip are made of 16-bit ones.
#include "core/fixed.hpp"

#include "report.hpp"

namespace hal {
bool imuDataReady() { return false; }
}  // namespace hal

int main() {
    board::start();
    uint32_t random = 1;
    for (uint16_t i = 0; i < 2000; ++i) {
        random = random * 1664525 + 1013904223;
        int32_t a = static_cast<int32_t>(random);
        random = random * 1664525 + 1013904223;
        int16_t b = static_cast<int16_t>(random >> 16);
        if (i % 16 == 0) b = INT16_MIN;
        if (i % 24 == 0) a = INT32_MIN;
        const int32_t both = core::times16(a, b);
        report(1, static_cast<uint16_t>(both));
        report(2, static_cast<uint16_t>(both >> 16));
        const int32_t product = core::product(static_cast<int16_t>(a >> 16), b);
        report(3, static_cast<uint16_t>(product));
        report(4, static_cast<uint16_t>(product >> 16));
    }
    report(5, 0);
    for (;;) {
    }
}
