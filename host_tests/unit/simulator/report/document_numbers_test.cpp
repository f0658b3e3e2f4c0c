// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/report/document_numbers.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

using namespace simulator;

TEST(Base64, is_that_of_rfc_4648) {
    const auto of = [](const std::string& text) {
        return base64(std::vector<uint8_t>(text.begin(), text.end()));
    };
    EXPECT_EQ(of(""), "");
    EXPECT_EQ(of("f"), "Zg==");
    EXPECT_EQ(of("fo"), "Zm8=");
    EXPECT_EQ(of("foo"), "Zm9v");
    EXPECT_EQ(of("foobar"), "Zm9vYmFy");
}

TEST(Steps, span_the_range_of_the_values) {
    const Steps steps = stepsOf({-10, 0, 10});

    EXPECT_EQ(steps.offset, 0);
    EXPECT_DOUBLE_EQ(steps.scale * 32767, 10);
    EXPECT_EQ(steps.base64, base64({0x01, 0x80, 0x00, 0x00, 0xFF, 0x7F}));
}

TEST(Steps, mark_what_is_not_known) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(stepsOf({kNone}).base64, base64({0x00, 0x80}));
    const Steps steps = stepsOf({4, kNone});
    EXPECT_EQ(steps.offset, 4);
    EXPECT_EQ(steps.base64, base64({0x00, 0x00, 0x00, 0x80}));
}

TEST(Floats, are_little_endian) { EXPECT_EQ(floatsOf({1.0}), base64({0x00, 0x00, 0x80, 0x3F})); }
