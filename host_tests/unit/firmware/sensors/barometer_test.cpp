// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "fakes/fakes.hpp"
#include "firmware/sensors/devices.hpp"
#include "firmware/sensors/sensors.hpp"
#include "firmware/state/vehicle.hpp"
#include "host_tests/support/fakes/vehicle.hpp"
#include "simulator/devices/ms5611.hpp"

namespace {

using firmware::state::vehicle;

constexpr double kGround_pa = 95000;

struct Barometer : testing::Test {
    simulator::Ms5611 chip{1, simulator::SensorErrors::none()};
    std::mt19937 random{1};
    double noise = 0;  // share of the bytes read that have a wrong bit

    void SetUp() override {
        fakes::reset();
        fakes::Bus::device = [this](int pin, uint8_t out) { return answer(pin, out); };
        chip.sense(kGround_pa, 20);
        firmware::sensors::startBarometer();
        firmware::sensors::zeroBarometer();
    }
    uint8_t answer(int pin, uint8_t out) {
        if (pin != 1) return 0;
        if (fakes::Bus::transactions.back().sent.size() == 1) {
            chip.select(false, now_us());
            chip.select(true, now_us());
        }
        const uint8_t in = chip.transfer(out, now_us());
        const bool wrong = std::uniform_real_distribution<>()(random) < noise;
        return wrong ? static_cast<uint8_t>(in ^ 1 << random() % 8) : in;
    }
    static uint64_t now_us() { return fakes::time_us(); }
    void run(double seconds, double swing_pa = 0) {
        for (int frame = 0; frame < seconds * 100; ++frame) {
            fakes::Bus::transactions.clear();
            chip.sense(kGround_pa + swing_pa * std::sin(frame * 0.03), 20);
            fakes::advance_ms(10);
            chip.select(false, now_us());
            firmware::sensors::runBarometer();
        }
    }
};

TEST_F(Barometer, takes_its_zero_where_it_stands) {
    run(3);
    EXPECT_TRUE(vehicle.baro.healthy);
    EXPECT_NEAR(vehicle.baro.ground_pressure_pa, kGround_pa, 5);
    EXPECT_NEAR(vehicle.baro.ground_temperature_c, 10, 0.1) << "of the air, 10 C under the board's";
}

TEST_F(Barometer, takes_its_zero_in_a_gusty_wind) {
    run(3, 30);
    EXPECT_TRUE(vehicle.baro.healthy);
    EXPECT_NEAR(vehicle.baro.ground_pressure_pa, kGround_pa, 30);
}

// It would last for the whole flight.
TEST_F(Barometer, takes_no_zero_from_a_noisy_bus) {
    for (uint32_t seed = 0; seed < 50; ++seed) {
        random.seed(seed);
        firmware::sensors::zeroBarometer();
        noise = 0.1;
        run(10);
        noise = 0;
        run(5);
        ASSERT_TRUE(vehicle.baro.healthy) << seed;
        ASSERT_NEAR(vehicle.baro.ground_pressure_pa, kGround_pa, 10) << seed;
    }
}

}  // namespace
