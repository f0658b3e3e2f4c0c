// SPDX-License-Identifier: GPL-3.0-or-later
#include "machine.hpp"

class EepromTest : public testing::Test {
protected:
    EepromTest() {
        std::vector<uint8_t> image(4096, 0xFF);
        image[0x10] = 0x77;
        machine.chip.eeprom().setContents(image);
    }
    uint8_t byte(size_t address) { return machine.chip.eeprom().contents()[address]; }

    Machine machine{"eeprom"};
};

TEST_F(EepromTest, a_byte_takes_3_4_ms_and_the_next_waits) {
    machine.run_ms(30);

    EXPECT_EQ(machine.report(1).low, 0x77);
    EXPECT_LT(machine.cyclesBetween(1, 2), 100);
    EXPECT_NEAR(machine.cyclesBetween(2, 3), 54400, 100);
    EXPECT_NEAR(machine.cyclesBetween(3, 4), 54400, 100);
    EXPECT_EQ(machine.report(4).low, 0xA5);
    EXPECT_EQ(byte(0x12), 0xA6);
}

TEST_F(EepromTest, a_write_without_its_master_bit_is_refused) {
    machine.run_ms(30);
    EXPECT_EQ(machine.report(5).low & 0x02, 0);
    EXPECT_EQ(byte(0x13), 0xFF);
}

TEST_F(EepromTest, the_ready_interrupt_comes_as_long_as_it_is_ready) {
    machine.run_ms(40);

    EXPECT_EQ(machine.report(7).low, 5) << "four bytes, and once to be turned off";
    EXPECT_NEAR(machine.cyclesBetween(6, 7), 4 * 54400, 1000);
    for (uint8_t i = 0; i < 4; i++) EXPECT_EQ(byte(0x200 + i), 0x30 + i);
}

TEST_F(EepromTest, a_power_cut_leaves_the_byte_in_flight_erased) {
    std::vector<uint8_t> image(4096, 0x55);
    machine.chip.eeprom().setContents(image);
    machine.run_ms(1);

    EXPECT_TRUE(machine.chip.eeprom().busy());
    EXPECT_EQ(byte(0x11), 0xFF);
    EXPECT_EQ(byte(0x12), 0x55);
}

TEST_F(EepromTest, a_reset_lets_the_write_under_way_finish) {
    machine.run_ms(1);
    machine.chip.reset(simulator::Reset::external);
    machine.run_ms(5);

    // The program, started again, waits for it before it writes the same byte.
    const Report second = machine.reports.at(3);
    ASSERT_EQ(second.number, 2);
    EXPECT_NEAR(static_cast<double>(second.cycle), 54400, 1000);
}

TEST_F(EepromTest, a_worn_cell_holds_its_stuck_bit) {
    simulator::WornCells worn;
    worn.stick(0x11, 0x02, true);
    machine.chip.eeprom().wear(worn);
    machine.run_ms(30);
    EXPECT_EQ(byte(0x11), 0xA7);
    EXPECT_EQ(machine.report(4).low, 0xA7);
}
