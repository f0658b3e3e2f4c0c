// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include "bench.hpp"
#include "wires.hpp"

namespace {

constexpr uint64_t kPeriod = 16000 * 20;

struct Pulse {
    uint64_t begin, width;
    double us() const { return static_cast<double>(width) / 16; }
};

// The timer changes the pin itself: widths are exact.
class Servos : public Bench {
public:
    Servos() : Bench("pwm") {
        for (int i = 0; i < 8; ++i) {
            const wires::Output& output = wires::kServos[i];
            chip.onCompareOutput(output.timer, output.compare,
                                 [this, i](bool high, uint64_t cycle) { changed(i, high, cycle); });
        }
    }
    // Those of an output that began between two reports.
    std::vector<Pulse> between(int output, int from, int to) const {
        std::vector<Pulse> found;
        for (const Pulse& each : pulses[output]) {
            if (each.begin > report(from).cycle && each.begin < report(to).cycle) {
                found.push_back(each);
            }
        }
        return found;
    }
    std::vector<Pulse> pulses[8];

private:
    void changed(int output, bool high, uint64_t cycle) {
        if (high) {
            rise_[output] = cycle;
        } else {
            pulses[output].push_back({rise_[output], cycle - rise_[output]});
        }
    }
    uint64_t rise_[8] = {};
};

}  // namespace

TEST(HalPwm, is_silent_until_a_pulse_is_asked_for) {
    Servos bench;
    bench.runTo(1);

    for (const auto& each : bench.pulses) EXPECT_TRUE(each.empty());
}

TEST(HalPwm, gives_every_output_its_own_width_to_half_a_microsecond) {
    Servos bench;
    bench.runTo(2);

    for (int i = 0; i < 8; ++i) {
        const auto pulses = bench.between(i, 1, 2);
        ASSERT_GE(pulses.size(), 4u) << "output " << i + 1;
        for (const Pulse& each : pulses) {
            EXPECT_NEAR(each.us(), 1000 + 100.5 * i, 1.0 / 16) << "output " << i + 1;
        }
        for (size_t k = 1; k < pulses.size(); ++k) {
            EXPECT_NEAR(pulses[k].begin - pulses[k - 1].begin, kPeriod, 0);
        }
    }
    EXPECT_EQ(bench.report(2).word(), 2000 + 201 * 3);
}

TEST(HalPwm, a_change_at_any_moment_makes_no_pulse_that_was_not_asked_for) {
    Servos bench;
    bench.runTo(3, 60000);

    for (int i = 0; i < 8; ++i) {
        const auto pulses = bench.between(i, 2, 3);
        ASSERT_GT(pulses.size(), 50u);
        for (size_t k = 0; k < pulses.size(); ++k) {
            EXPECT_GT(pulses[k].us(), 999);
            EXPECT_LT(pulses[k].us(), 2001);
            if (k == 0) continue;
            EXPECT_NEAR(pulses[k].begin - pulses[k - 1].begin, kPeriod, 0) << "output " << i + 1;
        }
    }
}

TEST(HalPwm, silencing_lets_the_last_pulse_end_and_then_none_comes) {
    Servos bench;
    bench.runTo(5, 60000);

    EXPECT_EQ(bench.report(4).word(), 0);  // reads as silent at once
    for (int i = 0; i < 8; ++i) {
        EXPECT_LE(bench.between(i, 4, 5).size(), 1u);
        EXPECT_GT(bench.pulses[i].back().us(), 999);
    }
}

TEST(HalPwm, silence_and_waking_at_any_moment_never_cut_a_pulse_short) {
    Servos bench;
    bench.runTo(6, 60000);

    const auto pulses = bench.between(2, 5, 6);
    ASSERT_GT(pulses.size(), 60u);
    for (const Pulse& each : pulses) EXPECT_NEAR(each.us(), 1500, 1.0 / 16);
}

TEST(HalPwm, runs_at_400_Hz_and_keeps_a_pulse_within_its_period) {
    Servos bench;
    bench.runTo(7, 60000);

    const auto pulses = bench.between(0, 6, 7);
    ASSERT_GT(pulses.size(), 35u);
    EXPECT_NEAR(pulses.back().us(), 2200, 1.0 / 16);
    EXPECT_NEAR(pulses[20].begin - pulses[19].begin, 16000 * 2.5, 0);
    EXPECT_LT(bench.report(7).word(), 5000);
}

TEST(HalPwm, a_start_in_the_middle_of_a_pulse_lengthens_none_after_it) {
    Servos bench;
    bench.runTo(11, 60000);

    for (int i = 0; i < 8; ++i) {
        for (const int from : {8, 10}) {
            const auto pulses = bench.between(i, from, from + 1);
            ASSERT_GE(pulses.size(), 2u);
            for (const Pulse& each : pulses) {
                EXPECT_NEAR(each.us(), 1500, 1.0 / 16) << "output " << i + 1 << ", " << from;
            }
        }
    }
}

// On the first board the clock counts with the timer of two outputs.
TEST(HalPwm, leaves_the_clock_alone) {
    Servos bench;
    bench.runTo(2);

    // wait_ms(50) to the first report and wait_ms(100) to the second, by the chip's own clock
    EXPECT_NEAR(bench.cyclesBetween(1, 2) / 16000.0, 100, 0.5);
}
