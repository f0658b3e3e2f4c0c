// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/estimator/estimator.hpp"

#include <cmath>

#include "core/internal_error.hpp"
#include "estimation/atmosphere.hpp"
#include "firmware/mission/home.hpp"
#include "firmware/sensors/compass_learning.hpp"
#include "firmware/sensors/health.hpp"
#include "firmware_bench.hpp"
#include "hal/clock.hpp"
#include "host_tests/support/fakes/vehicle.hpp"

namespace {

using firmware::state::mutable_vehicle;

using firmware::sensors::isFaulty;
using firmware::sensors::Sensor;
using firmware::state::vehicle;

constexpr geo::Position kStart = {470000000, 80000000};
constexpr float kGpsAge_s = 0.243f;  // when its bytes have arrived

// Along a meridian, wings level, nose to the north: every sensor at its own rate.
class Estimator : public bench::Bench {
protected:
    void SetUp() override {
        Bench::SetUp();
        mutable_vehicle.imu.healthy = mutable_vehicle.imu.calibrated = mutable_vehicle.gps.healthy =
            true;
        mutable_vehicle.baro.healthy = mutable_vehicle.compass.healthy = true;
        mutable_vehicle.baro.ground_pressure_pa = 101325;
        mutable_vehicle.baro.pressure_pa = 101325;
        mutable_vehicle.baro.ground_temperature_c = 15;
        firmware::state::parameters.compass_use = 1;
        firmware::state::parameters.compass_declination_rad = 0;
    }
    void frames(int count, float acceleration_mss = 0) {
        for (int i = 0; i < count; ++i) frame(acceleration_mss);
    }
    void frame(float acceleration_mss) {
        speed_mps_ += acceleration_mss * 0.01f;
        travelled_m_ += speed_mps_ * 0.01f;
        altitude_m_ += climb_mps_ * 0.01f;
        mutable_vehicle.imu.periods = 2;
        mutable_vehicle.imu.accel_mss =
            core::Accelerations::from(acceleration_mss + imu_lies_mss_, 0, -core::kGravity_mss);
        ++frame_;
        if (frame_ % 2 == 0) {
            const float* const offset_mg = firmware::state::parameters.compass.offset_mg;
            mutable_vehicle.compass.field_mg =
                compass_mg_ + core::Vector3{offset_mg[0], offset_mg[1], offset_mg[2]};
            mutable_vehicle.compass.accepted = true;
            ++mutable_vehicle.compass.readings;
        }
        if (vehicle.baro.ground_pressure_pa > 0) ++mutable_vehicle.baro.readings;
        if (frame_ % 20 == late_) fix(acceleration_mss);
        fakes::advance_ms(10);
        estimate();
    }
    // As the rows of the schedule do.
    void estimate() {
        using namespace firmware::estimator;
        const auto due = [this](int period, int phase) { return frame_ % period == phase; };
        runAttitude();
        gatherPressure();
        if (due(10, 2)) alignAttitude();
        if (due(2, 0)) rotateDcm();
        if (due(10, 3)) orthonormalizeMatrix();
        if (due(10, 6)) pointYaw();
        if (due(4, 1)) propagateMotion();
        if (due(5, 3)) fusePressure();
        if (due(5, 1)) publishSpeeds();
        if (due(10, 3)) reckonPosition();
        if (due(10, 8)) checkEstimate();
        if (due(10, 9)) updateFlying();
        if (due(5, 0)) fuseFixAttitude();
        if (due(5, 1)) fuseFixPosition();
        if (due(5, 1)) fuseFixWind();
        if (due(5, 0)) fuseFixHeight();
        if (due(20, 8)) fuseCompass();
        if (due(20, 16)) fuseAirspeed();
    }
    // The barometer's readings come and change, and it is healthy as far as the watch says so.
    void watched(int count) {
        using namespace firmware::sensors;
        for (int i = 0; i < count; ++i) {
            frame(0);
            acceptReading(Sensor::barometer, static_cast<int16_t>(frame_ % 7), true);
            if (frame_ % 10 == 0) watchHealth();
            mutable_vehicle.baro.healthy = !isFaulty(Sensor::barometer);
        }
    }
    void fix(float acceleration_mss) {
        auto& gps = mutable_vehicle.gps;
        const float then_mps = speed_mps_ - acceleration_mss * kGpsAge_s;
        const float then_m = travelled_m_ - (speed_mps_ + then_mps) / 2 * kGpsAge_s;
        gps.fix = firmware::state::GpsFix::three_d;
        if (stuck_) {
            ++gps.fixes;
            return;
        }
        gps.position = geo::moved(kStart, {then_m, 0});
        gps.position.latitude_e7 -= gps.position.latitude_e7 % latitude_step_;
        gps.measures_climb = measures_climb_;
        const float climb_mps = measures_climb_ ? climb_mps_ : vehicle.estimate.climb_mps;
        gps.velocity_mps = {then_mps, 0, -climb_mps};
        gps.ground_speed_mps = std::fabs(then_mps);
        gps.altitude_cm = core::rounded((altitude_m_ - climb_mps_ * kGpsAge_s) * 100);
        gps.received_ms = hal::now_ms();
        gps.age_ms = static_cast<uint16_t>(kGpsAge_s * 1000);
        ++gps.fixes;
    }

    float speed_mps_ = 0, travelled_m_ = 0;
    float imu_lies_mss_ = 0;
    float climb_mps_ = 0, altitude_m_ = 0;  // above the sea
    int frame_ = 0, late_ = 7;
    int32_t latitude_step_ = 1;
    bool stuck_ = false;          // the receiver
    bool measures_climb_ = true;  // its receiver
    core::Vector3 compass_mg_ = {210, 0, 430};
};

TEST_F(Estimator, does_not_lead_nor_lag_while_the_airplane_gains_speed) {
    frames(300);
    for (int i = 0; i < 600; ++i) {
        frame(2);
        if (i < 200 || frame_ % 4 != 1) continue;
        ASSERT_NEAR(vehicle.estimate.velocity_mps.x, speed_mps_, 0.25) << "after " << i;
        const geo::Offset off = geo::offset(kStart, vehicle.estimate.position);
        ASSERT_NEAR(off.north_m, travelled_m_, 0.6) << "after " << i;
    }
    EXPECT_NEAR(vehicle.attitude.pitch_rad.toFloat(), 0, 0.02);
    EXPECT_NEAR(vehicle.attitude.yaw_rad.toFloat(), 0, 0.02);
}

TEST_F(Estimator, uses_every_fix_and_reading_whatever_frame_they_come_in) {
    for (late_ = 0; late_ < 8; ++late_) {
        frames(150);
        EXPECT_FALSE(vehicle.estimate.reckoned) << late_;
        EXPECT_TRUE(vehicle.estimate.known) << late_;
    }
    mutable_vehicle.baro.pressure_pa -= 60;  // five metres
    frames(800);
    EXPECT_NEAR(vehicle.estimate.height_m, 5, 0.2);
}

// The altitude above the sea goes on, only where it is counted from moves.
TEST_F(Estimator, makes_no_step_when_home_is_moved) {
    firmware::mission::setHome(kStart, 50000);
    mutable_vehicle.baro.pressure_pa -= 600;
    frames(1500);
    const float before_m = vehicle.estimate.height_m;
    const float climb_mps = vehicle.estimate.climb_mps;
    ASSERT_GT(before_m, 40);

    firmware::mission::setHome(geo::moved(kStart, {100, 50}), 53000);

    EXPECT_NEAR(vehicle.estimate.height_m, before_m - 30, 0.01) << "for what runs in this frame";
    for (int i = 0; i < 100; ++i) {
        frame(0);
        ASSERT_NEAR(vehicle.estimate.height_m, before_m - 30, 0.1) << i;
        ASSERT_NEAR(vehicle.estimate.climb_mps, climb_mps, 0.1) << i;
    }
}

TEST_F(Estimator, takes_the_receivers_height_without_a_step_when_the_barometer_is_lost) {
    altitude_m_ = 500;
    frames(1500);
    const float before_m = vehicle.estimate.height_m;
    mutable_vehicle.baro.healthy = false;
    for (int i = 0; i < 500; ++i) {
        frame(0);
        ASSERT_NEAR(vehicle.estimate.height_m, before_m, 0.5) << i;
    }
    altitude_m_ += 10;
    frames(1500);
    EXPECT_NEAR(vehicle.estimate.height_m, before_m + 10, 0.5);
}

// As NMEA and MTK receivers are: their climb is ours, and says nothing about the barometer.
TEST_F(Estimator, learns_nothing_about_heights_from_a_receiver_without_climb) {
    measures_climb_ = false;
    frames(500);
    for (int i = 0; i < 3000; ++i) {
        mutable_vehicle.baro.pressure_pa = 101325 - i * 12 / 30;
        frame(0);
    }
    frames(500);
    const float shown_m =
        estimation::pressureHeight_m(static_cast<float>(vehicle.baro.pressure_pa), 101325, 15);
    EXPECT_NEAR(vehicle.estimate.height_m, shown_m, 0.05);
}

// Falling by a metre a second, as it says, for half a minute.
struct DriftingBarometer : Estimator {
    bool rejected(uint16_t hdop_c) {
        mutable_vehicle.armed = true;
        mutable_vehicle.gps.hdop_c = hdop_c;
        altitude_m_ = 500;
        frames(300, 3);
        EXPECT_TRUE(vehicle.estimate.flying);
        for (int i = 0; i < 3000 && vehicle.baro.healthy; ++i) {
            mutable_vehicle.baro.pressure_pa = 101325 + i * 12 / 100;
            watched(1);
        }
        return !vehicle.baro.healthy;
    }
};

TEST_F(DriftingBarometer, is_rejected_by_the_gps_height) {
    EXPECT_TRUE(rejected(120));
    EXPECT_GT(vehicle.estimate.height_m, -28);
}

TEST_F(DriftingBarometer, is_used_while_there_are_too_few_satellites_to_contradict) {
    EXPECT_FALSE(rejected(400));
}

// What a restart leaves; all else is forgotten.
// At 17 m/s in calm air a receiver with little noise gave the same velocity for three seconds, and
// latitudes that ended in the same bits.
TEST_F(Estimator, takes_no_receiver_for_stuck_whose_place_changes) {
    const auto faulty = [] { return firmware::sensors::isFaulty(firmware::sensors::Sensor::gps); };
    mutable_vehicle.armed = true;
    frames(400, 3);
    latitude_step_ = 4;
    for (int i = 0; i < 10; ++i) {
        watched(100);
        ASSERT_FALSE(faulty()) << i;
    }
    stuck_ = true;
    watched(350);
    EXPECT_TRUE(faulty());
}

struct Records {
    firmware::state::SlowRecord slow;
    firmware::state::FastRecord fast;
};
Records recordsOfARestart() {
    Records records = {};
    firmware::estimator::saveEstimate(records.slow);
    firmware::estimator::saveEstimate(records.fast);
    core::resetFileStates();
    return records;
}

// Flies 60 m up, and knows by the receiver what its barometer shows.
struct WrongBarometer : Estimator {
    void SetUp() override {
        Estimator::SetUp();
        mutable_vehicle.armed = true;
        mutable_vehicle.baro.pressure_pa -= 720;
        altitude_m_ = 500;
        frames(400, 3);
        watched(500);
        ASSERT_TRUE(vehicle.estimate.flying && vehicle.baro.healthy);
        before_m = vehicle.estimate.height_m;
    }
    float before_m = 0;
};

TEST_F(WrongBarometer, is_done_without_as_long_as_it_shows_another_height) {
    mutable_vehicle.baro.pressure_pa -= 600;
    for (int i = 0; i < 1500; ++i) {
        watched(1);
        ASSERT_NEAR(vehicle.estimate.height_m, before_m, 3) << i;
    }
    EXPECT_FALSE(vehicle.baro.healthy);
    mutable_vehicle.baro.pressure_pa += 600;
    watched(500);
    EXPECT_TRUE(vehicle.baro.healthy);
    EXPECT_NEAR(vehicle.estimate.height_m, before_m, 3);
}

// It was zeroed with an error that went away: on the ground it is heard again, and still differs.
TEST_F(WrongBarometer, moves_no_height_when_it_is_heard_again_after_the_flight) {
    mutable_vehicle.baro.pressure_pa -= 1200;
    watched(1500);
    ASSERT_FALSE(vehicle.baro.healthy);
    mutable_vehicle.armed = false;
    frames(310);
    ASSERT_FALSE(vehicle.estimate.flying);
    mutable_vehicle.baro.healthy = true;
    frames(500);
    EXPECT_NEAR(vehicle.estimate.height_m, before_m, 3);
    mutable_vehicle.baro.pressure_pa += 120;
    frames(500);
    EXPECT_NEAR(vehicle.estimate.height_m, before_m - 10, 3) << "by the barometer";
}

// It fell to the ground while the processor started: the record has the height from which it fell.
TEST_F(WrongBarometer, is_right_after_a_restart_that_ends_on_the_ground) {
    const auto [slow, fast] = recordsOfARestart();
    Estimator::SetUp();
    mutable_vehicle.armed = mutable_vehicle.baro.healthy = false;
    firmware::estimator::resumeEstimate(slow, fast, {0, 0, 0}, 1.2f);
    frames(310);
    ASSERT_FALSE(vehicle.estimate.flying);
    mutable_vehicle.baro.healthy = true;
    frames(2000);
    EXPECT_NEAR(vehicle.estimate.height_m, 0, 3);
    firmware::state::SlowRecord then = {};
    firmware::estimator::saveEstimate(then);
    EXPECT_NEAR(then.home_height_m, slow.home_height_m, 3) << "where the field is";
}

// The compass is used before the receiver has a fix.
TEST_F(Estimator, knows_the_declination_of_its_place_after_a_restart) {
    firmware::state::parameters.compass_auto_declination = 1;
    firmware::state::SlowRecord slow = {};
    firmware::state::FastRecord fast = {};
    fast.place_known = true;
    fast.position = {400150000, -1052700000};  // Boulder, 7.6 degrees east in 2027
    firmware::estimator::resumeEstimate(slow, fast, {0, 0, 0}, 0.1f);
    EXPECT_NEAR(core::degrees(firmware::state::parameters.compass_declination_rad), 7.6f, 0.5f);
}

TEST_F(Estimator, counts_heights_from_where_home_is_set_on_the_ground) {
    mutable_vehicle.baro.pressure_pa -= 60;  // the weather since the barometer was zeroed
    altitude_m_ = 432.1f;
    frames(1500);
    ASSERT_TRUE(firmware::mission::setHomeHere());
    EXPECT_EQ(vehicle.home.altitude_cm, 43210);
    EXPECT_EQ(vehicle.estimate.height_m, 0);
    frames(100);
    EXPECT_NEAR(vehicle.estimate.height_m, 0, 0.1);
}

TEST_F(Estimator, flies_after_half_a_second_of_speed_and_only_armed) {
    mutable_vehicle.airspeed.healthy = true;
    mutable_vehicle.airspeed.speed_mps = 12;
    frames(200);
    EXPECT_FALSE(vehicle.estimate.flying) << "wind in the nose of a parked airplane";

    mutable_vehicle.airspeed.speed_mps = 4;
    mutable_vehicle.armed = true;
    frames(200, 2);
    EXPECT_FALSE(vehicle.estimate.flying) << "on the runway";
    mutable_vehicle.airspeed.speed_mps = 12;
    frames(40);
    EXPECT_FALSE(vehicle.estimate.flying) << "a gust";
    frames(20);
    EXPECT_TRUE(vehicle.estimate.flying);
}

// ARSPD_FBW_MIN may be set to anything in its range before arming.
TEST_F(Estimator, flies_at_ten_metres_a_second_whatever_the_least_airspeed_is) {
    firmware::state::parameters.speed_min_mps = 25;
    mutable_vehicle.armed = mutable_vehicle.airspeed.healthy = true;
    mutable_vehicle.airspeed.speed_mps = 10.5f;
    frames(300, 3);
    EXPECT_TRUE(vehicle.estimate.flying);
    mutable_vehicle.airspeed.speed_mps = 9.5f;
    frames(200, -4);
    frames(400);
    EXPECT_FALSE(vehicle.estimate.flying);
}

TEST_F(Estimator, stands_after_three_seconds_without_speed) {
    mutable_vehicle.armed = mutable_vehicle.airspeed.healthy = true;
    mutable_vehicle.airspeed.speed_mps = 12;
    frames(300, 2);
    frames(200, -3);
    ASSERT_TRUE(vehicle.estimate.flying) << "it has hardly come to rest";
    mutable_vehicle.airspeed.speed_mps = 0;
    frames(200);
    EXPECT_TRUE(vehicle.estimate.flying);
    frames(150);
    EXPECT_FALSE(vehicle.estimate.flying);
}

TEST_F(Estimator, goes_on_flying_with_a_blocked_tube_while_the_ground_moves) {
    mutable_vehicle.armed = mutable_vehicle.airspeed.healthy = true;
    mutable_vehicle.airspeed.speed_mps = 12;
    frames(300, 3);
    ASSERT_TRUE(vehicle.estimate.flying);
    mutable_vehicle.airspeed.speed_mps = 0;
    frames(500);
    EXPECT_TRUE(vehicle.estimate.flying);
}

TEST_F(Estimator, goes_on_flying_against_a_wind_that_stops_it_over_the_ground) {
    mutable_vehicle.armed = mutable_vehicle.airspeed.healthy = true;
    mutable_vehicle.airspeed.speed_mps = 12;
    mutable_vehicle.baro.pressure_pa -= 960;  // 80 m up
    frames(600);
    for (int i = 0; i < 1000; ++i) {
        frame(0);
        ASSERT_TRUE(vehicle.estimate.flying) << i;
    }
}

TEST_F(Estimator, goes_on_flying_in_such_a_wind_without_an_airspeed_sensor_while_it_is_high) {
    mutable_vehicle.armed = true;
    mutable_vehicle.baro.pressure_pa -= 960;
    frames(400, 3);
    frames(400, -3);
    for (int i = 0; i < 1000; ++i) {
        frame(0);
        ASSERT_TRUE(vehicle.estimate.flying) << i;
    }
    mutable_vehicle.baro.pressure_pa += 960;
    frames(1000);
    EXPECT_FALSE(vehicle.estimate.flying) << "it has come down";
}

TEST_F(Estimator, goes_on_flying_in_such_a_wind_after_home_was_set_where_it_is) {
    mutable_vehicle.armed = true;
    mutable_vehicle.baro.pressure_pa -= 960;
    frames(400, 3);
    frames(400, -3);
    firmware::estimator::shiftHeight(-vehicle.estimate.height_m);
    for (int i = 0; i < 1000; ++i) {
        frame(0);
        ASSERT_TRUE(vehicle.estimate.flying) << i;
    }
}

// At home's height, rocked, after an airspeed sensor that has shown the wind has failed.
struct Stopped : Estimator {
    void stop(float airspeed_before_mps) {
        mutable_vehicle.armed = mutable_vehicle.airspeed.healthy = true;
        mutable_vehicle.airspeed.speed_mps = airspeed_before_mps;
        frames(400, 3);
        frames(1000);
        mutable_vehicle.airspeed.healthy = false;
        mutable_vehicle.imu.rate_rads.x = core::BodyRate(0.5f);
        frames(400, -3);
        frames(350);
        EXPECT_LT(vehicle.estimate.ground_speed_mps, 1);
    }
};

TEST_F(Stopped, stands_when_the_wind_leaves_too_little_airspeed) {
    stop(12);
    EXPECT_FALSE(vehicle.estimate.flying);
}

TEST_F(Stopped, goes_on_flying_when_the_wind_is_airspeed_enough) {
    stop(24);
    EXPECT_TRUE(vehicle.estimate.flying);
}

// Without the sensor the wind is learnt from few turns, in which it may have been half as strong.
TEST_F(Stopped, goes_on_flying_high_above_the_field_when_the_wind_alone_says_that_it_is_slow) {
    mutable_vehicle.baro.pressure_pa -= 960;
    stop(10);
    ASSERT_TRUE(firmware::estimator::slowThroughTheAir());
    EXPECT_TRUE(vehicle.estimate.flying);
}

// A tube that clogs says so as well.
TEST_F(Stopped, stands_on_a_hill_when_it_is_slow_by_wind_or_sensor_and_nothing_turns_it) {
    for (const bool healthy : {false, true}) {
        SetUp();
        speed_mps_ = 0;
        mutable_vehicle.baro.pressure_pa -= 960;
        stop(10);
        mutable_vehicle.airspeed.healthy = healthy;
        mutable_vehicle.airspeed.speed_mps = 0;
        frames(310);
        EXPECT_TRUE(vehicle.estimate.flying) << healthy;
        mutable_vehicle.imu.rate_rads.x = core::BodyRate(0.0f);
        frames(310);
        EXPECT_FALSE(vehicle.estimate.flying) << healthy;
    }
}

TEST_F(Estimator, goes_on_flying_while_it_climbs_on_the_spot) {
    mutable_vehicle.armed = true;
    mutable_vehicle.baro.pressure_pa += 60;  // five metres below home
    frames(400, 3);
    frames(400, -3);
    for (int i = 0; i < 600; ++i) {
        mutable_vehicle.baro.pressure_pa = 101385 - i * 12 / 100;  // by a metre a second
        frame(0);
        ASSERT_TRUE(vehicle.estimate.flying) << i;
    }
    frames(500);
    EXPECT_FALSE(vehicle.estimate.flying);
}

TEST_F(Estimator, stands_on_the_ground_with_the_wind_in_its_tube) {
    mutable_vehicle.armed = mutable_vehicle.airspeed.healthy = true;
    mutable_vehicle.airspeed.speed_mps = 12;
    for (int i = 0; i < 500; ++i) {
        frame(0);
        ASSERT_FALSE(vehicle.estimate.flying) << i;
    }
    mutable_vehicle.imu.rate_rads.x = core::BodyRate(0.5f);
    frames(100);
    EXPECT_TRUE(vehicle.estimate.flying) << "it is rocked";
    mutable_vehicle.imu.rate_rads.x = core::BodyRate(0.0f);
    frames(310);
    EXPECT_FALSE(vehicle.estimate.flying);
}

// It came down while neither fixes nor a tube measured its speed: the reckoned one goes on.
TEST_F(Estimator, stands_on_the_field_where_nothing_measures_its_speed) {
    for (const bool high : {false, true})
        for (const bool turns : {false, true}) {
            core::resetFileStates();
            SetUp();
            mutable_vehicle.armed = true;
            mutable_vehicle.baro.pressure_pa -= high ? 360 : 0;  // 30 m
            late_ = 7;
            frames(400, 3);
            frames(200);
            ASSERT_TRUE(vehicle.estimate.flying);
            late_ = 99;
            mutable_vehicle.imu.rate_rads.x = core::BodyRate(turns ? 0.5f : 0.0f);
            frames(700);
            EXPECT_TRUE(vehicle.estimate.reckoned);
            EXPECT_EQ(vehicle.estimate.flying, high || turns) << high << turns;
        }
}

// Dead reckoning moves whether the airplane does or not: it is evidence of nothing.
TEST_F(Estimator, neither_flies_nor_moves_by_dead_reckoning_on_the_ground) {
    mutable_vehicle.armed = true;
    frames(500);
    const geo::Position before = vehicle.estimate.position;
    late_ = 99;  // no more fixes
    for (int i = 0; i < 1500; ++i) {
        frame(0);
        ASSERT_FALSE(vehicle.estimate.flying) << i;
        ASSERT_LT(vehicle.estimate.ground_speed_mps, 1) << i;
        if (i > 300) {
            ASSERT_LT(vehicle.estimate.airspeed_mps, 1) << i;
        }
    }
    EXPECT_TRUE(vehicle.estimate.reckoned);
    EXPECT_LT(geo::distance_m(before, vehicle.estimate.position), 5);
    late_ = 7;
    frames(100);
    EXPECT_FALSE(vehicle.estimate.fix_refused);
}

TEST_F(Estimator, does_not_fly_by_accelerometers_that_the_fixes_deny) {
    mutable_vehicle.armed = true;
    frames(500);
    imu_lies_mss_ = 40;
    float fastest_mps = 0;
    for (int i = 0; i < 300; ++i) {
        frame(0);
        fastest_mps = std::max(fastest_mps, vehicle.estimate.ground_speed_mps);
        ASSERT_FALSE(vehicle.estimate.flying) << i;
    }
    EXPECT_GT(fastest_mps, 8);
}

TEST_F(Estimator, flies_by_the_ground_speed_without_an_airspeed_sensor) {
    mutable_vehicle.armed = true;
    frames(150, 3);
    EXPECT_FALSE(vehicle.estimate.flying);
    frames(150, 3);
    EXPECT_TRUE(vehicle.estimate.flying);
}

TEST_F(Stopped, knows_the_wind_and_its_height_again_after_a_restart) {
    mutable_vehicle.baro.pressure_pa -= 600;
    stop(24);
    const float height_m = vehicle.estimate.height_m, wind_mps = vehicle.estimate.wind_mps.x;
    ASSERT_LT(wind_mps, -10);
    const auto [slow, fast] = recordsOfARestart();
    Estimator::SetUp();
    firmware::estimator::resumeEstimate(slow, fast, {0, 0, 0}, 0.1f);
    mutable_vehicle.baro.pressure_pa -= 600;
    frames(20);
    EXPECT_NEAR(vehicle.estimate.wind_mps.x, wind_mps, 0.01);
    EXPECT_NEAR(vehicle.estimate.height_m, height_m, 0.2);
    EXPECT_TRUE(vehicle.estimate.flying);
}

// Attitude and heading stay as they were when the sensor failed; the airplane turns on.
TEST_F(Estimator, learns_no_wind_while_the_inertial_sensor_fails) {
    mutable_vehicle.armed = mutable_vehicle.airspeed.healthy = true;
    mutable_vehicle.airspeed.speed_mps = 15;
    mutable_vehicle.baro.pressure_pa -= 960;
    frames(400, 3);
    frames(300);
    ASSERT_TRUE(vehicle.estimate.flying);
    const core::Vector3 wind_mps = vehicle.estimate.wind_mps;
    mutable_vehicle.imu.healthy = false;
    frames(400, -3);
    frames(600);
    EXPECT_TRUE(vehicle.estimate.flying);
    EXPECT_EQ(vehicle.estimate.wind_mps.x, wind_mps.x);
    EXPECT_EQ(vehicle.estimate.wind_mps.y, wind_mps.y);
    mutable_vehicle.imu.healthy = true;
    frames(400, 3);
    EXPECT_NE(vehicle.estimate.wind_mps.x, wind_mps.x) << "it goes on";
}

// The nose is where it is now, a fix a quarter of a second old.
TEST_F(Estimator, finds_no_wind_in_the_age_of_the_fixes) {
    mutable_vehicle.armed = mutable_vehicle.airspeed.healthy = true;
    for (int i = 0; i < 700; ++i) {
        mutable_vehicle.airspeed.speed_mps = speed_mps_;
        frame(3);
    }
    ASSERT_TRUE(vehicle.estimate.flying);
    EXPECT_NEAR(vehicle.estimate.wind_mps.x, 0, 0.2);
}

// The tube is still covered.
TEST_F(Estimator, flies_by_the_ground_speed_beside_an_airspeed_sensor_that_reads_nothing) {
    const float least_mps = firmware::state::parameters.speed_min_mps;
    for (const float speed_mps : {least_mps - 0.5f, least_mps + 0.5f}) {
        SetUp();
        mutable_vehicle.armed = mutable_vehicle.airspeed.healthy = true;
        mutable_vehicle.airspeed.speed_mps = 0;
        speed_mps_ = 0;
        frames(400, speed_mps / 4);
        frames(300);
        EXPECT_EQ(vehicle.estimate.flying, speed_mps > least_mps) << speed_mps;
    }
}

// Slower than it flies nothing contradicts a sensor, and what a speed near 0 lacks is a multiple of
// it.
TEST_F(Estimator, learns_no_ratio_of_a_sensor_that_reads_next_to_nothing) {
    using firmware::state::parameters;
    parameters.airspeed_ratio = 2;
    parameters.airspeed_autocal = 1;
    mutable_vehicle.armed = mutable_vehicle.airspeed.healthy = true;
    for (int i = 0; i < 2500; ++i) {
        frame(i < 400 ? 3.25f : i < 2250 ? 0 : -2);
        mutable_vehicle.airspeed.speed_mps = speed_mps_;
    }
    mutable_vehicle.airspeed.speed_mps = 0.2f;
    frames(200);
    EXPECT_TRUE(vehicle.estimate.flying);
    EXPECT_NEAR(parameters.airspeed_ratio, 2, 0.02);
}

TEST_F(Estimator, records_how_far_home_was_moved_above_the_field) {
    frames(20);
    firmware::state::SlowRecord slow = {};
    firmware::estimator::zeroHeight();
    firmware::estimator::shiftHeight(-12.5f);
    firmware::estimator::saveEstimate(slow);
    EXPECT_EQ(slow.home_above_field_m, 12.5f);
    EXPECT_NEAR(firmware::estimator::aboveField_m(), 0, 0.1);
    firmware::estimator::zeroHeight();
    firmware::estimator::saveEstimate(slow);
    EXPECT_EQ(slow.home_above_field_m, 0);
}

// Turned on its mounting or pulled aside by a magnet: it shows this heading while the airplane
// flies north.
struct WrongHeading : Estimator {
    void fly(float heading_deg, float ground_mps, int count = 1500) {
        const float heading_rad = core::radians(heading_deg);
        compass_mg_ = {210 * std::cos(heading_rad), -210 * std::sin(heading_rad), 430};
        frames(1000);
        mutable_vehicle.armed = true;
        frames(200, ground_mps / 2);
        frames(150);
        ASSERT_TRUE(vehicle.estimate.flying);
        for (int i = 0; i < count; ++i) {
            frame(0);
            firmware::sensors::acceptReading(Sensor::compass, static_cast<int16_t>(frame_ % 7),
                                             true);
            if (frame_ % 10 == 0) firmware::sensors::watchHealth();
            mutable_vehicle.compass.healthy = !isFaulty(Sensor::compass);
        }
    }
    float yaw_deg() const { return core::degrees(vehicle.attitude.yaw_rad.toFloat()); }
};

TEST_F(WrongHeading, is_given_up_for_the_course_when_it_lies_across_it) {
    for (const float heading_deg : {90.0f, -85.0f}) {
        SetUp();
        fly(heading_deg, 14);
        EXPECT_TRUE(isFaulty(Sensor::compass)) << heading_deg;
        EXPECT_LT(std::fabs(yaw_deg()), 15);
    }
}

// Half a turn off, as outside compasses are mounted.
TEST_F(WrongHeading, is_set_right_by_the_course_on_the_runway) {
    struct Case {
        const char* name;
        int8_t thrown_mss;
        float throttle;
        bool set_right;
    };
    for (const Case& each : {Case{"takes off", 0, 1, true},
                             {"is thrown: no wheels", 10, 1, false},
                             {"stands, the receiver is wrong", 0, 0, false}}) {
        SetUp();
        firmware::state::parameters.takeoff_min_accel_mss = each.thrown_mss;
        compass_mg_ = {-210, 0, 430};
        mutable_vehicle.airspeed.healthy = true;
        mutable_vehicle.airspeed.speed_mps = 3;
        frames(1000);
        ASSERT_GT(std::fabs(yaw_deg()), 170);
        mutable_vehicle.armed = true;
        mutable_vehicle.throttle_demand = core::Ratio(each.throttle);
        frames(250, 2.5f);
        ASSERT_FALSE(vehicle.estimate.flying);
        EXPECT_EQ(std::fabs(yaw_deg()) < 10, each.set_right) << each.name << ": " << yaw_deg();
        mutable_vehicle.throttle_demand = core::Ratio(0.0f);
        frames(250, -2.5f);
    }
}

TEST_F(WrongHeading, is_forgotten_on_the_ground) {
    fly(90, 14, 100);
    frames(200, -7);
    mutable_vehicle.armed = false;
    frames(600);
    ASSERT_FALSE(vehicle.estimate.flying);
    firmware::sensors::watchHealth();
    mutable_vehicle.compass.healthy = true;
    compass_mg_ = {210, 0, 430};  // it is set right
    frames(8000);
    mutable_vehicle.gps.course_cd = 3000;  // and the wind comes from the side
    fly(0, 14);
    EXPECT_FALSE(isFaulty(Sensor::compass));
}

TEST_F(WrongHeading, may_be_right_in_a_wind_from_the_side) {
    firmware::state::parameters.takeoff_min_accel_mss = 10;  // on wheels it would point ahead
    fly(50, 14);
    EXPECT_FALSE(isFaulty(Sensor::compass));
}

TEST_F(WrongHeading, may_be_right_where_a_wind_leaves_little_speed_over_the_ground) {
    mutable_vehicle.airspeed.healthy = true;
    mutable_vehicle.airspeed.speed_mps = 14;
    fly(90, 7);
    EXPECT_FALSE(isFaulty(Sensor::compass));
}

// The compass reads 30 mG more downwards from now on: flying straight, nearly half of it counts as
// the airplane's own.
struct OwnField : Estimator {
    void SetUp() override {
        Estimator::SetUp();
        firmware::state::parameters.compass_learn = 1;
    }
    void fly(bool flies) {
        for (float& offset_mg : firmware::state::parameters.compass.offset_mg) offset_mg = 0;
        firmware::sensors::noteStoredOffsets();
        mutable_vehicle.armed = true;
        frames(300);
        frames(400, flies ? 3.0f : 0.0f);
        compass_mg_.z = 460;
        frames(2500);
        firmware::estimator::saveEstimate(slow);
    }
    const float& learnt_mg = firmware::state::parameters.compass.offset_mg[2];
    firmware::state::SlowRecord slow = {};
};

TEST_F(OwnField, goes_over_into_the_offsets_in_flight) {
    fly(true);
    ASSERT_TRUE(vehicle.estimate.flying);
    EXPECT_LT(learnt_mg, -10);
    EXPECT_GT(learnt_mg, -30);
}

TEST_F(OwnField, stays_out_of_the_offsets_on_the_ground) {
    fly(false);
    EXPECT_EQ(learnt_mg, 0);
    EXPECT_GT(slow.learnt.field.own[2], 10);
}

TEST_F(OwnField, stays_out_of_the_offsets_where_they_are_not_to_be_learnt) {
    firmware::state::parameters.compass_learn = 0;
    fly(true);
    EXPECT_EQ(learnt_mg, 0);
    EXPECT_GT(slow.learnt.field.own[2], 10);
}

TEST_F(OwnField, stays_out_of_the_offsets_while_the_inertial_sensor_is_lost) {
    mutable_vehicle.imu.healthy = false;
    fly(true);
    EXPECT_EQ(learnt_mg, 0);
}

// Before it was seen to be lost it turned the attitude, and the field with it.
TEST_F(OwnField, is_forgotten_when_the_inertial_sensor_is_back) {
    fly(true);
    ASSERT_NE(learnt_mg, 0);
    mutable_vehicle.imu.periods = 0;
    for (int i = 0; i < 25; ++i) firmware::estimator::runAttitude();
    EXPECT_NE(learnt_mg, 0);
    mutable_vehicle.imu.periods = 2;
    firmware::estimator::runAttitude();
    EXPECT_EQ(learnt_mg, 0);
}

// After a restart the offsets are as they are stored.
TEST_F(OwnField, is_recorded_for_a_restart_with_what_went_over) {
    fly(true);
    EXPECT_EQ(slow.learnt.field.own[2], core::rounded(-learnt_mg));
}

// A loss of power that resets the inertial sensor, too: after `frames` it gives samples again.
bool holdsAttitudeThrough(int frames) {
    const auto [slow, fast] = recordsOfARestart();
    mutable_vehicle.imu.calibrated = true;
    firmware::estimator::resumeEstimate(slow, fast, {0, 0, 0}, 0.1f);
    mutable_vehicle.imu.periods = 0;
    for (int i = 0; i < frames; ++i) firmware::estimator::runAttitude();
    mutable_vehicle.imu.periods = 2;
    firmware::estimator::runAttitude();
    return vehicle.attitude.aligned;
}

TEST_F(Estimator, waits_half_a_second_for_the_inertial_sensor_after_a_restart_in_the_air) {
    frames(300);
    ASSERT_TRUE(vehicle.attitude.aligned);
    EXPECT_TRUE(holdsAttitudeThrough(49));
    EXPECT_FALSE(holdsAttitudeThrough(50));
}

TEST_F(Estimator, loses_the_attitude_in_flight_after_a_fifth_of_a_second_without_samples) {
    for (const int gap : {19, 20}) {
        frames(300);
        mutable_vehicle.imu.periods = 0;
        for (int i = 0; i < gap; ++i) firmware::estimator::runAttitude();
        EXPECT_EQ(vehicle.attitude.aligned, gap < 20);
    }
}

// The barometer has not been healthy since the start, at 500 m above the sea.
struct WithoutBarometer : Estimator {
    void SetUp() override {
        Estimator::SetUp();
        mutable_vehicle.baro.healthy = false;
        mutable_vehicle.baro.ground_pressure_pa = 0;
        altitude_m_ = 500;
    }
    void climbTo(float altitude_m) {
        climb_mps_ = 4;
        while (altitude_m_ < altitude_m) frame(0);
    }
    void flyUp() {
        mutable_vehicle.armed = true;
        frames(400, 3);
        climbTo(580);
    }
    void giveBarometer() {
        mutable_vehicle.baro.healthy = true;
        mutable_vehicle.baro.ground_pressure_pa = 101325;  // here, 80 m up
    }
    void expectLevel(float height_m, int for_frames) {
        for (int i = 0; i < for_frames; ++i) {
            frame(0);
            ASSERT_NEAR(vehicle.estimate.height_m, height_m, 0.5) << i;
        }
    }
};

TEST_F(WithoutBarometer, counts_heights_from_the_first_fix_while_there_is_no_home) {
    frames(20);
    expectLevel(0, 500);
    climbTo(580);
    EXPECT_NEAR(vehicle.estimate.height_m, 80, 2);
    EXPECT_NEAR(vehicle.estimate.climb_mps, 4, 0.3);
    climb_mps_ = 0;
    frames(1000);
    expectLevel(80, 100);
    EXPECT_NEAR(vehicle.estimate.climb_mps, 0, 0.1);
}

TEST_F(WithoutBarometer, counts_heights_from_home) {
    firmware::mission::setHome(kStart, 45000);
    frames(20);
    expectLevel(50, 500);
}

TEST_F(WithoutBarometer, loses_nothing_of_a_climb_between_the_first_two_fixes) {
    climb_mps_ = 10;
    while (vehicle.gps.fixes == 0) frame(0);
    const float first_m = vehicle.gps.altitude_cm * 0.01f;
    climbTo(580);
    climb_mps_ = 0;
    frames(1500);
    EXPECT_NEAR(vehicle.estimate.height_m, altitude_m_ - first_m, 0.5);
}

TEST_F(WithoutBarometer, makes_no_step_when_the_barometer_comes_in_flight_nor_when_it_goes_again) {
    flyUp();
    climb_mps_ = 0;
    frames(1000);
    giveBarometer();
    expectLevel(80, 500);
    ASSERT_TRUE(vehicle.estimate.flying);
    mutable_vehicle.baro.healthy = false;
    expectLevel(80, 1000);
    mutable_vehicle.baro.healthy = true;
    mutable_vehicle.baro.pressure_pa -= 60;
    frames(1000);
    EXPECT_NEAR(vehicle.estimate.height_m, 85, 0.5) << "by the barometer";
}

TEST_F(WithoutBarometer, trusts_the_one_that_comes_whatever_height_it_begins_with) {
    flyUp();
    climb_mps_ = 0;
    firmware::sensors::acceptReading(firmware::sensors::Sensor::barometer, 1,
                                     true);  // a single one
    for (int i = 0; i < 20; ++i) {
        frames(10);
        firmware::sensors::watchHealth();
    }
    ASSERT_TRUE(firmware::sensors::isFaulty(firmware::sensors::Sensor::barometer)) << "silent";
    giveBarometer();
    watched(1000);
    EXPECT_TRUE(vehicle.baro.healthy);
    EXPECT_NEAR(vehicle.estimate.height_m, 80, 1.5);
}

TEST_F(WithoutBarometer, climbs_on_when_the_barometer_comes) {
    flyUp();
    giveBarometer();
    const float above_m = altitude_m_ - vehicle.estimate.height_m;
    for (int i = 0; i < 500; ++i) {
        mutable_vehicle.baro.pressure_pa = 101325 - core::rounded((altitude_m_ - 580) * 12);
        frame(0);
        ASSERT_NEAR(altitude_m_ - vehicle.estimate.height_m, above_m, 0.5) << i;
        ASSERT_NEAR(vehicle.estimate.climb_mps, 4, 0.5) << i;
    }
}

// A reading stays for 15 s; the wind is known.
struct AirspeedStays : Estimator {
    bool faulty(float acceleration_mss) {
        using namespace firmware::sensors;
        mutable_vehicle.armed = mutable_vehicle.airspeed.healthy = true;
        for (int i = 0; i < 1400; ++i) {
            frame(i < 400 ? 3 : 0);
            mutable_vehicle.airspeed.speed_mps = speed_mps_ + i % 2 * 0.05f;
        }
        for (int i = 0; i < 1500; ++i) {
            frame(i < 200 ? acceleration_mss : 0);
            acceptReading(Sensor::airspeed, 0, true);
            if (i % 10 == 0) watchHealth();
        }
        EXPECT_TRUE(vehicle.estimate.flying);
        return isFaulty(Sensor::airspeed);
    }
};

TEST_F(AirspeedStays, while_gps_and_wind_show_another_speed) { EXPECT_TRUE(faulty(1)); }
TEST_F(AirspeedStays, while_gps_and_wind_show_a_lower_speed) { EXPECT_TRUE(faulty(-1)); }
TEST_F(AirspeedStays, as_the_speed_does) { EXPECT_FALSE(faulty(0)); }
TEST_F(AirspeedStays, within_a_metre_a_second) { EXPECT_FALSE(faulty(0.4f)); }

TEST_F(Estimator, finds_everything_within_its_limit_while_it_fits) {
    frames(600);
    const auto ratios = firmware::estimator::testRatios();
    EXPECT_NEAR(ratios.position, 0, 0.02);
    EXPECT_NEAR(ratios.height, 0, 0.02);
    EXPECT_NEAR(ratios.compass, 0, 0.02);
    EXPECT_EQ(ratios.airspeed, 0) << "there is none";
}

TEST_F(Estimator, knows_a_height_for_two_seconds_after_the_last_reading) {
    EXPECT_FALSE(vehicle.estimate.height_known);
    frames(600);
    EXPECT_TRUE(vehicle.estimate.height_known);
    mutable_vehicle.baro.ground_pressure_pa = 0;  // no readings any more
    frames(180);
    EXPECT_TRUE(vehicle.estimate.height_known);
    frames(40);
    EXPECT_FALSE(vehicle.estimate.height_known);
    EXPECT_EQ(firmware::estimator::testRatios().height, 0);
}

// The limit is 15 m, for either of them.
TEST_F(Estimator, knows_how_far_off_the_height_is_that_it_follows) {
    for (const bool barometer : {true, false}) {
        core::resetFileStates();
        SetUp();
        altitude_m_ = 580;
        late_ = 7;
        frames(600);
        mutable_vehicle.baro.healthy = barometer;
        if (barometer)
            mutable_vehicle.baro.pressure_pa -= 360;
        else
            altitude_m_ += 30;
        frames(barometer ? 10 : 20);  // a whole mean of it, or a fix
        EXPECT_NEAR(firmware::estimator::testRatios().height, 2, 0.1) << barometer;
        frames(400);
        EXPECT_LT(firmware::estimator::testRatios().height, 0.2) << "they insisted";
    }
}

TEST_F(Estimator, knows_how_far_off_a_fix_was) {
    frames(600);
    late_ = 99;
    fix(0);
    mutable_vehicle.gps.position = geo::moved(kStart, {0, 50});
    mutable_vehicle.gps.velocity_mps = {0, 0, 0};
    frames(20);
    EXPECT_TRUE(vehicle.estimate.fix_refused);
    EXPECT_GT(firmware::estimator::testRatios().position, 1.3);
}

// Four metres a second and 30 % of what is expected.
TEST_F(AirspeedStays, is_off_by_a_share_of_its_limit) {
    firmware::state::parameters.airspeed_enable = 1;
    faulty(0);
    EXPECT_NEAR(firmware::estimator::testRatios().airspeed, 0, 0.05);
    mutable_vehicle.airspeed.speed_mps = speed_mps_ - 7.4f;
    EXPECT_NEAR(firmware::estimator::testRatios().airspeed, 7.4f / (4 + 0.3f * speed_mps_), 0.05);
    firmware::state::parameters.airspeed_enable = 0;
    EXPECT_EQ(firmware::estimator::testRatios().airspeed, 0);
    firmware::state::parameters.airspeed_enable = 1;
    late_ = 99;
    frames(250);
    EXPECT_EQ(firmware::estimator::testRatios().airspeed, 0) << "no fix to compare with";
}

TEST_F(Estimator, knows_a_barometer_that_has_jumped_before_arming) {
    using firmware::estimator::barometerSteady;
    frames(600);
    EXPECT_TRUE(barometerSteady());
    mutable_vehicle.baro.pressure_pa -= 1200;  // a hundred metres
    frames(20);
    EXPECT_FALSE(barometerSteady()) << "against its own readings";
    frames(300);
    EXPECT_NEAR(vehicle.estimate.height_m, 100, 5) << "it insists";
    EXPECT_FALSE(barometerSteady()) << "against the receiver";
    frames(3000);
    EXPECT_TRUE(barometerSteady()) << "the receiver may have been far off before";
}

TEST_F(Estimator, keeps_its_height_where_it_stands_armed_and_the_barometer_jumps) {
    frames(600);
    mutable_vehicle.armed = true;
    for (const int32_t by_pa : {-1200, 20000, -18800}) {
        mutable_vehicle.baro.pressure_pa += by_pa;
        for (int i = 0; i < 5; ++i) {
            frames(100);
            EXPECT_NEAR(vehicle.estimate.height_m, 0, 1) << by_pa << ", " << i;
        }
    }
}

// Each of its conditions alone turns the decision.
TEST_F(Estimator,
       finds_the_barometer_steady_by_its_readings_and_by_a_receiver_that_has_been_heard) {
    for (const bool jumps : {false, true})
        for (const bool heard : {false, true})
            for (const bool differs : {false, true}) {
                core::resetFileStates();
                SetUp();
                altitude_m_ = 0;
                late_ = heard ? 7 : 99;
                frames(600);
                if (differs) altitude_m_ = 100;
                if (!heard) mutable_vehicle.gps.altitude_cm = differs ? 10000 : 0;
                if (jumps) mutable_vehicle.baro.pressure_pa -= 1200;
                frames(20);
                EXPECT_EQ(firmware::estimator::barometerSteady(), !jumps && !(heard && differs))
                    << jumps << heard << differs;
            }
}

// Nothing measures its speed: a receiver that is lost or whose fixes stay, and no airspeed sensor.
// After a restart it would have been disarmed.
TEST_F(Estimator, flies_at_a_height_that_it_has_climbed_to_under_power_when_no_speed_is_measured) {
    for (const bool lost : {false, true})
        for (const bool powered : {false, true}) {
            core::resetFileStates();
            SetUp();
            if (lost) late_ = 99;
            mutable_vehicle.gps.healthy = !lost;
            mutable_vehicle.armed = true;
            mutable_vehicle.throttle_demand = core::Ratio(powered ? 1.0f : 0.0f);
            frames(300);
            EXPECT_FALSE(vehicle.estimate.flying) << "it stands";
            for (int i = 0; i < 600; ++i) {
                if (i % 10 == 0) mutable_vehicle.baro.pressure_pa -= 3;  // 2.5 m/s
                frame(0);
            }
            EXPECT_EQ(vehicle.estimate.flying, powered) << lost;
        }
}

// No sensor worked from the restart to the ground: the height of the record is long past when the
// receiver's is compared with it.
TEST_F(Estimator, takes_the_receivers_height_over_home_after_a_restart) {
    frames(300);
    auto [slow, fast] = recordsOfARestart();
    Estimator::SetUp();
    fast.height_m = 40;
    altitude_m_ = 500;
    mutable_vehicle.home.set = true;
    mutable_vehicle.home.altitude_cm = 50000;
    firmware::estimator::resumeEstimate(slow, fast, {0, 0, 0}, 0.1f);
    mutable_vehicle.baro.healthy = false;
    frames(10);
    EXPECT_GT(vehicle.estimate.height_m, 30);
    frames(1500);
    EXPECT_NEAR(vehicle.estimate.height_m, 0, 2);
}

// A receiver of one fix a second then took two and a half minutes to learn where its zero is.
TEST_F(Estimator, finds_the_barometer_steady_after_a_fix_that_came_before_its_first_reading) {
    altitude_m_ = 400;
    mutable_vehicle.baro.ground_pressure_pa = 0;
    frames(60);
    mutable_vehicle.baro.ground_pressure_pa = 101325;
    frames(100);
    EXPECT_TRUE(firmware::estimator::barometerSteady());
}

TEST_F(Estimator, begins_at_the_barometers_reading_when_heights_are_zeroed) {
    frames(600);
    mutable_vehicle.baro.pressure_pa -= 1200;
    frames(20);
    firmware::estimator::zeroHeight();
    frames(20);
    EXPECT_NEAR(vehicle.estimate.height_m, 0, 1);
}

// Neither does a wind say so when there are no fixes.
TEST_F(Estimator, loses_an_airspeed_that_stays_slow_in_a_dive_at_full_throttle_without_fixes_too) {
    using namespace firmware::sensors;
    for (const bool dives : {false, true}) {
        SetUp();
        mutable_vehicle.armed = mutable_vehicle.airspeed.healthy = true;
        mutable_vehicle.airspeed.speed_mps = firmware::state::parameters.speed_min_mps - 1;
        frames(400, 4);
        ASSERT_TRUE(vehicle.estimate.flying);
        mutable_vehicle.throttle_demand = core::Ratio(1);
        mutable_vehicle.attitude.sin_pitch = core::Ratio(dives ? -0.2f : -0.1f);
        for (int i = 0; i < 25; ++i) {
            firmware::estimator::fuseAirspeed();
            acceptReading(Sensor::airspeed, static_cast<int16_t>(i % 5), true);
            watchHealth();
        }
        EXPECT_EQ(isFaulty(Sensor::airspeed), dives);
    }
}

// A sensor's conversion has gone wrong for a moment; nothing else would ever take the NaN out
// again.
TEST_F(Estimator, begins_again_with_a_height_that_is_no_number) {
    frames(300);
    ASSERT_NEAR(vehicle.estimate.height_m, 0, 1);
    mutable_vehicle.baro.ground_temperature_c = NAN;
    frames(6);
    ASSERT_TRUE(std::isnan(vehicle.estimate.height_m) ||
                core::internalErrors().last == core::InternalError::height_not_finite);
    mutable_vehicle.baro.ground_temperature_c = 15;
    frames(30);
    EXPECT_NEAR(vehicle.estimate.height_m, 0, 1);
    EXPECT_EQ(core::internalErrors().last, core::InternalError::height_not_finite);
    const uint8_t changes = core::internalErrors().changes;
    frames(100);
    EXPECT_EQ(core::internalErrors().changes, changes);
}

TEST_F(Estimator, begins_again_with_a_velocity_that_is_no_number) {
    frames(300);
    mutable_vehicle.gps.velocity_mps.x = NAN;
    ++mutable_vehicle.gps.fixes;
    frames(9);
    frames(60);
    EXPECT_EQ(core::internalErrors().last, core::InternalError::position_not_finite);
    EXPECT_TRUE(std::isfinite(vehicle.estimate.velocity_mps.x));
    EXPECT_TRUE(std::isfinite(vehicle.estimate.ground_speed_mps));
}

}  // namespace
