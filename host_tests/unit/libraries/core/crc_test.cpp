// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/crc.hpp"

#include <gtest/gtest.h>

namespace {

TEST(Crc, gives_the_published_check_value) {
    EXPECT_EQ(core::crc16(core::kCrcStart, "123456789", 9), 0x6F91);
}

TEST(Crc, is_what_its_polynomial_says_for_every_byte) {
    for (uint32_t start = 0; start <= 0xFFFF; start += 257)
        for (uint32_t byte = 0; byte <= 0xFF; ++byte) {
            uint32_t crc = start ^ byte;
            for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1) != 0 ? 0x8408u : 0);

            EXPECT_EQ(core::crc16(static_cast<uint16_t>(start), static_cast<uint8_t>(byte)), crc);
        }
}

}  // namespace
