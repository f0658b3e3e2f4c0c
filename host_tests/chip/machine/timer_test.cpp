// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>

#include "machine.hpp"

class TimerTest : public testing::Test {
protected:
    TimerTest() { machine.run_ms(5); }
    Machine machine{"timers"};
};

TEST_F(TimerTest, counts_are_exact_from_the_written_value_on) {
    EXPECT_EQ(machine.report(1).word(), 0xC000);
    const int64_t ticks = machine.cyclesBetween(1, 2) / 8;
    EXPECT_NEAR(machine.report(2).word() - 0xC000, ticks, 1);
}

TEST_F(TimerTest, a_count_wraps_after_top) {
    EXPECT_NEAR(machine.report(3).word(), 39990, 1);
    EXPECT_LT(machine.report(4).word(), 20);
    EXPECT_EQ(machine.report(5).word() & 1, 1);
}

TEST_F(TimerTest, a_stopped_timer_keeps_its_count_and_starts_from_it) {
    EXPECT_EQ(machine.report(6).word(), 0);
    EXPECT_GE(machine.report(7).word(), 1000);
    EXPECT_LE(machine.report(7).word(), 1004);
}

TEST_F(TimerTest, a_reloaded_eight_bit_timer_overflows_in_time) {
    EXPECT_NEAR(machine.cyclesBetween(8, 9), 62 * 256, 20);
    EXPECT_EQ(machine.report(9).word(), 0);
}

class PwmTest : public testing::Test {
protected:
    struct Pulse {
        uint64_t rise, width;
    };
    explicit PwmTest(const char* program = "pwm") : machine(program) {
        machine.chip.onCompareOutput('1', 0, [this](bool high, uint64_t cycle) {
            if (high) {
                pulses.push_back({cycle, 0});
            } else if (!pulses.empty()) {
                pulses.back().width = cycle - pulses.back().rise;
            }
        });
        machine.run_ms(700);
    }
    double width(size_t pulse) const { return static_cast<double>(pulses.at(pulse).width); }
    double period(size_t pulse) const {
        return static_cast<double>(pulses.at(pulse + 1).rise - pulses.at(pulse).rise);
    }
    static constexpr double kJitter = 0;  // cycles: the timer changes the pin itself

    Machine machine;
    std::vector<Pulse> pulses;
};

TEST_F(PwmTest, a_new_width_counts_from_the_next_period_on_without_a_glitch) {
    for (size_t i = 0; i + 1 < 36; i++) {
        const double ticks = i <= 3 ? 2001 : i <= 6 ? 4001 : i <= 20 ? 1801 : 2313;
        EXPECT_NEAR(width(i), ticks * 8, kJitter) << "pulse " << i;
    }
    EXPECT_EQ(machine.report(1).word(), 1800);
}

TEST_F(PwmTest, the_period_is_top_plus_one_and_a_new_top_counts_at_once) {
    for (size_t i = 0; i < 11; i++) EXPECT_NEAR(period(i), 40000 * 8, kJitter) << "pulse " << i;
    for (size_t i = 12; i < 30; i++) EXPECT_NEAR(period(i), 20000 * 8, kJitter) << "pulse " << i;
}

class PwmAndEepromTest : public PwmTest {
protected:
    PwmAndEepromTest() : PwmTest("pwm_eeprom") {}
};

TEST_F(PwmAndEepromTest, a_processor_that_is_halted_makes_no_pulse_longer) {
    ASSERT_GT(pulses.size(), 30U);
    for (size_t i = 0; i < 30; i++) EXPECT_EQ(width(i), 2001 * 8) << "pulse " << i;
}

class OutputLatchTest : public testing::Test {
protected:
    OutputLatchTest() {
        machine.chip.onCompareOutput('3', 0, [this](bool high, uint64_t) { now = high; });
        const auto traced = machine.chip.on_trace;
        machine.chip.on_trace = [this, traced](uint8_t number) {
            traced(number);
            high_at[number] = now;
        };
        machine.run_ms(200);
    }

    Machine machine{"output_latch"};
    bool now = false;
    std::map<int, bool> high_at;
};

TEST_F(OutputLatchTest, a_level_outlives_the_time_in_which_the_port_has_the_pin) {
    EXPECT_TRUE(high_at.at(1));
    EXPECT_FALSE(high_at.at(2)) << "the port's";
    EXPECT_TRUE(high_at.at(3)) << "without a match in between";
}

TEST_F(OutputLatchTest, a_forced_match_counts_outside_PWM_and_with_an_output_mode) {
    EXPECT_TRUE(high_at.at(4));
    EXPECT_TRUE(high_at.at(5));
    EXPECT_FALSE(high_at.at(6));
    EXPECT_TRUE(high_at.at(7));
}

TEST_F(OutputLatchTest, a_reset_clears_it) {
    ASSERT_TRUE(now);
    machine.chip.reset(simulator::Reset::external);
    EXPECT_FALSE(now);
    high_at.clear();
    machine.run_ms(1);
    EXPECT_FALSE(high_at.at(8)) << "with the pin given to it";
}
