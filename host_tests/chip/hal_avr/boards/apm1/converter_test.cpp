// SPDX-License-Identifier: GPL-3.0-or-later
// The ADS7844 on USART2 as SPI: who asks it, when and how fast.
#include <gmock/gmock.h>

#include "host_tests/chip/hal_avr/bench.hpp"

namespace {

constexpr uint64_t kSet = 16000;     // cycles
constexpr double kLongest_ms = 1.6;  // a conversion may take, ADS7844 data sheet

class Converter : public Bench {
public:
    Converter() : Bench("ppm") {
        chip.usart(2).on_exchange = [this](uint8_t byte) {
            if (!bytes.empty() && chip.outputHigh('C', 4)) ++unselected;
            bytes.push_back({byte, chip.cycle()});
            return uint8_t{0};
        };
    }
    struct Byte {
        uint8_t sent;
        uint64_t cycle;
    };
    std::vector<Byte> bytes;
    int unselected = 0;
};

}  // namespace

// This program takes no sums: the sets end when there is room for no more, which is one that does
// not count and fifteen that do.
TEST(Apm1Converter, is_asked_every_millisecond_until_there_is_room_for_no_more) {
    Converter bench;
    bench.run_ms(500);

    std::vector<uint64_t> sets;
    for (const auto& byte : bench.bytes)
        if (byte.sent == 0x10) sets.push_back(byte.cycle);
    ASSERT_EQ(sets.size(), 16u);
    for (size_t i = 2; i < sets.size(); ++i) {
        EXPECT_NEAR(sets[i] - sets[i - 1], kSet, 640) << "no interrupt takes longer";
    }
    EXPECT_EQ(bench.bytes.size(), 16 * 2 * 6 + 4 * 2u);
    EXPECT_EQ(bench.unselected, 0);
}

TEST(Apm1Converter, is_clocked_at_less_than_its_3_2_MHz) {
    Converter bench;
    bench.run_ms(100);

    EXPECT_EQ(bench.chip.usart(2).byteCycles(), 8u * 6);  // 2.67 MHz
}

// A question begins in the first byte of a pair, its answer ends with the first of the next.
TEST(Apm1Converter, ends_each_conversion_before_what_it_holds_has_faded) {
    Converter bench;
    bench.run_ms(500);

    for (size_t i = 2; i < bench.bytes.size(); i += 2) {
        const double ms =
            static_cast<double>(bench.bytes[i].cycle - bench.bytes[i - 2].cycle) / 16000;
        EXPECT_LT(ms, kLongest_ms) << i;
    }
}

TEST(Apm1Converter, is_within_its_cost_in_each_interrupt) {
    Converter bench;
    bench.run_ms(100);

    constexpr int kSent = 53, kTimer2 = 13;
    EXPECT_LT(bench.longest(kSent), 180u);
    EXPECT_LT(bench.longest(kTimer2), 280u);
    const auto& interrupts = bench.chip.interrupts();
    EXPECT_LT(interrupts.count(kSent).cycles / interrupts.count(kSent).runs, 80u);
}
