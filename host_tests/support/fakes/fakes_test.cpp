// SPDX-License-Identifier: GPL-3.0-or-later
// The doubles fulfil the contracts they stand for; most of all the EEPROM, whose power tests cut.
#include "fakes/fakes.hpp"

#include <gtest/gtest.h>

#include "hal/clock.hpp"
#include "hal/eeprom.hpp"
#include "hal/i2c.hpp"

namespace {

using core::Status;

class Fakes : public testing::Test {
    void SetUp() override { fakes::reset(); }
};

TEST_F(Fakes, eeprom_shows_a_queued_byte_before_it_is_in_its_cell) {
    fakes::setEepromSlow(true);
    const uint8_t out[2] = {1, 2};
    uint8_t in[2] = {};

    ASSERT_EQ(hal::eepromWrite(10, out, 2), Status::ok);
    ASSERT_EQ(hal::eepromRead(10, in, 2), Status::busy);
    fakes::advance_us(3400);

    ASSERT_EQ(hal::eepromRead(10, in, 2), Status::ok);
    EXPECT_EQ(in[1], 2);
    EXPECT_EQ(fakes::eepromCell(10), 1);
    EXPECT_EQ(fakes::eepromCell(11), 0xFF);
}

TEST_F(Fakes, eeprom_rests_for_a_waiting_reader_but_not_for_ever) {
    fakes::setEepromSlow(true);
    const uint8_t out[3] = {1, 2, 3};
    uint8_t in = 0;
    ASSERT_EQ(hal::eepromWrite(0, out, 3), Status::ok);
    ASSERT_EQ(hal::eepromRead(0, &in, 1), Status::busy);

    fakes::advance_ms(50);
    EXPECT_EQ(fakes::eepromWrites(), 1u);
    EXPECT_EQ(fakes::eepromCell(1), 0xFF);
    fakes::advance_ms(95);

    EXPECT_EQ(fakes::eepromCell(1), 2);
    EXPECT_EQ(fakes::eepromCell(2), 3);
    EXPECT_TRUE(hal::eepromDrained());
}

TEST_F(Fakes, eeprom_refuses_what_the_queue_cannot_hold_and_queues_none_of_it) {
    fakes::setEepromSlow(true);
    const uint8_t out[32] = {};

    ASSERT_EQ(hal::eepromWrite(0, out, 30), Status::ok);

    EXPECT_EQ(hal::eepromWrite(100, out, 3), Status::busy);
    EXPECT_EQ(hal::eepromWrite(4095, out, 2), Status::bad_argument);
    fakes::advance_ms(200);
    EXPECT_TRUE(hal::eepromDrained());
    EXPECT_EQ(fakes::eepromCell(100), 0xFF);
}

TEST_F(Fakes, a_power_cut_leaves_the_byte_in_flight_erased_and_loses_the_rest) {
    const uint8_t out[4] = {1, 2, 3, 4};
    uint8_t seen[4] = {};
    fakes::cutPowerAfter(2);

    ASSERT_EQ(hal::eepromWrite(0, out, 4), Status::ok);

    EXPECT_TRUE(fakes::powerWasCut());
    ASSERT_EQ(hal::eepromRead(0, seen, 4), Status::ok);
    EXPECT_EQ(seen[3], 4);  // the program runs on and sees no difference
    fakes::restartEeprom();
    ASSERT_EQ(hal::eepromRead(0, seen, 4), Status::ok);
    EXPECT_EQ(seen[0], 1);
    EXPECT_EQ(seen[1], 2);
    EXPECT_EQ(seen[2], 0xFF);
    EXPECT_EQ(seen[3], 0xFF);
}

TEST_F(Fakes, a_byte_that_holds_its_value_costs_no_write) {
    const uint8_t out[2] = {0xFF, 7};

    ASSERT_EQ(hal::eepromWrite(0, out, 2), Status::ok);

    EXPECT_EQ(fakes::eepromWrites(), 1u);
}

TEST_F(Fakes, the_bus_records_transactions_by_pin) {
    fakes::Bus::reply({0, 0x68});

    fakes::Pin<0>::low();
    fakes::Bus::transfer(0xF5);
    EXPECT_EQ(fakes::Bus::transfer(0), 0x68);
    fakes::Pin<0>::high();

    ASSERT_EQ(fakes::Bus::transactions.size(), 1u);
    EXPECT_EQ(fakes::Bus::transactions[0].sent, (std::vector<uint8_t>{0xF5, 0}));
    EXPECT_FALSE(fakes::Bus::transactions[0].locked);
    EXPECT_EQ(fakes::Bus::clashes, 0);
}

TEST_F(Fakes, an_i2c_bus_without_a_device_times_out) {
    const uint8_t out = 0;
    uint8_t in = 0;

    ASSERT_TRUE(hal::i2cStart(hal::I2cUser::compass, 0x1E, &out, 1, 1));

    EXPECT_EQ(hal::i2cResult(hal::I2cUser::compass, &in, 1), Status::timeout);
}

TEST_F(Fakes, the_receiver_ages_with_the_clock) {
    uint16_t pulse_us[hal::kRcChannels];
    EXPECT_EQ(hal::rcAge_us(), UINT32_MAX);

    fakes::receiveRc({1500, 1500, 1100, 1500, 1800});
    fakes::advance_ms(20);

    EXPECT_EQ(hal::rcAge_us(), 20000u);
    EXPECT_TRUE(hal::rcRead(pulse_us));
    EXPECT_EQ(pulse_us[4], 1800);
    EXPECT_EQ(pulse_us[5], 0);
    EXPECT_FALSE(hal::rcRead(pulse_us));
}

}  // namespace
