// SPDX-License-Identifier: GPL-3.0-or-later
// The receiver's pulses on ICP4, captured by the timer that two servo outputs share.
#include <gmock/gmock.h>

#include "hal_avr/bench.hpp"

namespace {

constexpr int kFrame = 0x20;
constexpr double kGap_us = 10500;

class Receiver : public Bench {
public:
    Receiver() : Bench("ppm") {
        run_ms(1);
        next_us_ = static_cast<double>(chip.cycle()) / 16;
        chip.captureEdge('4', true, chip.cycle());
    }
    void interval(double us) {
        next_us_ += us;
        const auto cycle = static_cast<uint64_t>(next_us_ * 16);
        ASSERT_TRUE(chip.run(cycle)) << chip.fault();
        chip.captureEdge('4', true, cycle);
    }
    void frame(const std::vector<double>& channels_us) {
        for (double us : channels_us) interval(us);
        interval(kGap_us);
    }
    std::vector<int> channels() const {
        std::vector<int> last;
        for (int i = 1; i <= 8; ++i) last.push_back(words(i).empty() ? -1 : words(i).back());
        return last;
    }

private:
    double next_us_ = 0;
};

}  // namespace

TEST(Apm1Receiver, is_decoded_to_the_microsecond) {
    Receiver bench;
    bench.interval(kGap_us);
    for (int i = 0; i < 20; ++i) bench.frame({1000, 1100, 1200.5, 1300, 1400, 1500, 1600, 2000});

    EXPECT_EQ(bench.words(kFrame).size(), 20u);
    EXPECT_THAT(bench.channels(),
                testing::ElementsAre(1000, 1100, 1200, 1300, 1400, 1500, 1600, 2000));
}

TEST(Apm1Receiver, that_falls_silent_is_told_by_its_age) {
    Receiver bench;
    bench.interval(kGap_us);
    bench.frame({1500, 1500, 1500, 1500, 1500, 1500, 1500, 1500});
    bench.run_ms(300);

    EXPECT_NEAR(bench.words(0x21).back(), 3000 + 105, 120);  // 0.1 ms
}
