// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/actuators/lights.hpp"

#include <functional>
#include <string>

#include "board.hpp"
#include "firmware/safety/arming.hpp"
#include "firmware_bench.hpp"
#include "host_tests/support/fakes/vehicle.hpp"

namespace {

using firmware::state::GpsFix;
using firmware::state::mutable_vehicle;
using firmware::state::parameters;

struct Lights : bench::Bench {
    void SetUp() override {
        Bench::SetUp();
        mutable_vehicle.imu.healthy = mutable_vehicle.imu.calibrated = true;
        parameters.arming_check = 0;
        look();
        for (int i = 0; i < 15; ++i) firmware::actuators::runLights();  // to where a flash begins
    }
    static void look() {
        for (int tenth = 0; tenth < 10; ++tenth) firmware::safety::runArming();
    }
    // Of 1.6 s, a letter a tenth of a second.
    template <class Led>
    static std::string shown() {
        std::string seen;
        for (int i = 0; i < 16; ++i) {
            firmware::actuators::runLights();
            seen += Led::lit ? '#' : '.';
        }
        return seen;
    }
};
constexpr char kOff[] = "................", kOn[] = "################",
               kFast[] = "#.#.#.#.#.#.#.#.", kBetween[] = ".#.#.#.#.#.#.#.#",
               kSlow[] = "##..##..##..##..", kOneFlash[] = "##..............",
               kTwoFlashes[] = "##..##..........";

TEST_F(Lights, the_red_light_flashes_once_when_ready_twice_when_not_and_is_on_when_armed) {
    EXPECT_EQ(shown<board::LedA>(), kOneFlash);
    parameters.arming_check = 1;
    mutable_vehicle.baro.healthy = false;
    look();
    EXPECT_EQ(shown<board::LedA>(), kTwoFlashes);
    mutable_vehicle.armed = true;
    EXPECT_EQ(shown<board::LedA>(), kOn);
}

TEST_F(Lights, the_blue_light_shows_the_gps_state) {
    mutable_vehicle.gps.fix = GpsFix::no_gps;
    EXPECT_EQ(shown<board::LedC>(), kOff);
    mutable_vehicle.gps.fix = GpsFix::none;
    EXPECT_EQ(shown<board::LedC>(), kFast);
    mutable_vehicle.gps.fix = GpsFix::two_d;
    EXPECT_EQ(shown<board::LedC>(), kSlow);
    mutable_vehicle.gps.fix = GpsFix::three_d;
    EXPECT_EQ(shown<board::LedC>(), kOn);
}

TEST_F(Lights, red_and_blue_alternate_while_the_gyros_are_calibrated) {
    mutable_vehicle.imu.calibrated = false;
    EXPECT_EQ(shown<board::LedA>(), kFast);
    EXPECT_EQ(shown<board::LedC>(), kBetween);
    EXPECT_EQ(shown<board::LedB>(), kOff);
}

TEST_F(Lights, all_flash_together_when_the_inertial_sensor_fails) {
    mutable_vehicle.imu.healthy = false;
    EXPECT_EQ(shown<board::LedA>(), kFast);
    EXPECT_EQ(shown<board::LedB>(), kFast);
    EXPECT_EQ(shown<board::LedC>(), kFast);
}

TEST_F(Lights, the_yellow_light_flashes_twice_without_a_receiver) {
    EXPECT_EQ(shown<board::LedB>(), kOff);
    mutable_vehicle.radio.lost = true;
    EXPECT_EQ(shown<board::LedB>(), kTwoFlashes);
}

}  // namespace
