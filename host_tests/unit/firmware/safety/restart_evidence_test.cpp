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
    EXPECT_FALSE(sensorsHadTheirTime());
    fakes::advance_ms(1999);
    EXPECT_FALSE(sensorsHadTheirTime());
    fakes::advance_ms(1);
    EXPECT_TRUE(sensorsHadTheirTime());
}

TEST_F(RestartEvidence, is_over_a_second_after_a_sensor_that_came_late) {
    fakes::advance_ms(5000);
    EXPECT_FALSE(sensorsHadTheirTime());
    barometer(1);
    fakes::advance_ms(999);
    EXPECT_FALSE(sensorsHadTheirTime());
    fakes::advance_ms(1);
    EXPECT_TRUE(sensorsHadTheirTime());
}

TEST_F(RestartEvidence, is_not_waited_for_longer_than_half_a_minute_and_a_second) {
    fakes::advance_ms(29999);
    EXPECT_FALSE(sensorsHadTheirTime());
    fakes::advance_ms(999);
    EXPECT_FALSE(sensorsHadTheirTime());
    fakes::advance_ms(1);
    EXPECT_TRUE(sensorsHadTheirTime());
}

TEST_F(RestartEvidence, of_blindness_is_no_longer_noted_half_a_minute_after_the_start) {
    fakes::advance_ms(30000);
    EXPECT_TRUE(sensorsHadTheirTime());
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

// A slope is flown below the field, too.
TEST_F(RestartEvidence, counts_as_much_below_the_field_as_above) {
    barometer(-10);
    EXPECT_FALSE(measuredInTheAir(0));
    barometer(-10.5f);
    EXPECT_TRUE(measuredInTheAir(0));
    mutable_vehicle.airspeed.healthy = true;
    EXPECT_FALSE(measuredInTheAir(0));
    barometer(-30.5f);
    EXPECT_TRUE(measuredInTheAir(0));
}

TEST_F(RestartEvidence, of_the_receiver_is_its_sixth_fix_as_fast_as_one_flies) {
    const float flying_mps = firmware::estimator::flyingAirspeed_mps();
    struct Row {
        uint8_t fixes;
        float speed_mps;
        bool healthy, refused, reckoned, seen;
    };
    for (const Row& row : {Row{6, flying_mps + 0.1f, true, false, false, true},
                           {5, flying_mps + 0.1f, true, false, false, false},
                           {6, flying_mps, true, false, false, false},
                           {6, flying_mps - 0.1f, true, false, false, false},
                           {6, flying_mps + 0.1f, false, false, false, false},
                           {6, flying_mps + 0.1f, true, true, false, false},
                           {6, flying_mps + 0.1f, true, false, true, false}}) {
        mutable_vehicle.gps.fixes = row.fixes;
        mutable_vehicle.gps.ground_speed_mps = row.speed_mps;
        mutable_vehicle.gps.healthy = row.healthy;
        mutable_vehicle.estimate.fix_refused = row.refused;
        mutable_vehicle.estimate.reckoned = row.reckoned;
        EXPECT_EQ(receiverSeesItMove(), row.seen) << int(row.fixes) << " " << row.speed_mps;
    }
}

TEST_F(RestartEvidence, of_the_receiver_is_waited_for_six_fixes_or_half_a_minute) {
    mutable_vehicle.gps.fixes = 5;
    fakes::advance_ms(29999);
    EXPECT_FALSE(receiverHadItsTime());
    fakes::advance_ms(1);
    EXPECT_TRUE(receiverHadItsTime());
    fakes::resetClock();
    mutable_vehicle.gps.fixes = 6;
    EXPECT_TRUE(receiverHadItsTime());
}

}  // namespace
