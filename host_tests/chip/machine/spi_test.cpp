// SPDX-License-Identifier: GPL-3.0-or-later
#include "machine.hpp"

class SpiTest : public testing::Test {
protected:
    SpiTest() {
        machine.chip.spi().on_exchange = [this](uint8_t mosi) {
            out.push_back(mosi);
            return static_cast<uint8_t>(mosi + 1);
        };
        machine.chip.usart(3).on_exchange = [this](uint8_t mosi) {
            usart_times.push_back(machine.chip.cycle());
            return static_cast<uint8_t>(mosi + 2);
        };
        machine.run_ms(2);
    }
    Machine machine{"spi"};
    std::vector<uint8_t> out;
    std::vector<uint64_t> usart_times;
};

TEST_F(SpiTest, a_byte_takes_eight_clocks_of_the_rate_chosen) {
    const int divider[] = {4, 16, 64, 128, 2, 8, 32, 64};
    for (int rate = 0; rate < 8; rate++) {
        const int64_t took = machine.cyclesBetween(10 + rate, 20 + rate);
        EXPECT_GE(took, divider[rate] * 8) << "SPI2X and SPR " << rate;
        EXPECT_LE(took, divider[rate] * 8 + 18) << "SPI2X and SPR " << rate;
        EXPECT_EQ(machine.report(20 + rate).low, 0x41 + rate);
    }
}

TEST_F(SpiTest, a_write_during_a_byte_collides_and_is_dropped) {
    EXPECT_EQ(machine.report(30).high, 0xC0);
    EXPECT_EQ(machine.report(30).low, 2);
    EXPECT_EQ(machine.report(31).low, 0) << "both flags go when the data is read";
    EXPECT_EQ(std::count(out.begin(), out.end(), 2), 0);
}

TEST_F(SpiTest, the_interrupt_brings_the_byte) { EXPECT_EQ(machine.report(32).low, 6); }

TEST_F(SpiTest, usart3_as_master_takes_16_cycles_times_its_divider) {
    EXPECT_EQ(machine.report(40).low, 0x12);
    EXPECT_EQ(machine.report(41).high, 0x22);
    EXPECT_EQ(machine.report(41).low, 0x32);
    ASSERT_EQ(usart_times.size(), 3u);
    EXPECT_NEAR(static_cast<double>(usart_times[2] - usart_times[1]), 16 * 3, 4);
}
