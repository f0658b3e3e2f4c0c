// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include "bench.hpp"

using testing::ElementsAre;

namespace {

constexpr int kVector = 30;
constexpr int kOk = 0, kBusy = 1, kBadArgument = 3;
constexpr double kByte_ms = 3.4;

std::vector<int> cells(const Bench& bench, int from, int size) {
    const std::vector<uint8_t> all = bench.chip.eeprom().contents();
    return {all.begin() + from, all.begin() + from + size};
}

}  // namespace

TEST(HalEeprom, writes_what_was_queued_in_its_order) {
    Bench bench("eeprom");
    bench.runTo(4);

    EXPECT_THAT(bench.words(1), ElementsAre(kOk, kOk));
    EXPECT_THAT(cells(bench, 100, 4), ElementsAre(1, 9, 3, 4));
    EXPECT_EQ(bench.chip.eeprom().writes(), 5u);  // 1 2 3 4, then 9 for the 2; 3 was there
}

TEST(HalEeprom, writes_again_what_a_low_supply_has_changed) {
    Bench bench("eeprom");
    bench.chip.eeprom().endanger(true);
    bench.run_ms(150);
    EXPECT_GT(bench.chip.eeprom().writes(), 4u);
    EXPECT_THAT(cells(bench, 101, 3), ElementsAre(0xFF, 0xFF, 0xFF)) << "no other before it";
    bench.chip.eeprom().endanger(false);
    bench.runTo(4);
    EXPECT_THAT(cells(bench, 100, 4), ElementsAre(1, 9, 3, 4));
}

TEST(HalEeprom, gives_up_on_a_worn_cell_and_goes_on) {
    Bench bench("eeprom");
    simulator::WornCells worn;
    worn.stick(100, 0x80, true);
    bench.chip.eeprom().wear(worn);
    bench.runTo(4, 2000);
    EXPECT_THAT(cells(bench, 100, 4), ElementsAre(0x81, 9, 3, 4));
    EXPECT_EQ(bench.chip.eeprom().writes(), 25 + 4u);
}

TEST(HalEeprom, serves_readers_between_the_writes_of_a_worn_cell) {
    Bench bench("eeprom");
    simulator::WornCells worn;
    worn.stick(100, 0x80, true);
    bench.chip.eeprom().wear(worn);
    bench.run_ms(100);
    const auto before = bench.chip.eeprom().writes();
    bench.run_ms(330);
    EXPECT_NEAR(bench.chip.eeprom().writes() - before, 10, 1) << "one in 33 ms, of 3.4 ms";
}

TEST(HalEeprom, shows_queued_bytes_as_if_written) {
    Bench bench("eeprom");
    bench.runTo(4);

    EXPECT_EQ(bench.report(2).word(), 9);
    EXPECT_EQ(bench.report(3).word(), 0);  // and they were still queued then
    EXPECT_LT(bench.cyclesBetween(1, 2), 16000 * (kByte_ms + 0.1));
    EXPECT_EQ(bench.report(4).word(), 1);
}

TEST(HalEeprom, rests_until_the_reader_that_was_busy_has_been_served) {
    Bench bench("eeprom");
    bench.runTo(0x15);

    EXPECT_EQ(bench.report(0x10).word(), kBusy);
    EXPECT_EQ(bench.report(0x11).word(), kOk);
    EXPECT_EQ(bench.report(0x12).word(), 0);
    EXPECT_EQ(bench.report(0x13).word(), kOk);
    EXPECT_EQ(bench.report(0x14).word(), 0x47);
    EXPECT_EQ(cells(bench, 200, 1)[0], 0x40);
    EXPECT_EQ(cells(bench, 202, 1)[0], 0xFF);  // rested after the first, went on after 0x13
}

TEST(HalEeprom, goes_on_after_131_ms_when_the_reader_does_not_come_back) {
    Bench bench("eeprom");
    bench.runTo(0x17);

    EXPECT_EQ(bench.report(0x15).word(), kBusy);
    EXPECT_EQ(bench.report(0x16).word(), 0);
    EXPECT_EQ(bench.report(0x17).word(), 1);
}

TEST(HalEeprom, refuses_what_lies_outside_and_what_the_queue_cannot_hold) {
    Bench bench("eeprom");
    bench.runTo(0x30);

    EXPECT_EQ(bench.report(0x20).word(), kBadArgument);
    EXPECT_EQ(bench.report(0x21).word(), kBadArgument);
    EXPECT_EQ(bench.report(0x22).word(), kBadArgument);
    EXPECT_EQ(bench.report(0x23).word(), kOk);
    EXPECT_EQ(bench.report(0x24).word(), kOk);
    EXPECT_EQ(bench.report(0x25).word(), kBusy);
    EXPECT_EQ(cells(bench, 40, 1)[0], 0xFF);
}

TEST(HalEeprom, does_not_wear_cells_that_hold_their_value) {
    Bench bench("eeprom");
    bench.runTo(0x30);
    const uint64_t before = bench.chip.eeprom().writes();
    bench.runTo(0x31);

    EXPECT_EQ(bench.chip.eeprom().writes(), before);
    EXPECT_LT(bench.cyclesBetween(0x30, 0x31), 16000);
}

TEST(HalEeprom, a_power_cut_leaves_records_in_order_and_one_byte_erased) {
    Bench bench("eeprom");
    bench.runTo(0x40);
    bench.run_ms(100);

    for (int cut = 0; cut < 60; ++cut) {
        bench.run_ms(1.7);
        const std::vector<int> record = cells(bench, 1000, 14);
        int erased = 0, changes = 0;
        for (size_t i = 0; i < record.size(); ++i) erased += record[i] == 0xFF;
        std::vector<int> whole;
        for (int byte : record) {
            if (byte != 0xFF) whole.push_back(byte);
        }
        for (size_t i = 1; i < whole.size(); ++i) {
            changes += whole[i] != whole[i - 1];
            EXPECT_LE(whole[i], whole[i - 1]);
        }
        EXPECT_LE(erased, 1);
        EXPECT_LE(changes, 1);
    }
}

TEST(HalEeprom, the_interrupt_is_within_its_cost) {
    Bench bench("eeprom");
    bench.runTo(0x40);

    EXPECT_LE(bench.longest(kVector), 120u);
}
