// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include "bench.hpp"

namespace {

// What the board looked like when the program reported a number.
struct Picture {
    bool imu, barometer, flash, relay, led_a;
};

class Pictures : public Bench {
public:
    Pictures() : Bench("spi") {
        const auto report = chip.on_trace;
        chip.on_trace = [this, report](uint8_t number) {
            report(number);
            of[number] = {chip.outputHigh('B', 0), chip.outputHigh('G', 1), chip.outputHigh('A', 6),
                          chip.outputHigh('B', 7), chip.outputHigh('A', 5)};
        };
    }
    Picture of[256] = {};
};

}  // namespace

TEST(HalPins, start_deselects_every_device_and_leaves_relay_and_lights_off) {
    Pictures bench;
    bench.runTo(1);

    EXPECT_TRUE(bench.of[1].imu);
    EXPECT_TRUE(bench.of[1].barometer);
    EXPECT_TRUE(bench.of[1].flash);
    EXPECT_FALSE(bench.of[1].relay);
    EXPECT_TRUE(bench.of[1].led_a);  // active low
}

TEST(HalPins, start_raises_the_imu_select_before_it_touches_the_barometers) {
    Bench bench("spi");
    bool imu_was_high = false, barometer_touched = false;
    bench.chip.onPort('G', [&] {
        if (!barometer_touched) imu_was_high = bench.chip.outputHigh('B', 0);
        barometer_touched = true;
    });
    bench.runTo(1);

    EXPECT_TRUE(barometer_touched);
    EXPECT_TRUE(imu_was_high);
}

TEST(HalPins, roles_switch_their_pins) {
    Pictures bench;
    bench.runTo(3);

    EXPECT_FALSE(bench.of[2].led_a);
    EXPECT_TRUE(bench.of[2].relay);
    EXPECT_FALSE(bench.of[3].imu);
}

TEST(HalSpi, exchanges_bytes_at_8_MHz_and_at_500_kHz) {
    Bench bench("spi");
    std::vector<int> sent;
    bench.chip.spi().on_exchange = [&sent](uint8_t mosi) {
        sent.push_back(mosi);
        return static_cast<uint8_t>(mosi ^ 0xFF);
    };
    bench.runTo(7);

    EXPECT_THAT(sent, testing::ElementsAre(0xF5, 0x11, 0x22));
    EXPECT_EQ(bench.report(3).word(), 0x0A);
    EXPECT_EQ(bench.report(6).word(), 0xDD);
    EXPECT_LT(bench.cyclesBetween(3, 4), 36);  // 16 of them are the byte
    EXPECT_GT(bench.cyclesBetween(5, 6), 256);
    EXPECT_LT(bench.cyclesBetween(5, 6), 290);
}
