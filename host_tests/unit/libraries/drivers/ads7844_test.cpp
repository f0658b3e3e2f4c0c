// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivers/ads7844.hpp"

#include <gtest/gtest.h>

#include <deque>
#include <functional>
#include <vector>

#include "drivers/analog_imu.hpp"
#include "simulator/devices/ads7844.hpp"
#include "simulator/devices/analog_imu.hpp"
#include "simulator/world.hpp"

namespace {

using drivers::Ads7844Sums;

// Two bytes at a time, the interrupt at their end when the test says so.
struct Bus {
    static inline std::function<uint8_t(uint8_t)> device;
    static inline std::deque<uint8_t> received_bytes;
    static inline std::vector<uint8_t> sent;
    static inline bool under_way = false, chosen = false, awake = false, sent_out = false;

    static void wake() {
        awake = true;
        sent_out = false;
    }
    static void rest() { awake = false; }
    static void begin(uint8_t first, uint8_t second) {
        ASSERT_TRUE(chosen);
        for (const uint8_t byte : {first, second}) {
            sent.push_back(byte);
            received_bytes.push_back(device(byte));
        }
        ASSERT_LE(received_bytes.size(), 3u) << "the receiver holds no more";
        under_way = true;
    }
    static bool ended() { return sent_out; }
    static uint8_t received() {
        EXPECT_FALSE(received_bytes.empty());
        const uint8_t byte = received_bytes.front();
        received_bytes.pop_front();
        return byte;
    }
    static void flush() {
        received_bytes.clear();
        under_way = false;
    }
};

// Each test has a converter of its own, as the driver's state is the type's.
template <int number>
struct Select {
    static void output() {}
    static void low() { choose(true); }
    static void high() { choose(false); }
    static void choose(bool chosen) {
        Bus::chosen = chosen;
        if (on_choice) on_choice(chosen);
    }
    static inline std::function<void(bool)> on_choice;
};

template <int number>
struct Rig {
    using Converter = drivers::Ads7844<Bus, Select<number>>;
    Ads7844Sums sums{};

    explicit Rig(std::function<uint8_t(uint8_t)> device) {
        Bus::device = std::move(device);
        Bus::flush();
        Bus::sent.clear();
        Bus::awake = Bus::sent_out = false;
        Select<number>::on_choice = [](bool) {};
        Converter::start();
    }
    // The end of a pair: an interrupt, or a flag that nobody looks at yet.
    static bool exchange() {
        if (!Bus::under_way) return false;
        Bus::under_way = false;
        Bus::sent_out = !Bus::awake;
        if (!Bus::awake) return false;
        Converter::onSent();
        return true;
    }
    static void rest() {
        while (exchange()) {
        }
    }
    static void begin() { Converter::beginSet(); }
    static void set() {
        begin();
        rest();
    }
    // The answers of a set are complete when the next has begun; the first one's do not count.
    static void start() {
        set();
        set();
    }
    static uint8_t waiting() { return Converter::waiting(); }
    bool take() { return Converter::take(sums); }
};

// Answers each question, wherever in the bytes it begins, with the word of its channel: a busy bit,
// twelve of the value, zeros.
struct Script {
    std::function<uint16_t(int address)> word = [](int) { return uint16_t{0}; };
    int clocks = 16, left = 0;
    uint8_t control = 0;
    uint16_t answer = 0;
    uint8_t operator()(uint8_t out) {
        uint8_t in = 0;
        for (int bit = 7; bit >= 0; --bit) {
            in = static_cast<uint8_t>(in << 1 | (left > 0 ? answer >> --left & 1 : 0));
            const bool one = out >> bit & 1;
            if (clocks >= 15 && one) clocks = control = 0;
            if (clocks < 8) control = static_cast<uint8_t>(control << 1 | one);
            if (++clocks != 8) continue;
            EXPECT_EQ(control & 0x87, 0x87) << "single-ended, always powered";
            answer = word(control >> 4 & 7);
            left = 16;
        }
        return in;
    }
};
constexpr int kYaw = 0, kPitch = 1, kAx = 2, kAz = 3, kRoll = 4, kAy = 6, kPitot = 7;  // table I
constexpr uint16_t value(int reading) { return static_cast<uint16_t>(reading << 3); }

std::vector<int> questions(const std::function<void()>& act) {
    std::vector<int> asked;
    Script script;
    script.word = [&](int address) {
        asked.push_back(address);
        return uint16_t{0};
    };
    Bus::device = script;
    act();
    return asked;
}

TEST(Ads7844, asks_for_the_inertial_channels_in_each_set_and_for_the_airspeed_in_every_fourth) {
    Rig<1> rig{Script{}};
    const std::vector<int> inertial = {kYaw, kPitch, kAx, kAz, kRoll, kAy};
    std::vector<int> with_airspeed = inertial;
    with_airspeed.insert(with_airspeed.begin(), kPitot);

    EXPECT_EQ(questions([&] { rig.set(); }), inertial);
    EXPECT_EQ(questions([&] { rig.set(); }), with_airspeed);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(questions([&] { rig.set(); }), inertial) << i;
    EXPECT_EQ(questions([&] { rig.set(); }), with_airspeed);
}

TEST(Ads7844, sums_up_what_each_channel_answered) {
    Script script;
    script.word = [](int address) { return value(100 + 300 * address); };
    Rig<2> rig{script};
    rig.start();
    rig.take();
    for (int i = 0; i < 10; ++i) rig.set();

    EXPECT_EQ(rig.waiting(), 10);
    ASSERT_TRUE(rig.take());
    const int address[] = {kAy, kYaw, kPitch, kAx, kAz, kRoll, kPitot};
    for (int i = 0; i < 7; ++i) {
        EXPECT_EQ(rig.sums.sum[i], rig.sums.count[i] * (100 + 300 * address[i])) << i;
        EXPECT_EQ(rig.sums.count[i], i == Ads7844Sums::airspeed ? 3 : i < 5 ? 11 : 10) << i;
    }
    EXPECT_EQ(rig.sums.periods, 10);
    EXPECT_FALSE(rig.sums.invalid);
    EXPECT_EQ(rig.waiting(), 0);
    EXPECT_FALSE(rig.take());
}

TEST(Ads7844, no_reading_is_lost_or_counted_twice_wherever_the_sums_are_taken) {
    Script script;
    script.word = [](int) { return value(100); };
    Rig<3> rig{script};
    rig.start();
    int readings[7] = {}, sets = 0;
    for (int n = 0; n < 60; ++n) {
        rig.set();
        rig.begin();
        sets += 2;
        for (int i = 0; i < n % 9; ++i) rig.exchange();
        if (rig.take()) {
            for (int i = 0; i < 7; ++i) {
                EXPECT_EQ(rig.sums.sum[i], 100 * rig.sums.count[i]) << n << " " << i;
                readings[i] += rig.sums.count[i];
            }
        }
        rig.rest();
    }
    rig.begin();
    rig.rest();
    ASSERT_TRUE(rig.take());

    for (int i = 0; i < 5; ++i) EXPECT_EQ(readings[i] + rig.sums.count[i], sets + 2) << i;
    EXPECT_EQ(readings[5] + rig.sums.count[5], sets + 1);
}

TEST(Ads7844, full_scale_that_nobody_takes_does_not_overflow) {
    Script script;
    script.word = [](int) { return value(4095); };
    Rig<4> rig{script};
    for (int i = 0; i < 300; ++i) rig.set();

    ASSERT_TRUE(rig.take());
    for (int i = 0; i < 7; ++i) EXPECT_EQ(rig.sums.sum[i], 4095 * rig.sums.count[i]) << i;
    EXPECT_GE(rig.sums.count[0], 10);
    EXPECT_EQ(rig.sums.periods, 255);
    EXPECT_FALSE(Bus::chosen);
}

TEST(Ads7844, begins_anew_when_they_are_taken_again) {
    Script script;
    script.word = [](int) { return value(77); };
    Rig<7> rig{script};
    for (int i = 0; i < 30; ++i) rig.set();
    rig.take();
    for (int i = 0; i < 10; ++i) rig.set();

    EXPECT_EQ(rig.waiting(), 10);
    ASSERT_TRUE(rig.take());
    EXPECT_FALSE(rig.sums.invalid);
    for (int i = 0; i < 7; ++i) EXPECT_EQ(rig.sums.sum[i], 77 * rig.sums.count[i]) << i;
    EXPECT_GE(rig.sums.count[Ads7844Sums::rate_x], 7);
}

TEST(Ads7844, an_answer_with_a_bit_where_none_can_be_damages_the_sums_once) {
    Rig<5> rig{Script{}};
    rig.start();
    for (const uint16_t bad : {0x8000, 0x0001, 0xFFFF}) {
        Script script;
        script.word = [&](int address) { return address == kAx ? bad : uint16_t{0x4000}; };
        Bus::device = script;
        for (int i = 0; i < 3; ++i) rig.set();
        ASSERT_TRUE(rig.take());
        EXPECT_TRUE(rig.sums.invalid) << bad;

        Bus::device = Script{};
        for (int i = 0; i < 5; ++i) rig.set();
        ASSERT_TRUE(rig.take());
        EXPECT_FALSE(rig.sums.invalid);
        EXPECT_EQ(rig.sums.periods, 5);
    }
}

TEST(Ads7844, a_set_that_never_ends_is_given_up_and_the_next_one_works) {
    Script script;
    script.word = [](int) { return value(50); };
    Rig<6> rig{script};
    rig.begin();  // and its interrupt never comes
    rig.begin();
    EXPECT_FALSE(Bus::chosen);
    EXPECT_FALSE(rig.take());
    EXPECT_TRUE(rig.sums.invalid);
    EXPECT_EQ(rig.sums.periods, 2);

    for (int i = 0; i < 4; ++i) rig.set();
    ASSERT_TRUE(rig.take());
    EXPECT_FALSE(rig.sums.invalid);
    for (int i = 0; i < 7; ++i) EXPECT_EQ(rig.sums.sum[i], 50 * rig.sums.count[i]) << i;
}

// ---- the sensors behind it, by the simulator's models

template <int number>
struct Sensors {
    using Converter = typename Rig<number>::Converter;
    simulator::Truth truth{};
    simulator::Ads7844 chip;
    simulator::AnalogImu shield{1, simulator::SensorErrors::none()};
    double pitot_v = 2.5;
    uint32_t now_ms = 0;
    Rig<number> rig{[this](uint8_t byte) { return chip.transfer(byte, uint64_t{now_ms} * 1000); }};
    drivers::AnalogImu<Converter> imu;
    drivers::ImuSums sums{};

    Sensors() {
        truth.force_z_mss = -9.80665;
        chip.volts = [this](int input) {
            return input == 7 ? pitot_v : shield.volts(input, truth);
        };
        Select<number>::on_choice = [this](bool chosen) { chip.select(chosen); };
        imu.start();
    }
    bool frame(int sets = 10) {
        for (int i = 0; i < sets; ++i) rig.set();
        now_ms += static_cast<uint32_t>(sets);
        imu.step(now_ms);
        return imu.take(sums);
    }
    double rate_dps(int axis) const {
        return sums.rate[axis] * static_cast<double>(drivers::kRateStep_rads) * 180 / M_PI / 2;
    }
    double force_mss(int axis) const {
        return sums.force[axis] * static_cast<double>(drivers::kForceStep_mss) / 2;
    }
};

TEST(AnalogImu, gives_rates_and_forces_in_the_airplanes_axes) {
    Sensors<11> s;
    s.truth.roll_rate_rads = 100 * M_PI / 180;
    s.truth.pitch_rate_rads = -50 * M_PI / 180;
    s.truth.yaw_rate_rads = 25 * M_PI / 180;
    s.truth.force_x_mss = 2;
    s.truth.force_y_mss = -3;
    ASSERT_TRUE(s.frame());

    EXPECT_NEAR(s.rate_dps(0), 100, 0.5);
    EXPECT_NEAR(s.rate_dps(1), -50, 0.5);
    EXPECT_NEAR(s.rate_dps(2), 25, 0.5);
    EXPECT_NEAR(s.force_mss(0), 2, 0.03);
    EXPECT_NEAR(s.force_mss(1), -3, 0.03);
    EXPECT_NEAR(s.force_mss(2), -9.80665, 0.03);
}

TEST(AnalogImu, says_a_frame_is_due_after_ten_sets_and_covers_all_of_them) {
    Sensors<12> s;
    for (int i = 0; i < 9; ++i) s.rig.set();
    EXPECT_EQ(s.imu.waiting(), 1);
    s.rig.set();
    EXPECT_EQ(s.imu.waiting(), 2);

    int periods = 0;
    for (int i = 0; i < 100; ++i) {
        ASSERT_TRUE(s.frame(i == 0 ? 0 : 11));
        EXPECT_EQ(s.sums.count, 2);
        periods += s.sums.periods;
    }
    EXPECT_EQ(periods, (10 + 99 * 11) / 5);
}

TEST(AnalogImu, leaves_a_damaged_reading_out_and_its_time_in) {
    Sensors<13> s;
    ASSERT_TRUE(s.frame());
    s.chip.unplug(true);
    EXPECT_FALSE(s.frame());
    EXPECT_EQ(s.imu.badReads(), 1);
    s.chip.unplug(false);

    ASSERT_TRUE(s.frame());
    EXPECT_EQ(s.sums.periods, 4);
    EXPECT_NEAR(s.force_mss(2), -9.80665, 0.03);
}

TEST(AnalogImu, what_it_refuses_makes_no_frame_due_before_its_time) {
    Sensors<17> s;
    s.chip.unplug(true);
    for (int i = 0; i < 5; ++i) {
        EXPECT_FALSE(s.frame());
        EXPECT_EQ(s.imu.waiting(), 0);
    }
}

TEST(AnalogImu, without_its_converter_turns_unhealthy_and_comes_back) {
    Sensors<14> s;
    for (int i = 0; i < 3; ++i) s.frame();
    EXPECT_TRUE(s.imu.healthy());
    s.chip.unplug(true);
    for (int i = 0; i < 10; ++i) s.frame();
    EXPECT_FALSE(s.imu.healthy());

    s.chip.unplug(false);
    for (int i = 0; i < 3; ++i) s.frame();
    EXPECT_TRUE(s.imu.healthy());
}

TEST(AnalogImu, a_wire_that_hangs_on_the_ground_or_the_supply_is_no_sensor) {
    for (const double stuck_v : {0.0, 3.3}) {
        Sensors<15> s;
        s.chip.volts = [&](int input) {
            return input == 5 ? stuck_v : s.shield.volts(input, s.truth);
        };
        for (int i = 0; i < 10; ++i) EXPECT_FALSE(s.frame());
        EXPECT_FALSE(s.imu.healthy());
        s.imu.takeAirspeed();
    }
}

TEST(AnalogImu, hands_on_the_pitot_sensors_share_as_readings_of_ten_bits) {
    Sensors<16> s;
    s.pitot_v = 2.6;
    s.frame();
    s.frame();

    const hal::AnalogSum sum = s.imu.takeAirspeed();
    EXPECT_EQ(sum.count, 5);
    EXPECT_NEAR(static_cast<double>(sum.sum) / sum.count, 2.6 / 5 * 1024, 0.3);
    EXPECT_EQ(s.imu.takeAirspeed().count, 0);
}

}  // namespace
