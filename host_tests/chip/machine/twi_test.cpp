// SPDX-License-Identifier: GPL-3.0-or-later
#include "machine.hpp"

class TwiTest : public testing::Test {
protected:
    TwiTest() {
        simulator::TwiDevice device;
        device.start = [this](bool read) { return log.push_back(read ? "read" : "write"), true; };
        device.write = [this](uint8_t byte) {
            return log.push_back("w" + std::to_string(byte)), true;
        };
        device.read = [this](bool ack) {
            log.push_back(ack ? "ack" : "last");
            return static_cast<uint8_t>(0xA0 + next++);
        };
        device.stop = [this] { log.push_back("stop"); };
        machine.chip.twi().connect(0x1E, device);
        machine.chip.on_trace = [this, note = machine.chip.on_trace](uint8_t number) {
            note(number);
            machine.chip.twi().hang(number == 6);
        };
        machine.run_ms(20);
    }
    Machine machine{"twi"};
    std::vector<std::string> log;
    int next = 0;
};

TEST_F(TwiTest, a_device_sees_each_element_of_the_transfers) {
    const std::vector<std::string> expected = {"write", "w2",   "w112", "stop", "write",
                                               "w3",    "read", "ack",  "ack",  "ack",
                                               "ack",   "ack",  "last", "stop"};
    ASSERT_GE(log.size(), expected.size());
    log.resize(expected.size());
    EXPECT_EQ(log, expected);
}

TEST_F(TwiTest, statuses_and_bytes_reach_the_program) {
    EXPECT_EQ(machine.report(2).low, 0x28);
    EXPECT_EQ(machine.report(3).low, 0x58);
    EXPECT_EQ(machine.report(4).high, 0xA0);
    EXPECT_EQ(machine.report(4).low, 0xA5);
    EXPECT_EQ(machine.report(5).low, 0x20) << "nobody at this address";
}

TEST_F(TwiTest, the_bus_takes_its_time) {
    constexpr int kBit = 16 + 2 * 12;
    const int64_t took = machine.cyclesBetween(1, 2);  // start, three bytes
    EXPECT_GE(took, (1 + 3 * 9) * kBit);
    EXPECT_LE(took, (1 + 3 * 9) * kBit + 5 * 100) << "five interrupts";
}

TEST(TwoWires, that_rise_slowly_lengthen_every_bit) {
    const auto took = [](double rise_ns) {
        Machine machine("twi");
        machine.chip.twi().rise(rise_ns);
        machine.run_ms(50);
        return machine.cyclesBetween(1, 2);
    };
    constexpr int64_t bits = 1 + 9, poll = 12;  // start and an address that nobody answers
    EXPECT_NEAR(took(300) - took(0), bits * 5, poll) << "4.8 cycles";
    EXPECT_NEAR(took(1000) - took(0), bits * 16, poll);
}

TEST_F(TwiTest, a_hung_bus_never_answers_and_the_interface_can_be_turned_off) {
    EXPECT_EQ(machine.report(6).low & 0x10, 0) << "the stop before has gone out";
    EXPECT_EQ(machine.report(7).low & 0x80, 0);
    EXPECT_EQ(machine.report(8).low, 0);
}

class TwiDisturbed : public testing::Test {
protected:
    TwiDisturbed() {
        simulator::TwiDevice device;
        device.start = [](bool) { return true; };
        device.write = [this](uint8_t byte) { return written.push_back(byte), true; };
        device.read = [](bool) { return uint8_t{0x5A}; };
        device.stop = [] {};
        machine.chip.twi().connect(0x1E, device);
    }
    // After report 5, in the middle of a transfer.
    void runWith(simulator::FaultKind kind) {
        machine.chip.on_trace = [this, kind, note = machine.chip.on_trace](uint8_t number) {
            note(number);
            if (number == 5) machine.chip.twi().fail(kind);
        };
        machine.run_ms(20);
    }
    Machine machine{"twi_refused"};
    std::vector<int> written;
};

TEST_F(TwiDisturbed, nobody_answers_after_an_address_that_was_refused) {
    runWith(simulator::FaultKind::none);
    EXPECT_EQ(machine.report(1).low, 0x20);
    EXPECT_EQ(machine.report(2).low, 0x30);
    EXPECT_EQ(machine.report(3).low, 0x48);
    EXPECT_EQ(machine.report(4).low, 0) << "there is nothing to read";
    EXPECT_EQ(machine.report(7).low, 0x28);
    EXPECT_EQ(written, (std::vector<int>{0x12}));
}

TEST_F(TwiDisturbed, a_one_bit_loses_against_sda_held_low_and_no_stop_comes_through) {
    runWith(simulator::FaultKind::sda_low);
    EXPECT_EQ(machine.report(7).low, 0x38);
    EXPECT_EQ(machine.report(8).low & 0x10, 0x10);
    EXPECT_TRUE(written.empty());
}

TEST_F(TwiDisturbed, scl_held_low_stops_everything_until_it_is_released) {
    runWith(simulator::FaultKind::scl_low);
    EXPECT_EQ(machine.report(6).low, 0) << "no end";
    const uint8_t* const data = machine.chip.avr()->data;
    EXPECT_EQ(data[simulator::kTwcr] & 0x10, 0x10) << "the stop waits";
    machine.chip.twi().fail(simulator::FaultKind::none);
    machine.run_ms(1);
    EXPECT_EQ(data[simulator::kTwcr] & 0x10, 0);
}
