// SPDX-License-Identifier: GPL-3.0-or-later
// What a sensor must show of the air, and how long it is waited for.
#include "firmware/safety/restart_evidence.hpp"

#include "firmware/estimator/estimator.hpp"
#include "firmware_bench.hpp"

namespace {

using namespace firmware::safety;
using firmware::state::mutable_vehicle;

class RestartEvidence : public bench::Bench {
protected:
    void SetUp() override {
        Bench::SetUp();
        fakes::resetClock();
        mutable_vehicle.baro.healthy = mutable_vehicle.airspeed.healthy = false;
        mutable_vehicle.estimate.baro_height_m = 0;
    }
    static void barometer(float above_zero_m) {
        mutable_vehicle.baro.healthy = true;
        mutable_vehicle.estimate.baro_height_m = above_zero_m;
    }
};

TEST_F(RestartEvidence, is_over_after_two_seconds_with_a_sensor_there_from_the_start) {
    barometer(1);
    EXPECT_FALSE(evidenceIsOver());
    fakes::advance_ms(1999);
    EXPECT_FALSE(evidenceIsOver());
    fakes::advance_ms(1);
    EXPECT_TRUE(evidenceIsOver());
}

TEST_F(RestartEvidence, is_over_a_second_after_a_sensor_that_came_late) {
    fakes::advance_ms(5000);
    EXPECT_FALSE(evidenceIsOver());
    barometer(1);
    fakes::advance_ms(999);
    EXPECT_FALSE(evidenceIsOver());
    fakes::advance_ms(1);
    EXPECT_TRUE(evidenceIsOver());
}

TEST_F(RestartEvidence, is_not_waited_for_longer_than_half_a_minute_and_a_second) {
    fakes::advance_ms(29999);
    EXPECT_FALSE(evidenceIsOver());
    fakes::advance_ms(999);
    EXPECT_FALSE(evidenceIsOver());
    fakes::advance_ms(1);
    EXPECT_TRUE(evidenceIsOver());
}

TEST_F(RestartEvidence, a_barometer_counts_once_it_is_healthy_and_has_been_read) {
    mutable_vehicle.estimate.baro_height_m = 60;
    EXPECT_FALSE(measuredInTheAir(0)) << "it is not healthy";
    barometer(0);
    EXPECT_FALSE(measuredInTheAir(-60)) << "it has not been read";
    barometer(60);
    EXPECT_TRUE(measuredInTheAir(0));
}

TEST_F(RestartEvidence, ten_metres_are_out_of_reach_and_thirty_whatever_the_airspeed_says) {
    barometer(10);
    EXPECT_FALSE(measuredInTheAir(0));
    barometer(10.5f);
    EXPECT_TRUE(measuredInTheAir(0));
    mutable_vehicle.airspeed.healthy = true;
    mutable_vehicle.airspeed.speed_mps = firmware::estimator::flyingAirspeed_mps();
    EXPECT_FALSE(measuredInTheAir(0));
    barometer(30);
    EXPECT_FALSE(measuredInTheAir(0));
    barometer(30.5f);
    EXPECT_TRUE(measuredInTheAir(0));
}

// A slope is flown below home, too.
TEST_F(RestartEvidence, counts_as_much_below_home_as_above) {
    barometer(-10);
    EXPECT_FALSE(measuredInTheAir(0));
    barometer(-10.5f);
    EXPECT_TRUE(measuredInTheAir(0));
    mutable_vehicle.airspeed.healthy = true;
    EXPECT_FALSE(measuredInTheAir(0));
    barometer(-30.5f);
    EXPECT_TRUE(measuredInTheAir(0));
}

}  // namespace
