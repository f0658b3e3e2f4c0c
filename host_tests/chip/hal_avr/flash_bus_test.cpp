// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include "bench.hpp"
#include "simulator/devices/at45db.hpp"

namespace {

constexpr int kUsart = 3;
constexpr int kDone = 17;

// At first a counter answers, later the chip.
class FlashBench : public Bench {
public:
    FlashBench() : Bench("flash_bus") {
        chip.onPort('A', [this] { look(); });
        chip.onPort('G', [this] { look(); });
        chip.usart(kUsart).on_exchange = [this](uint8_t out) {
            sent.push_back(out);
            cycles.push_back(chip.cycle());
            const auto answer = static_cast<uint8_t>(sent.size() - 1);
            return counting ? answer : flash.transfer(out, now_us());
        };
        const auto report = chip.on_trace;
        chip.on_trace = [this, report](uint8_t number) {
            report(number);
            if (number == 6) counting = false;
        };
    }
    uint64_t now_us() const { return chip.cycle() / 16; }
    void look() {
        const bool low = chip.isOutput('A', 6) && !chip.outputHigh('A', 6);
        if (low && !selected) {
            sent.clear();
            cycles.clear();
        }
        selected = low;
        flash.select(low, now_us());
        const bool reset = chip.isOutput('G', 0) && !chip.outputHigh('G', 0);
        if (reset && !in_reset) reset_from_us = now_us();
        if (!reset && in_reset) reset_us = now_us() - reset_from_us;
        in_reset = reset;
        flash.resetPin(reset, now_us());
    }

    simulator::At45db flash;
    std::vector<uint8_t> sent;
    std::vector<uint64_t> cycles;
    bool counting = true, selected = false, in_reset = false;
    uint64_t reset_from_us = 0, reset_us = 0;
};

}  // namespace

TEST(HalFlashBus, runs_at_8_MHz_and_a_byte_is_within_its_cost) {
    FlashBench bench;
    bench.runTo(3);

    EXPECT_EQ(bench.chip.usart(kUsart).byteCycles(), 16u);
    const auto out = bench.cyclesBetween(1, 2), in = bench.cyclesBetween(2, 3);
    EXPECT_LE(out, 100 * 18);
    EXPECT_LE(in, 100 * 18);
    EXPECT_GE(out, 100 * 16);
    EXPECT_GE(in, 100 * 16);
    ::testing::Test::RecordProperty("cycles_of_100_bytes_out", static_cast<int>(out));
    ::testing::Test::RecordProperty("cycles_of_100_bytes_in", static_cast<int>(in));
}

TEST(HalFlashBus, sends_what_it_is_given_and_receives_what_comes) {
    FlashBench bench;
    bench.runTo(3);
    for (int i = 0; i < 100; ++i) EXPECT_EQ(bench.sent[i], i);
    for (int i = 100; i < 200; ++i) EXPECT_EQ(bench.sent[i], 0);
    bench.runTo(5);

    EXPECT_EQ(bench.report(4).word(), 0);
    EXPECT_EQ(bench.report(5).word(), 201);
}

TEST(HalFlashBus, the_last_byte_is_sent_before_the_select_rises) {
    FlashBench bench;
    size_t passed = 0;
    bench.chip.onPort('A', [&] {
        if (bench.selected || passed > 0) passed = std::max(passed, bench.sent.size());
    });
    bench.runTo(5);
    bench.run_ms(0.1);

    EXPECT_GE(passed, 202u);
}

TEST(HalFlashBus, loses_no_byte_among_interrupts) {
    FlashBench bench;
    const uint64_t byte_cycles = 16000000 / 11520;
    bench.runTo(5);
    for (int i = 0; i < 9000 && bench.words(6).empty(); ++i) {
        bench.chip.usart(0).receive(static_cast<uint8_t>(i));
        bench.chip.run(bench.chip.cycle() + byte_cycles / 3);
    }

    EXPECT_EQ(bench.report(6).word(), 0);
    EXPECT_GT(bench.chip.interrupts().count(25).runs, 100u) << "of USART0 receiving";
}

TEST(HalFlashBus, the_driver_writes_and_reads_a_chip_through_it) {
    FlashBench bench;
    bench.runTo(kDone, 2000);

    EXPECT_EQ(bench.report(10).word(), 8192);
    EXPECT_GE(bench.reset_us, 1000u);
    EXPECT_EQ(bench.report(11).word(), 0);
    EXPECT_EQ(bench.report(12).word(), 0);
    EXPECT_EQ(bench.report(13).word(), 1) << "busy";
    EXPECT_NEAR(bench.report(14).word(), 17, 1);
    EXPECT_EQ(bench.report(16).word(), 0);
    EXPECT_EQ(bench.report(17).word(), 0);
    EXPECT_EQ(bench.flash.ignored(), 0u);
}

TEST(HalFlashBus, a_status_read_of_a_busy_chip_takes_15_us) {
    FlashBench bench;
    bench.runTo(kDone, 2000);

    EXPECT_EQ(bench.report(19).word(), 1);
    EXPECT_LE(bench.cyclesBetween(18, 19), 15 * 16);
    ::testing::Test::RecordProperty("cycles_of_a_look",
                                    static_cast<int>(bench.cyclesBetween(18, 19)));
}

TEST(HalFlashBus, a_record_of_14_bytes_is_read_within_50_us) {
    FlashBench bench;
    bench.runTo(kDone, 2000);

    EXPECT_LE(bench.cyclesBetween(15, 16), 50 * 16);
    ::testing::Test::RecordProperty("cycles_of_a_record",
                                    static_cast<int>(bench.cyclesBetween(15, 16)));
}
