// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <numeric>

#include "bench.hpp"
#include "hal/serial.hpp"

namespace {

constexpr int kReceived0 = 25, kEmpty0 = 26;

std::vector<uint8_t> bytes(size_t size, int seed) {
    std::vector<uint8_t> all(size);
    for (uint8_t& byte : all) byte = static_cast<uint8_t>(seed = (seed * 75 + 74) % 65537);
    return all;
}

// The other ends of the three lines: each sends its bytes at the line's own rate.
class Lines : public Bench {
public:
    struct Line {
        std::vector<uint8_t> to_send, heard;
        std::vector<uint64_t> heard_at;
        size_t sent = 0;
        uint64_t next = 0;
    };

    Lines() : Bench("serial") {
        for (int i = 0; i < 3; ++i) {
            chip.usart(i).on_sent = [this, i](uint8_t byte, uint64_t cycle) {
                line[i].heard.push_back(byte);
                line[i].heard_at.push_back(cycle);
            };
        }
    }

    void run(double ms) {
        const uint64_t end = chip.cycle() + static_cast<uint64_t>(ms * 16000);
        while (chip.cycle() < end) {
            uint64_t next = end;
            for (int i = 0; i < 3; ++i) {
                feed(i);
                if (line[i].sent < line[i].to_send.size()) next = std::min(next, line[i].next);
            }
            ASSERT_TRUE(chip.run(next)) << chip.fault();
        }
    }

    Line line[3];

private:
    void feed(int i) {
        Line& from = line[i];
        while (from.sent < from.to_send.size() && from.next <= chip.cycle()) {
            if (from.sent > 0 || from.next > 0) chip.usart(i).receive(from.to_send[from.sent++]);
            from.next = chip.cycle() + chip.usart(i).byteCycles();
        }
    }
};

}  // namespace

TEST(HalSerial, opens_each_line_at_the_rate_nearest_to_the_one_asked_for) {
    Bench bench("serial");
    bench.runTo(1);

    EXPECT_EQ(bench.chip.usart(0).baud(), 16000000u / 8 / 17);   // 115,200 + 2.1 %
    EXPECT_EQ(bench.chip.usart(1).baud(), 16000000u / 16 / 26);  // 38,400 + 0.2 %, normal mode
    EXPECT_EQ(bench.chip.usart(2).baud(), 16000000u / 8 / 35);   // 57,600 - 0.8 %
}

TEST(HalSerial, loses_nothing_both_ways_on_three_lines_at_full_rate) {
    Lines bench;
    bench.runTo(1);
    bench.line[0].to_send = bytes(2000, 1);
    bench.line[1].to_send = bytes(900, 2);
    bench.line[2].to_send = bytes(1300, 3);

    bench.run(290);

    for (const Lines::Line& each : bench.line) EXPECT_EQ(each.heard, each.to_send);
    EXPECT_THAT(bench.words(0x7F), testing::IsEmpty());
    bench.runTo(2);
    EXPECT_EQ(bench.report(2).word(), 0);
}

TEST(HalSerial, sends_without_a_gap_between_bytes) {
    Lines bench;
    bench.runTo(6);
    bench.line[2].heard_at.clear();

    bench.run(45);

    const std::vector<uint64_t>& at = bench.line[2].heard_at;
    ASSERT_EQ(at.size(), 200u);
    EXPECT_EQ(at.back() - at.front(), 199 * bench.chip.usart(2).byteCycles());
}

TEST(HalSerial, counts_what_a_full_buffer_had_to_drop_and_keeps_the_oldest) {
    Lines bench;
    bench.runTo(2);
    bench.line[0].to_send = bytes(200, 4);
    bench.run(110);

    EXPECT_EQ(bench.report(3).word(), 127);
    EXPECT_EQ(bench.report(0x21).word(), 200 - 127);
}

TEST(HalSerial, the_gps_has_buffers_of_its_own) {
    Lines bench;
    bench.runTo(2);
    bench.line[1].to_send = bytes(150, 9);
    bench.run(110);

    EXPECT_EQ(bench.report(0x23).word(), 127);
    EXPECT_EQ(bench.report(0x24).word(), 150 - 127);
    EXPECT_EQ(bench.report(0x25).word(), 31);
    EXPECT_EQ(bench.report(0x21).word(), 0);
}

TEST(HalSerial, counts_an_overrun_of_the_receiver) {
    Lines bench;
    bench.runTo(0x21);
    for (int i = 0; i < 8; ++i) bench.chip.usart(2).receive(static_cast<uint8_t>(i));
    bench.runTo(0x22);

    EXPECT_EQ(bench.report(0x22).word(),
              1);  // the hardware reports that some were lost, not how many
}

TEST(HalSerial, takes_a_whole_message_or_none_of_it) {
    Bench bench("serial");
    bench.runTo(7);

    EXPECT_EQ(bench.report(4).word(), hal::kLinkRoom);
    EXPECT_EQ(bench.report(5).word(), 1);
    EXPECT_EQ(bench.report(6).word(), 0);
    EXPECT_GE(bench.report(7).word(), 54);
    EXPECT_LE(bench.report(7).word(), 56);  // two are in the transmitter
}

TEST(HalSerial, opening_again_forgets_the_buffer_and_changes_the_rate) {
    Lines bench;
    bench.runTo(2);
    bench.line[0].to_send = bytes(60, 5);
    bench.run(110);
    bench.runTo(8);
    EXPECT_EQ(bench.report(8).word(), 0);
    EXPECT_EQ(bench.chip.usart(0).baud(), 16000000u / 8 / 35);

    bench.line[0] = {};
    bench.line[0].to_send = bytes(300, 6);
    bench.run(90);

    EXPECT_EQ(bench.line[0].heard, bench.line[0].to_send);
}

TEST(HalSerial, detects_usb_by_the_sense_pin) {
    Bench with("serial"), without("serial");
    with.chip.drive('A', 1, false);
    without.chip.drive('A', 1, true);

    EXPECT_EQ(with.runTo(0x20).word(), 1);
    EXPECT_EQ(without.runTo(0x20).word(), 0);
}

TEST(HalSerial, sends_nothing_that_was_not_given) {
    Lines bench;
    bench.runTo(11, 2000);

    EXPECT_THAT(bench.words(10), testing::ElementsAre(1));
    EXPECT_THAT(bench.words(11), testing::ElementsAre(hal::kLinkRoom));
}

TEST(HalSerial, sent_and_received_bytes_are_within_their_costs) {
    Lines bench;
    bench.runTo(1);
    bench.line[0].to_send = bytes(500, 7);
    bench.run(100);

    EXPECT_LE(bench.longest(kEmpty0), 47u);
    EXPECT_LE(bench.longest(kReceived0), 80u);
}
