// SPDX-License-Identifier: GPL-3.0-or-later
#include "machine.hpp"

class PinsTest : public testing::Test {
protected:
    PinsTest() {
        machine.chip.drive('E', 6, false);
        machine.run_ms(1);
    }
    size_t interrupts() const { return machine.reports.size(); }
    bool sensed() { return machine.chip.avr()->data[simulator::kGpior1] & 2; }

    Machine machine{"pins"};
};

TEST_F(PinsTest, int6_comes_once_for_each_rising_edge) {
    EXPECT_EQ(interrupts(), 0u);
    for (size_t edge = 1; edge <= 3; edge++) {
        machine.chip.drive('E', 6, true);
        machine.run_ms(1);
        EXPECT_EQ(interrupts(), edge);
        EXPECT_TRUE(machine.reports.back().low & 1 << 6);
        machine.chip.drive('E', 6, false);
        machine.run_ms(1);
        EXPECT_EQ(interrupts(), edge);
    }
}

TEST_F(PinsTest, a_driven_input_keeps_its_level_while_its_port_is_written) {
    EXPECT_TRUE(sensed()) << "pulled up";
    machine.chip.drive('A', 1, false);
    machine.run_ms(1);
    EXPECT_FALSE(sensed());
    machine.chip.drive('A', 1, true);
    machine.run_ms(1);
    EXPECT_TRUE(sensed());
}

TEST(OutputPins, a_compare_that_has_the_pin_is_what_its_port_reads) {
    constexpr int kPin = 1 << 5;
    Machine machine("output_pins");
    machine.run_ms(60);
    EXPECT_TRUE(machine.report(1).low & kPin) << "in the pulse";
    EXPECT_FALSE(machine.report(2).low & kPin) << "after it, though the port's bit is set";
    EXPECT_TRUE(machine.report(3).low & kPin) << "the port has it again";
}
