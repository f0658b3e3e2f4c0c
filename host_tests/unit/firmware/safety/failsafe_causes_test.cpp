// SPDX-License-Identifier: GPL-3.0-or-later
// From which moment each cause holds, and with which parameters.
#include "firmware/safety/failsafe_causes.hpp"

#include "firmware_bench.hpp"
#include "hal/clock.hpp"

namespace {

using namespace firmware::safety;
using firmware::state::Mode;
using firmware::state::mutable_vehicle;
using firmware::state::parameters;

struct FailsafeCauses : bench::Bench {
    void SetUp() override {
        Bench::SetUp();
        fly(Mode::fbwa);
    }
    static void watch(int tenths) {
        for (int i = 0; i < tenths; ++i) watchCauses();
    }
};

TEST_F(FailsafeCauses, the_radio_is_lost_for_long_after_FS_LONG_TIMEOUT_to_the_tenth) {
    parameters.long_timeout_s = 5;
    mutable_vehicle.radio.lost = true;
    watch(50);
    EXPECT_FALSE(radioLostLong());
    watch(1);
    EXPECT_TRUE(radioLostLong());
    mutable_vehicle.radio.lost = false;
    watch(1);
    EXPECT_FALSE(radioLostLong());
}

TEST_F(FailsafeCauses, a_radio_that_stays_lost_for_hours_stays_lost_for_long) {
    constexpr int kTwoHours = 72000;
    parameters.long_timeout_s = 5;
    mutable_vehicle.radio.lost = true;
    watch(51);
    for (int i = 51; i < kTwoHours; ++i) {
        watchCauses();
        ASSERT_TRUE(radioLostLong()) << i;
    }
}

TEST_F(FailsafeCauses, the_ground_station_is_lost_after_FS_LONG_TIMEOUT_to_the_millisecond) {
    parameters.ground_failsafe = 1;
    parameters.long_timeout_s = 5;
    fakes::advance_ms(1);
    mutable_vehicle.ground_heard_ms = hal::now_ms();
    fakes::advance_ms(4999);
    EXPECT_FALSE(groundLostLong());
    fakes::advance_ms(1);
    EXPECT_TRUE(groundLostLong());
}

struct Pack {
    const char* what;
    int16_t voltage_mv, consumed_mah, low_mah;
    bool low;
};
TEST_F(FailsafeCauses, a_pack_is_low_by_its_voltage_or_by_what_is_left_in_it) {
    parameters.battery_monitor = 4;
    parameters.battery_low_v = 10.5f;
    parameters.battery_capacity_mah = 2200;
    const Pack packs[] = {
        {"full", 12600, 0, 0, false},
        {"at the limit", 10500, 0, 0, false},
        {"below it", 10499, 0, 0, true},
        {"used up, and nobody asks", 12600, 2200, 0, false},
        {"used up beyond its capacity, and nobody asks", 12600, 2300, 0, false},
        {"just enough left", 12600, 1900, 300, false},
        {"less left", 12600, 1901, 300, true},
    };
    for (const Pack& pack : packs) {
        mutable_vehicle.armed = false;
        watch(1);
        mutable_vehicle.armed = true;
        mutable_vehicle.battery.voltage_mv = pack.voltage_mv;
        mutable_vehicle.battery.consumed_mah = pack.consumed_mah;
        parameters.battery_low_mah = pack.low_mah;
        watch(99);
        EXPECT_FALSE(batteryLow()) << pack.what << ", for less than 10 s";
        watch(1);
        EXPECT_EQ(batteryLow(), pack.low) << pack.what;
    }
}

TEST_F(FailsafeCauses, a_headwind_is_too_strong_when_it_blows_the_airplane_back_for_ten_seconds) {
    mutable_vehicle.armed = mutable_vehicle.estimate.flying = true;
    mutable_vehicle.progress.blown_back = true;
    watch(99);
    EXPECT_FALSE(blownBack());
    mutable_vehicle.progress.blown_back = false;
    watch(1);
    mutable_vehicle.progress.blown_back = true;
    watch(99);
    EXPECT_FALSE(blownBack()) << "a gust ended";
    watch(1);
    EXPECT_TRUE(blownBack());
    mutable_vehicle.estimate.flying = false;
    watch(1);
    EXPECT_FALSE(blownBack()) << "on the ground it only stands in the wind";
}

TEST_F(FailsafeCauses, a_sensor_that_is_not_used_is_not_missed) {
    mutable_vehicle.airspeed.healthy = mutable_vehicle.compass.healthy = false;
    struct Use {
        int8_t enable, use;
        bool lost;
    };
    for (const Use& each :
         {Use{1, 1, true}, Use{0, 1, false}, Use{1, 0, false}, Use{0, 0, false}}) {
        parameters.airspeed_enable = each.enable;
        parameters.airspeed_use = each.use;
        EXPECT_EQ(airspeedLost(), each.lost) << int(each.enable) << int(each.use);
    }
    parameters.compass_use = 1;
    EXPECT_TRUE(compassLost());
    parameters.compass_use = 0;
    EXPECT_FALSE(compassLost());
}

}  // namespace
