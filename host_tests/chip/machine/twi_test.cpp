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

TEST_F(TwiTest, a_hung_bus_never_answers_and_the_interface_can_be_turned_off) {
    EXPECT_EQ(machine.report(6).low & 0x10, 0) << "the stop before has gone out";
    EXPECT_EQ(machine.report(7).low & 0x80, 0);
    EXPECT_EQ(machine.report(8).low, 0);
}
