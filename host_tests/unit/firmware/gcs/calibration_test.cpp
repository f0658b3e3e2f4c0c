// SPDX-License-Identifier: GPL-3.0-or-later
// Calibrations as ground stations talk the pilot through them.
#include <cmath>

#include "core/maths.hpp"
#include "firmware/gcs/calibration.hpp"
#include "firmware/sensors/compass_learning.hpp"
#include "ground.hpp"
#include "host_tests/support/fakes/vehicle.hpp"
#include "storage/owner.hpp"

namespace {

using firmware::state::mutable_vehicle;
using firmware::state::parameters;
using firmware::state::vehicle;
using mavlink::MavCmd;
using mavlink::MavResult;

constexpr float kOffset_mss[] = {0.7f, -0.4f, 1.1f}, kScale[] = {1.02f, 0.97f, 1.05f};
constexpr float kTilt = 0.12f;  // nobody holds it exactly

core::Vector3 reading(const core::Vector3& force_mss) {
    return {force_mss.x / kScale[0] + kOffset_mss[0], force_mss.y / kScale[1] + kOffset_mss[1],
            force_mss.z / kScale[2] + kOffset_mss[2]};
}
// On each side in the order in which they are asked for.
core::Vector3 onSide(int side) {
    constexpr int kAxis[] = {2, 1, 1, 0, 0, 2}, kSign[] = {-1, 1, -1, -1, 1, 1};
    float axes[3];
    for (int i = 0; i < 3; ++i) axes[i] = core::kGravity_mss * kTilt * (side % 2 == i % 2 ? 1 : -1);
    axes[kAxis[side]] = kSign[side] * core::kGravity_mss * std::sqrt(1 - 2 * kTilt * kTilt);
    return {axes[0], axes[1], axes[2]};
}

struct Calibration : ground::Telemetry {
    void SetUp() override {
        Telemetry::SetUp();
        mutable_vehicle.imu.calibrated = mutable_vehicle.attitude.aligned = true;
        mutable_vehicle.baro.ground_pressure_pa = 95000;
        mutable_vehicle.compass.healthy = true;
    }
    bool asked(const std::string& part) {
        for (const std::string& text : station.texts())
            if (text.find(part) != std::string::npos) return true;
        return false;
    }
    void pressKey(uint16_t number) {
        mavlink::CommandAck key = {};
        key.command = number;
        key.result = 1;
        station.send(key);
        run_ms(40);
    }
    void lie(const core::Vector3& force_mss) {
        doubles::vehicle.rest_force_mss = reading(force_mss);
        mutable_vehicle.imu.calibrated = true;
        run_ms(100);
    }
    void begin() {
        ASSERT_EQ(command(MavCmd::preflight_calibration, 0, 0, 0, 0, 1), MavResult::accepted);
    }
    std::vector<int> positions() {
        std::vector<int> found;
        for (const auto& message : station.all<mavlink::CommandLong>())
            if (message.command == MavCmd::accelcal_vehicle_pos)
                found.push_back(static_cast<int>(message.param1));
        return found;
    }
};

TEST_F(Calibration, of_the_accelerometers_goes_round_six_sides) {
    const char* const kAsked[] = {"Place vehicle level and press any key",
                                  "Place vehicle on its LEFT side",
                                  "Place vehicle on its RIGHT side",
                                  "Place vehicle nose DOWN",
                                  "Place vehicle nose UP",
                                  "Place vehicle on its BACK"};
    begin();
    for (int side = 0; side < 6; ++side) {
        EXPECT_TRUE(asked(kAsked[side])) << side;
        const auto reported = positions();
        ASSERT_FALSE(reported.empty());
        EXPECT_EQ(reported.back(), side + 1);
        mutable_vehicle.imu.calibrated = true;
        run_ms(2500);
        EXPECT_GE(positions().size(), 2u) << "said again while the pilot is busy";
        pressKey(static_cast<uint16_t>(side + 1));
        EXPECT_FALSE(asked("Place")) << "not before it has lain still";
        lie(onSide(side));
    }
    EXPECT_TRUE(asked("Calibration successful"));
    EXPECT_EQ(positions().back(), static_cast<int>(mavlink::AccelcalVehiclePos::success));
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(parameters.accel_offset_mss[i], kOffset_mss[i], 0.01f);
        EXPECT_NEAR(parameters.accel_scale[i], kScale[i], 0.001f);
    }
    EXPECT_NEAR(parameters.level_trim_rad[0], -std::atan2(kTilt, 1) * -1, 0.01f);
    EXPECT_EQ(firmware::state::vehicle.calibrating, firmware::state::Calibrating::nothing);
}

TEST_F(Calibration, takes_the_newer_ground_stations_command_for_a_key_too) {
    begin();
    EXPECT_EQ(command(MavCmd::accelcal_vehicle_pos, 3), MavResult::denied) << "level was asked for";
    EXPECT_EQ(command(MavCmd::accelcal_vehicle_pos, 1), MavResult::accepted);
    lie(onSide(0));
    EXPECT_TRUE(asked("LEFT"));
    EXPECT_EQ(command(MavCmd::preflight_calibration), MavResult::accepted) << "called off";
    EXPECT_EQ(firmware::state::vehicle.calibrating, firmware::state::Calibrating::nothing);
}

TEST_F(Calibration, asks_again_when_it_lies_on_another_side) {
    begin();
    pressKey(0);
    lie(onSide(0));
    EXPECT_TRUE(asked("LEFT"));
    pressKey(0);
    lie(onSide(2));
    const auto texts = station.texts();
    ASSERT_EQ(texts.size(), 2u);
    EXPECT_EQ(texts[0], "That is another side: not taken");
    EXPECT_NE(texts[1].find("LEFT"), std::string::npos);
}

TEST_F(Calibration, an_implausible_calibration_is_not_stored) {
    begin();
    for (int side = 0; side < 6; ++side) {
        pressKey(1);
        core::Vector3 force_mss = onSide(side);
        force_mss.x *= 0.7f;  // a broken axis
        lie(force_mss);
    }
    EXPECT_TRUE(asked("Calibration FAILED"));
    EXPECT_EQ(positions().back(), static_cast<int>(mavlink::AccelcalVehiclePos::failed));
    EXPECT_EQ(parameters.accel_scale[0], 1);
    EXPECT_EQ(parameters.accel_offset_mss[1], 0);
}

TEST_F(Calibration, a_calibration_that_is_never_still_fails) {
    begin();
    pressKey(1);
    run_ms(33000);
    EXPECT_TRUE(asked("Calibration FAILED: keep it still"));
    EXPECT_EQ(firmware::state::vehicle.calibrating, firmware::state::Calibrating::nothing);
}

TEST_F(Calibration, is_refused_with_a_reason_when_armed_or_beside_another) {
    begin();
    EXPECT_EQ(command(MavCmd::preflight_calibration, 1), MavResult::temporarily_rejected);
    EXPECT_TRUE(asked("Calibration refused: another runs"));
    EXPECT_EQ(command(MavCmd::preflight_calibration), MavResult::accepted);
    mutable_vehicle.armed = true;
    for (const uint16_t how : {1, 4})
        EXPECT_EQ(command(MavCmd::preflight_calibration, 0, 0, 0, 0, how),
                  MavResult::temporarily_rejected);
    EXPECT_TRUE(asked("Calibration refused: disarm first"));
    EXPECT_EQ(command(MavCmd::do_start_mag_cal), MavResult::temporarily_rejected);
}

TEST_F(Calibration, ends_when_the_airplane_is_armed) {
    begin();
    mutable_vehicle.armed = true;
    run_ms(40);
    EXPECT_EQ(firmware::state::vehicle.calibrating, firmware::state::Calibrating::nothing);
}

TEST_F(Calibration, of_one_side_sets_the_offsets_alone) {
    EXPECT_EQ(command(MavCmd::preflight_calibration, 0, 0, 0, 0, 4), MavResult::in_progress);
    doubles::vehicle.rest_force_mss = {0.3f, -0.2f, -9.5f};
    mutable_vehicle.imu.calibrated = true;
    run_ms(100);
    const auto acks = station.all<mavlink::CommandAck>();
    ASSERT_FALSE(acks.empty());
    EXPECT_EQ(acks.back().result, MavResult::accepted);
    EXPECT_NEAR(parameters.accel_offset_mss[0], 0.3f, 1e-4);
    EXPECT_NEAR(parameters.accel_offset_mss[2], core::kGravity_mss - 9.5f, 1e-4);
    EXPECT_EQ(parameters.accel_scale[2], 1);
}

TEST_F(Calibration, of_the_level_needs_the_airplane_still) {
    mutable_vehicle.attitude.rate_rads.y = core::BodyRate(0.2f);
    EXPECT_EQ(command(MavCmd::preflight_calibration, 0, 0, 0, 0, 2), MavResult::failed);
    EXPECT_TRUE(asked("Level: keep it still"));
}

TEST_F(Calibration, of_gyros_with_the_compass_is_the_old_ground_start) {
    EXPECT_EQ(command(MavCmd::preflight_calibration, 1, 1), MavResult::in_progress);
    EXPECT_EQ(firmware::state::vehicle.calibrating, firmware::state::Calibrating::rest);
}

// ---- the compass
constexpr core::Vector3 kIron_mg = {120, -80, 60};

struct Compass : Calibration {
    void SetUp() override {
        Calibration::SetUp();
        station.framing = ground::Framing::v2;
    }
    // The earth's field from all around: once over, tumbling.
    void turnAbout(int turns, float flat = 1) {
        for (int step = 0; step < turns * 200; ++step) {
            const float a = 0.0314f * step, b = 0.0083f * step;
            const float across = flat * std::sin(b), along = std::sqrt(1 - across * across);
            sense(core::Vector3{along * std::cos(a), along * std::sin(a), across} * 480);
            run_ms(20);
        }
    }
    void sense(const core::Vector3& field_mg) {
        const core::Vector3 read = field_mg - kIron_mg;
        if (sensed_++ % 4 == 0) learn(read);
        const float* offset = parameters.compass.offset_mg;
        mutable_vehicle.compass.field_mg = read + core::Vector3{offset[0], offset[1], offset[2]};
    }
    static void learn(const core::Vector3& read_mg) {
        const int16_t whole_mg[3] = {static_cast<int16_t>(std::lround(read_mg.x)),
                                     static_cast<int16_t>(std::lround(read_mg.y)),
                                     static_cast<int16_t>(std::lround(read_mg.z))};
        firmware::sensors::learnCompass(whole_mg);
    }
    void expectRefused() {
        firmware::sensors::saveLearntCompass();
        run_ms(200);
        EXPECT_TRUE(asked("not stored"));
    }
    int sensed_ = 0;  // 50 a second, of which every fourth is learnt from
    void expectFound() {
        EXPECT_NEAR(parameters.compass.offset_mg[0], kIron_mg.x, 5);
        EXPECT_NEAR(parameters.compass.offset_mg[1], kIron_mg.y, 5);
        EXPECT_NEAR(parameters.compass.offset_mg[2], kIron_mg.z, 5);
    }
};

TEST_F(Compass, is_calibrated_by_turning_in_all_directions) {
    EXPECT_EQ(command(MavCmd::do_start_mag_cal), MavResult::accepted);
    turnAbout(14);
    EXPECT_TRUE(asked("Calibration successful"));
    expectFound();
    const auto reports = station.all<mavlink::MagCalReport>();
    ASSERT_EQ(reports.size(), 1u);
    EXPECT_EQ(reports[0].cal_status, mavlink::MagCalStatus::success);
    EXPECT_EQ(reports[0].autosaved, 1);
    EXPECT_NEAR(reports[0].ofs_x, kIron_mg.x, 5);
    const auto progress = station.all<mavlink::MagCalProgress>();
    ASSERT_GE(progress.size(), 5u);
    EXPECT_LT(progress.front().completion_pct, 50);
    EXPECT_EQ(progress.back().completion_pct, 100);
}

TEST_F(Compass, is_calibrated_by_the_older_command_too) {
    EXPECT_EQ(command(MavCmd::preflight_calibration, 0, 1), MavResult::accepted);
    turnAbout(14);
    expectFound();
}

TEST_F(Compass, not_turned_in_all_directions_keeps_its_offsets) {
    EXPECT_EQ(command(MavCmd::do_start_mag_cal), MavResult::accepted);
    turnAbout(48, 0.3f);
    EXPECT_TRUE(asked("Calibration FAILED"));
    EXPECT_EQ(parameters.compass.offset_mg[0], 0);
    const auto reports = station.all<mavlink::MagCalReport>();
    ASSERT_EQ(reports.size(), 1u);
    EXPECT_EQ(reports[0].cal_status, mavlink::MagCalStatus::failed);
}

TEST_F(Compass, cancelled_keeps_its_offsets) {
    EXPECT_EQ(command(MavCmd::do_start_mag_cal), MavResult::accepted);
    turnAbout(1);
    EXPECT_NE(parameters.compass.offset_mg[0], 0);
    EXPECT_EQ(command(MavCmd::do_cancel_mag_cal), MavResult::accepted);
    EXPECT_EQ(parameters.compass.offset_mg[0], 0);
}

TEST_F(Compass, a_missing_compass_is_not_calibrated) {
    mutable_vehicle.compass.healthy = false;
    EXPECT_EQ(command(MavCmd::do_start_mag_cal), MavResult::failed);
    EXPECT_TRUE(asked("no compass"));
}

TEST_F(Compass, learns_in_flight_when_enabled) {
    mutable_vehicle.armed = mutable_vehicle.estimate.flying = true;
    parameters.compass_learn = 0;
    turnAbout(4);
    EXPECT_EQ(parameters.compass.offset_mg[0], 0);
    parameters.compass_learn = 1;
    turnAbout(60);
    expectFound();
}

TEST_F(Compass, that_failed_in_flight_has_its_offsets_from_before_again) {
    ASSERT_EQ(storage::claim(), core::Status::ok);
    parameters.compass.offset_mg[0] = 7;
    firmware::sensors::noteStoredOffsets();
    mutable_vehicle.armed = mutable_vehicle.estimate.flying = true;
    turnAbout(60);
    ASSERT_NE(parameters.compass.offset_mg[0], 7);
    mutable_vehicle.compass.healthy = false;
    expectRefused();
    EXPECT_EQ(parameters.compass.offset_mg[0], 7);
}

// Of a board without a compass nothing is learnt, and nothing is refused.
TEST_F(Compass, that_has_taught_nothing_is_not_complained_of) {
    firmware::sensors::noteStoredOffsets();
    mutable_vehicle.compass.healthy = false;
    mutable_vehicle.armed = mutable_vehicle.estimate.flying = true;
    turnAbout(1);
    firmware::sensors::saveLearntCompass();
    run_ms(200);
    EXPECT_FALSE(asked("not stored"));
}

TEST_F(Compass, whose_offsets_make_no_sense_has_those_from_before_again) {
    firmware::sensors::noteStoredOffsets();
    mutable_vehicle.armed = mutable_vehicle.estimate.flying = true;
    core::Vector3 own_mg = {0, 0, 500};
    firmware::sensors::takeCompassOffset(own_mg);
    EXPECT_EQ(parameters.compass.offset_mg[2], -400) << "as far as they go";
    EXPECT_EQ(own_mg.z, 0);
    expectRefused();
    EXPECT_EQ(parameters.compass.offset_mg[2], 0);
}

// Set on the ground after the start, before it flies.
TEST_F(Compass, has_the_offsets_from_before_as_they_were_set_last) {
    firmware::sensors::noteStoredOffsets();
    parameters.compass.offset_mg[1] = 12;
    learn({210, 0, 430});
    mutable_vehicle.armed = mutable_vehicle.estimate.flying = true;
    turnAbout(60);
    mutable_vehicle.compass.healthy = false;
    firmware::sensors::saveLearntCompass();
    EXPECT_EQ(parameters.compass.offset_mg[1], 12);
}

TEST_F(Compass, keeps_what_it_has_learnt_after_disarming) {
    ASSERT_EQ(storage::claim(), core::Status::ok);
    mutable_vehicle.armed = mutable_vehicle.estimate.flying = true;
    turnAbout(60);
    for (int axis = 0; axis < 3; ++axis) parameters.compass.motor_mg[axis] = 10.0f + axis;
    mutable_vehicle.armed = mutable_vehicle.estimate.flying = false;
    firmware::sensors::saveLearntCompass();
    for (int i = 0; i < 100; ++i) {
        firmware::sensors::storeLearntCompass();
        firmware::state::parametersRun();
    }
    parameters.compass = {};
    fakes::restartEeprom();
    while (firmware::state::parametersLoad() == core::Status::busy) fakes::advance_ms(10);
    expectFound();
    for (int axis = 0; axis < 3; ++axis) EXPECT_EQ(parameters.compass.motor_mg[axis], 10.0f + axis);
}

}  // namespace
