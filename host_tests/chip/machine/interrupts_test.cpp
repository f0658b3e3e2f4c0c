// SPDX-License-Identifier: GPL-3.0-or-later
#include "machine.hpp"

using simulator::Interrupts;

class InterruptTest : public testing::Test {
protected:
    InterruptTest() { machine.run_ms(1); }
    Machine machine{"interrupts"};
};

TEST_F(InterruptTest, entry_takes_5_cycles_and_reti_5) {
    const std::vector<Report>& r = machine.reports;
    ASSERT_GE(r.size(), 3u);
    ASSERT_EQ(r[0].number, 2);
    ASSERT_EQ(r[1].number, 1);
    ASSERT_EQ(r[2].number, 2);

    // out 1, sbi 2, one instruction more at most; 5 of entry, 3 of the vector's jmp; then back:
    // out 1, reti 5, the nop if it was not yet done.
    EXPECT_EQ(r[2].cycle - r[0].cycle, 1u + 2 + 5 + 3 + 1 + 5 + 1);
}

TEST_F(InterruptTest, an_interrupt_out_of_sleep_takes_5_more) {
    constexpr int kTimer2Overflow = 15;
    constexpr int kInt0 = 1;
    EXPECT_EQ(machine.chip.interrupts().count(kInt0).max_cycles, 5u + 3 + 1 + 5);
    EXPECT_EQ(machine.chip.interrupts().count(kTimer2Overflow).max_cycles, 5u + 5 + 3 + 1 + 5);
}

TEST_F(InterruptTest, sleep_without_permission_does_nothing) {
    EXPECT_EQ(machine.report(22).word(), 0);
}

TEST_F(InterruptTest, a_one_written_to_a_flag_register_clears_that_flag_only) {
    constexpr int kCompareAB = 0x06;
    EXPECT_EQ(machine.report(10).high & kCompareAB, 0x06);
    EXPECT_EQ(machine.report(10).low & kCompareAB, 0x02);
    EXPECT_EQ(machine.report(11).low & kCompareAB, 0x04) << "by sbi";
    EXPECT_EQ(machine.report(13).word(), 0x00) << "EIFR";
}

TEST_F(InterruptTest, a_flag_raised_while_masked_fires_when_enabled) {
    EXPECT_EQ(machine.report(12).word(), 1);
}
