// SPDX-License-Identifier: GPL-3.0-or-later
// The ADS7844 on USART2 as SPI: who asks it, when and how fast.
#include <gmock/gmock.h>

#include "hal_avr/bench.hpp"

namespace {

class Converter : public Bench {
public:
    Converter() : Bench("ppm") {
        chip.usart(2).on_exchange = [this](uint8_t byte) {
            if (byte == 0x87) sets.push_back(chip.cycle());
            if (chip.outputHigh('C', 4)) ++unselected;
            last = chip.cycle();
            ++bytes;
            return uint8_t{0};
        };
    }
    std::vector<uint64_t> sets;  // when the first question had gone out
    uint64_t last = 0;
    int bytes = 0, unselected = 0;
};

}  // namespace

// This program takes no sums: the sets end when there is room for no more.
TEST(Apm1Converter, is_asked_every_millisecond_until_there_is_room_for_no_more) {
    Converter bench;
    bench.run_ms(500);

    ASSERT_EQ(bench.sets.size(), 15u);
    for (size_t i = 2; i < bench.sets.size(); ++i) {
        EXPECT_NEAR(bench.sets[i] - bench.sets[i - 1], 16000, 640) << "no interrupt takes longer";
    }
    EXPECT_EQ(bench.bytes, 16 * 15);
    EXPECT_EQ(bench.unselected, 0);
}

TEST(Apm1Converter, is_clocked_at_less_than_its_3_2_MHz_and_done_in_a_tenth_of_the_time) {
    Converter bench;
    bench.run_ms(100);
    while (bench.bytes % 16 != 0) bench.run_ms(0.01);

    EXPECT_EQ(bench.chip.usart(2).byteCycles(), 8u * 6);  // 2.67 MHz
    EXPECT_LT(bench.last - bench.sets.back(), 2400u);     // 150 us
}

TEST(Apm1Converter, takes_little_of_each_interrupt) {
    Converter bench;
    bench.run_ms(100);

    constexpr int kSent = 53, kTimer2 = 13;
    EXPECT_LT(bench.longest(kSent), 160u);
    EXPECT_LT(bench.longest(kTimer2), 110u);
}
