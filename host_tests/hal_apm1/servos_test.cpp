// SPDX-License-Identifier: GPL-3.0-or-later
// The first board's outputs 1..8: OC5B, OC5C, OC1B, OC1C, and on the clock's own timer OC4C and
// OC4B, then OC3C and OC3B. The program is the one that tries those of the APM 2.
#include <gmock/gmock.h>

#include "hal_avr/bench.hpp"

namespace {

struct Output {
    char timer;
    int compare;
};
constexpr Output kOutputs[8] = {{'5', 1}, {'5', 2}, {'1', 1}, {'1', 2},
                                {'4', 2}, {'4', 1}, {'3', 2}, {'3', 1}};
constexpr uint64_t kPeriod = 16000 * 20;

struct Pulse {
    uint64_t begin, width;
    double us() const { return static_cast<double>(width) / 16; }
};

class Servos : public Bench {
public:
    Servos() : Bench("pwm") {
        for (int i = 0; i < 8; ++i) {
            chip.onCompareOutput(kOutputs[i].timer, kOutputs[i].compare,
                                 [this, i](bool high) { changed(i, high); });
        }
    }
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
    void changed(int output, bool high) {
        if (high) {
            rise_[output] = chip.cycle();
        } else {
            pulses[output].push_back({rise_[output], chip.cycle() - rise_[output]});
        }
    }
    uint64_t rise_[8] = {};
};

}  // namespace

TEST(Apm1Servos, are_silent_until_a_pulse_is_asked_for) {
    Servos bench;
    bench.runTo(1);

    for (const auto& each : bench.pulses) EXPECT_TRUE(each.empty());
}

TEST(Apm1Servos, have_each_its_own_width_to_half_a_microsecond) {
    Servos bench;
    bench.runTo(2);

    for (int i = 0; i < 8; ++i) {
        const auto pulses = bench.between(i, 1, 2);
        ASSERT_GE(pulses.size(), 4u) << "output " << i + 1;
        for (const Pulse& each : pulses) {
            EXPECT_NEAR(each.us(), 1000 + 100.5 * i, 0.3) << "output " << i + 1;
        }
        for (size_t k = 1; k < pulses.size(); ++k) {
            EXPECT_NEAR(pulses[k].begin - pulses[k - 1].begin, kPeriod, 8);
        }
    }
    EXPECT_EQ(bench.report(2).word(), 2000 + 201 * 3);
}

TEST(Apm1Servos, a_change_at_any_moment_moves_no_edge_by_more_than_half_a_microsecond) {
    Servos bench;
    bench.runTo(3, 60000);

    for (int i = 0; i < 8; ++i) {
        const auto pulses = bench.between(i, 2, 3);
        ASSERT_GT(pulses.size(), 50u);
        for (size_t k = 0; k < pulses.size(); ++k) {
            EXPECT_GT(pulses[k].us(), 999);
            EXPECT_LT(pulses[k].us(), 2001);
            if (k == 0) continue;
            EXPECT_NEAR(pulses[k].begin - pulses[k - 1].begin, kPeriod, 8) << "output " << i + 1;
        }
    }
}

TEST(Apm1Servos, silenced_end_their_pulse_and_then_none_comes) {
    Servos bench;
    bench.runTo(5, 60000);

    EXPECT_EQ(bench.report(4).word(), 0);
    for (int i = 0; i < 8; ++i) {
        EXPECT_LE(bench.between(i, 4, 5).size(), 1u);
        EXPECT_GT(bench.pulses[i].back().us(), 999);
    }
}

// The clock goes on being one beside its outputs.
TEST(Apm1Servos, leave_the_clock_alone) {
    Servos bench;
    bench.runTo(2);

    // wait_ms(50) to the first report and wait_ms(100) to the second, by the chip's own clock
    EXPECT_NEAR(bench.cyclesBetween(1, 2) / 16000.0, 100, 0.5);
}
