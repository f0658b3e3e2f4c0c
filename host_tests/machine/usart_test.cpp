// SPDX-License-Identifier: GPL-3.0-or-later
#include "machine/machine.hpp"

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

TEST_F(UsartTest, nothing_is_received_before_the_receiver_is_on) {
    usart.receive('x');
    machine.run_ms(1);
    EXPECT_EQ(received(), "");
    EXPECT_EQ(machine.report(4).low, 0x20) << "only the empty flag after reset";
}

TEST_F(UsartTest, three_bytes_survive_deafness_and_the_rest_is_told_as_overrun) {
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
