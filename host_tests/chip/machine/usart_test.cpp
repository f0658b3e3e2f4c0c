// SPDX-License-Identifier: GPL-3.0-or-later
#include "machine.hpp"

class UsartTest : public testing::Test {
protected:
    UsartTest() {
        usart.on_sent = [this](uint8_t byte, uint64_t cycle) { sent.push_back({byte, cycle}); };
    }
    void feed(const std::string& text) {
        for (char each : text) {
            machine.run_ms(kByteCycles / 16000.0);
            usart.receive(static_cast<uint8_t>(each));
        }
        machine.run_ms(kByteCycles / 16000.0);
    }
    std::string received() {
        std::string text;
        for (const Report& each : machine.reports)
            if (each.number == 1) text += static_cast<char>(each.low);
        return text;
    }

    static constexpr uint64_t kByteCycles = 35 * 8 * 10;
    struct Sent {
        uint8_t byte;
        uint64_t cycle;
    };
    Machine machine{"usart"};
    simulator::Usart& usart = machine.chip.usart(2);
    std::vector<Sent> sent;
};

TEST_F(UsartTest, bytes_leave_back_to_back_at_the_bit_rate) {
    machine.run_ms(15);

    ASSERT_EQ(sent.size(), 64u);
    EXPECT_EQ(usart.byteCycles(), kByteCycles);
    EXPECT_EQ(usart.baud(), 16000000u / (35 * 8));
    for (size_t i = 1; i < sent.size(); i++) {
        EXPECT_EQ(sent[i].byte, i);
        EXPECT_EQ(sent[i].cycle - sent[i - 1].cycle, kByteCycles);
    }
}

TEST_F(UsartTest, transmit_complete_comes_once_after_the_last_byte) {
    machine.run_ms(15);

    const Report done = machine.report(3);
    EXPECT_EQ(done.low, 64);
    EXPECT_NEAR(static_cast<double>(done.cycle), static_cast<double>(sent.back().cycle), 100);
    EXPECT_EQ(std::count_if(machine.reports.begin(), machine.reports.end(),
                            [](const Report& each) { return each.number == 3; }),
              1);
}

TEST_F(UsartTest, each_of_its_interrupts_wakes_the_chip_once) {
    machine.run_ms(15);

    EXPECT_NEAR(machine.report(5).low, 64, 2);
}

TEST_F(UsartTest, nothing_is_received_before_the_receiver_is_on) {
    usart.receive('x');
    machine.run_ms(1);
    EXPECT_EQ(received(), "");
    EXPECT_EQ(machine.report(4).low, 0x20) << "only the empty flag after reset";
}

TEST_F(UsartTest, three_unread_bytes_are_kept_and_the_rest_is_reported_as_overrun) {
    machine.run_ms(1);
    feed("abd12345");
    machine.run_ms(25);

    EXPECT_EQ(received(), "abd123");
    int overruns = 0;
    for (const Report& each : machine.reports) overruns += each.number == 1 && each.high;
    EXPECT_EQ(overruns, 1);
}

TEST_F(UsartTest, a_reset_empties_it) {
    machine.run_ms(1);
    machine.chip.reset(simulator::Reset::external);
    sent.clear();
    machine.run_ms(1);

    ASSERT_FALSE(sent.empty());
    EXPECT_EQ(sent[0].byte, 0);
}

class UsartSpiTest : public testing::Test {
protected:
    UsartSpiTest() {
        machine.chip.usart(2).on_exchange = [this](uint8_t) { return unclocked++; };
        machine.chip.usart(3).on_exchange = [this](uint8_t out) {
            exchanged.push_back(out);
            return static_cast<uint8_t>(out + 1);
        };
        machine.run_ms(1);
    }
    Machine machine{"usart_spi"};
    std::vector<uint8_t> exchanged;
    uint8_t unclocked = 0;
};

TEST_F(UsartSpiTest, nothing_moves_while_the_clock_pin_is_no_output) {
    EXPECT_EQ(machine.report(1).low & 0xC0, 0) << "neither received nor sent";
    EXPECT_EQ(unclocked, 0);
    EXPECT_EQ(machine.report(2).low & 0xC0, 0xC0);
}

TEST_F(UsartSpiTest, the_receiver_holds_three_bytes_that_nobody_reads) {
    EXPECT_EQ(exchanged, (std::vector<uint8_t>{0x11, 0x22, 0x33, 0x44}));
    std::vector<int> read;
    for (const Report& each : machine.reports)
        if (each.number == 3 && each.high & 0x80) read.push_back(each.low);
    EXPECT_EQ(read, (std::vector<int>{0x12, 0x23, 0x34}));
}
