// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fixed.hpp"

#include <gmock/gmock.h>

#include "bench.hpp"

TEST(FixedOnTheChip, multiplies_as_the_host_does) {
    Bench bench("fixed");
    bench.runTo(5, 2000);

    const auto low = bench.words(1), high = bench.words(2);
    const auto product_low = bench.words(3), product_high = bench.words(4);
    ASSERT_EQ(product_high.size(), 2000u);
    uint32_t random = 1;
    for (size_t i = 0; i < product_high.size(); ++i) {
        random = random * 1664525 + 1013904223;
        int32_t a = static_cast<int32_t>(random);
        random = random * 1664525 + 1013904223;
        int16_t b = static_cast<int16_t>(random >> 16);
        if (i % 16 == 0) b = INT16_MIN;
        if (i % 24 == 0) a = INT32_MIN;
        const auto both = static_cast<uint32_t>(core::times16(a, b));
        ASSERT_EQ(high[i] << 16 | low[i], both) << a << " * " << b;
        const auto product = static_cast<uint32_t>(core::product(static_cast<int16_t>(a >> 16), b));
        ASSERT_EQ(product_high[i] << 16 | product_low[i], product) << (a >> 16) << " * " << b;
    }
}
