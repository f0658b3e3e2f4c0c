// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ring.hpp"

#include <gtest/gtest.h>

using core::Ring;

TEST(Ring, gives_bytes_back_in_their_order_across_its_end) {
    Ring<4> ring;
    uint8_t byte = 0;

    for (uint8_t i = 0; i < 20; ++i) {
        ASSERT_TRUE(ring.put(i));
        ASSERT_TRUE(ring.put(static_cast<uint8_t>(i + 100)));
        ASSERT_TRUE(ring.take(byte));
        EXPECT_EQ(byte, i);
        ASSERT_TRUE(ring.take(byte));
        EXPECT_EQ(byte, i + 100);
    }
    EXPECT_FALSE(ring.take(byte));
}

TEST(Ring, holds_one_byte_less_than_its_size) {
    Ring<256> ring;

    for (int i = 0; i < 255; ++i) ASSERT_TRUE(ring.put(1));

    EXPECT_FALSE(ring.put(1));
    EXPECT_EQ(ring.used(), 255);
    EXPECT_EQ(ring.room(), 0);
}

TEST(Ring, takes_a_whole_message_or_none_of_it) {
    Ring<8> ring;
    const uint8_t message[] = {1, 2, 3, 4};

    EXPECT_TRUE(ring.put(message, 4));
    EXPECT_FALSE(ring.put(message, 4));
    EXPECT_EQ(ring.used(), 4);
    EXPECT_TRUE(ring.put(message, 3));

    for (uint8_t expected : {1, 2, 3, 4, 1, 2, 3}) {
        uint8_t byte = 0;
        ASSERT_TRUE(ring.take(byte));
        EXPECT_EQ(byte, expected);
    }
}

TEST(Ring, clear_forgets_everything) {
    Ring<8> ring;
    ring.put(1);

    ring.clear();

    EXPECT_TRUE(ring.empty());
    EXPECT_EQ(ring.room(), 7);
}
