// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include "bench.hpp"

using testing::ElementsAre;
using testing::Ge;
using testing::IsSupersetOf;

namespace {

constexpr int kVector = 39;
constexpr int kOk = 0, kBusy = 1, kTimeout = 2;

// Remembers what is written, and reads 0x11, 0x22, ... from the address that was set.
class Compass : public Bench {
public:
    Compass() : Bench("twi") {
        simulator::TwiDevice device;
        device.start = [this](bool read) {
            events.push_back(read ? 'R' : 'W');
            return answers;
        };
        device.write = [this](uint8_t byte) {
            written.push_back(byte);
            return true;
        };
        device.read = [this](bool ack) {
            events.push_back(ack ? 'a' : 'n');
            return static_cast<uint8_t>(0x11 * ++reads);
        };
        device.stop = [this] { events.push_back('.'); };
        chip.twi().connect(0x1E, device);
    }
    std::string events;
    std::vector<int> written;
    int reads = 0;
    bool answers = true;
};

}  // namespace

TEST(HalTwi, writes_reads_and_reads_after_a_repeated_start) {
    Compass bench;
    bench.runTo(6);

    EXPECT_THAT(bench.written, ElementsAre(0x00, 0x78, 0x20, 0x00, 3));
    EXPECT_EQ(bench.events.substr(0, 14), "W.WRaaaaan.Rn.");
    const std::vector<int> in = bench.words(4);
    EXPECT_THAT(in, ElementsAre(0x11, 0x22, 0x33, 0x44, 0x55, 0x66, 0x77));
}

TEST(HalTwi, takes_400_kHz) {
    Compass bench;
    bench.runTo(4);

    // address, register, address, 6 bytes of 9 bits, and starts and stop: 2.5 us a bit
    EXPECT_NEAR(bench.words(3)[1], 9 * 9 * 2.5, 100);
    EXPECT_EQ(bench.chip.twi().bitCycles(), 40u);
}

TEST(HalTwi, refuses_a_transfer_too_long_or_while_one_runs) {
    Compass bench;
    bench.runTo(7);

    EXPECT_THAT(bench.words(5), ElementsAre(0));
    EXPECT_THAT(bench.words(6), ElementsAre(1, 0));
}

TEST(HalTwi, gives_its_result_once) {
    Compass bench;
    bench.runTo(1, 1000);
    bench.run_ms(5);

    EXPECT_THAT(bench.words(7), ElementsAre(kOk, kTimeout));
}

TEST(HalTwi, reports_at_once_that_nothing_answers_and_goes_on_at_100_kHz) {
    Compass bench;
    bench.run_ms(30);

    EXPECT_EQ(bench.words(2)[3], kTimeout);
    EXPECT_LT(bench.words(3)[3], 300);
    EXPECT_EQ(bench.chip.twi().bitCycles(), 160u);
    EXPECT_EQ(bench.words(2)[4], kOk);
}

TEST(HalTwi, a_hung_bus_is_abandoned_after_5_ms_clocked_free_and_used_again) {
    Compass bench;
    bench.run_ms(30);
    int clocks = 0, stops = 0;
    bool clock_low = false;
    bench.chip.onPort('D', [&] {
        const bool low = bench.chip.isOutput('D', 0);
        clocks += clock_low && !low;
        clock_low = low;
        stops += !low && bench.chip.isOutput('D', 1);
    });
    bench.chip.twi().hang(true);
    bench.run_ms(40);
    bench.chip.twi().hang(false);
    const size_t before = bench.words(2).size();
    bench.run_ms(40);

    EXPECT_THAT(bench.words(2), testing::Contains(kTimeout).Times(Ge(2)));
    EXPECT_THAT(clocks % 10, 0);  // nine, and the one of the stop
    EXPECT_GE(clocks, 20);
    EXPECT_GE(stops, 2);
    for (int us : bench.words(3)) EXPECT_LT(us, 5400);
    EXPECT_GT(bench.words(2).size(), before);
    EXPECT_EQ(bench.words(2).back(), kOk);
}

TEST(HalTwi, a_byte_is_within_its_cost) {
    Compass bench;
    bench.run_ms(100);

    EXPECT_LE(bench.longest(kVector), 110u);
}
