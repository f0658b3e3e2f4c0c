// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include "bench.hpp"

using testing::ElementsAre;

namespace {

constexpr int kVector = 29;
constexpr int kAirspeed = 0, kVoltage = 1, kCurrent = 2, kBandGap = 3;

double volts(int pin) {
    switch (pin) {
        case 0:
            return 2.5;
        case 13:
            return 1.25;
        case 12:
            return 0.5;
        default:
            return 4.9;
    }
}

int counts(double v) { return static_cast<int>(v / 5 * 1024); }

class HalAnalog : public testing::Test {
public:
    HalAnalog() : bench("adc") { bench.chip.adc().volts = volts; }
    std::vector<int> count(int input) { return bench.words(0x10 + input); }
    std::vector<int> sum(int input) { return bench.words(0x20 + input); }
    Bench bench;
};

}  // namespace

TEST_F(HalAnalog, has_nothing_before_the_first_scan) {
    bench.runTo(1);

    for (int input = 0; input < 4; ++input) EXPECT_THAT(count(input), ElementsAre(0));
}

TEST_F(HalAnalog, scans_each_input_as_often_as_its_part_asks) {
    bench.runTo(2);

    EXPECT_EQ(count(kAirspeed)[1], 4);
    EXPECT_EQ(sum(kAirspeed)[1], 4 * counts(2.5));
    EXPECT_EQ(count(kVoltage)[1], 1);
    EXPECT_EQ(sum(kVoltage)[1], counts(1.25));
    EXPECT_EQ(sum(kCurrent)[1], counts(0.5));
    EXPECT_NEAR(sum(kBandGap)[1], counts(1.1), 1);
}

TEST_F(HalAnalog, a_second_request_does_not_disturb_the_scan_under_way) {
    bench.runTo(2);

    EXPECT_EQ(bench.chip.interrupts().count(kVector).runs, 13u);
}

TEST_F(HalAnalog, sums_that_are_not_read_do_not_overflow) {
    bench.runTo(3);

    EXPECT_LE(count(kAirspeed)[2], 60);
    EXPECT_EQ(sum(kAirspeed)[2], count(kAirspeed)[2] * counts(2.5));
    EXPECT_EQ(count(kVoltage)[2], 40);
}

TEST_F(HalAnalog, disturbs_nobodys_sleep_between_two_scans) {
    bench.runTo(3);
    bench.run_ms(2);
    const auto runs = bench.chip.interrupts().count(kVector).runs;
    bench.run_ms(200);

    EXPECT_EQ(bench.chip.interrupts().count(kVector).runs, runs);
}

TEST_F(HalAnalog, a_conversion_is_within_its_cost) {
    bench.runTo(3);

    EXPECT_LE(bench.longest(kVector), 190u);
}
