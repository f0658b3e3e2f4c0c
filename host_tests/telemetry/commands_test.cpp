// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "ground.hpp"

using firmware::Mode;
using ground::Telemetry;
using mavlink::MavCmd;
using mavlink::MavResult;

namespace {

TEST_F(Telemetry, a_command_it_does_not_know_is_answered_unsupported) {
    for (const uint16_t id : {0, 21, 42, 30001}) EXPECT_EQ(command(id), MavResult::unsupported);
}

TEST_F(Telemetry, an_ack_is_addressed_to_who_asked) {
    station.framing = ground::Framing::v2;
    mavlink::CommandLong message = {};
    message.command = 42;
    const auto acks = ask<mavlink::CommandAck>(message);
    ASSERT_EQ(acks.size(), 1u);
    EXPECT_EQ(acks[0].target_system, 255);
    EXPECT_EQ(acks[0].target_component, 190);
}

TEST_F(Telemetry, modes_are_set_by_every_way_ground_stations_know) {
    EXPECT_EQ(command(MavCmd::do_set_mode, 1, 11), MavResult::accepted);
    EXPECT_EQ(firmware::vehicle.mode, Mode::rtl);
    EXPECT_EQ(command(MavCmd::do_set_mode, 209, 5), MavResult::accepted);  // other bits set too
    EXPECT_EQ(firmware::vehicle.mode, Mode::fbwa);
    EXPECT_EQ(command(MavCmd::do_set_mode, 220), MavResult::accepted);  // MAV_MODE_AUTO_ARMED
    EXPECT_EQ(firmware::vehicle.mode, Mode::automatic);
    EXPECT_EQ(command(MavCmd::do_set_mode, 64), MavResult::accepted);
    EXPECT_EQ(firmware::vehicle.mode, Mode::manual);
    EXPECT_EQ(command(MavCmd::nav_return_to_launch), MavResult::accepted);
    EXPECT_EQ(firmware::vehicle.mode, Mode::rtl);
    EXPECT_EQ(command(MavCmd::nav_loiter_unlim), MavResult::accepted);
    EXPECT_EQ(firmware::vehicle.mode, Mode::loiter);
    EXPECT_EQ(command(MavCmd::mission_start), MavResult::accepted);
    EXPECT_EQ(firmware::vehicle.mode, Mode::automatic);

    mavlink::SetMode message = {};
    message.target_system = 1;
    message.base_mode = 1;
    message.custom_mode = 2;
    const auto acks = ask<mavlink::CommandAck>(message);
    ASSERT_EQ(acks.size(), 1u);
    EXPECT_EQ(acks[0].command, 11);
    EXPECT_EQ(acks[0].result, MavResult::accepted);
    EXPECT_EQ(firmware::vehicle.mode, Mode::stabilize);
}

TEST_F(Telemetry, set_mode_in_mavlink_1_with_a_component_like_base_mode_is_understood) {
    mavlink::SetMode message = {};
    message.target_system = 1;
    message.base_mode = 217;  // stands where other messages have their component
    message.custom_mode = 10;
    EXPECT_EQ(ask<mavlink::CommandAck>(message).size(), 1u);
    EXPECT_EQ(firmware::vehicle.mode, Mode::automatic);
}

TEST_F(Telemetry, a_mode_that_does_not_exist_is_denied) {
    for (const float mode : {99.0f, 300.0f, -1.0f, static_cast<float>(NAN)})
        EXPECT_EQ(command(MavCmd::do_set_mode, 1, mode), MavResult::denied);
    EXPECT_TRUE(doubles::vehicle.modes.empty());
}

TEST_F(Telemetry, a_mode_that_cannot_be_entered_now_is_rejected_for_now) {
    doubles::vehicle.mode_can_be_entered = false;
    EXPECT_EQ(command(MavCmd::mission_start), MavResult::temporarily_rejected);
    EXPECT_EQ(firmware::vehicle.mode, Mode::manual);
}

TEST_F(Telemetry, arms_and_disarms) {
    EXPECT_EQ(command(MavCmd::component_arm_disarm, 1), MavResult::accepted);
    EXPECT_TRUE(firmware::vehicle.armed);
    EXPECT_FALSE(doubles::vehicle.force);
    EXPECT_EQ(command(MavCmd::component_arm_disarm, 0), MavResult::accepted);
    EXPECT_FALSE(firmware::vehicle.armed);
}

TEST_F(Telemetry, an_arming_that_fails_says_why) {
    doubles::vehicle.can_arm = false;

    EXPECT_EQ(command(MavCmd::component_arm_disarm, 1), MavResult::failed);

    EXPECT_FALSE(firmware::vehicle.armed);
    EXPECT_EQ(station.texts().at(0), "PreArm: no GPS fix");
    EXPECT_EQ(command(MavCmd::run_prearm_checks), MavResult::failed);
    EXPECT_EQ(station.texts().at(0), "PreArm: no GPS fix");
}

TEST_F(Telemetry, arming_is_forced_by_the_documented_number_only) {
    doubles::vehicle.can_arm = false;
    EXPECT_EQ(command(MavCmd::component_arm_disarm, 1, 1), MavResult::failed);
    EXPECT_EQ(command(MavCmd::component_arm_disarm, 1, 2989), MavResult::accepted);
    EXPECT_EQ(command(MavCmd::component_arm_disarm, 0, 21196), MavResult::accepted);
    EXPECT_TRUE(doubles::vehicle.force);
}

TEST_F(Telemetry, neither_armed_nor_disarmed_is_denied) {
    EXPECT_EQ(command(MavCmd::component_arm_disarm, 0.5f), MavResult::denied);
    EXPECT_EQ(command(MavCmd::component_arm_disarm, NAN), MavResult::denied);
}

TEST_F(Telemetry, reboots_on_the_ground_after_answering) {
    EXPECT_EQ(command(MavCmd::preflight_reboot_shutdown, 1), MavResult::accepted);
    EXPECT_THROW(run_ms(1000), fakes::Rebooted);
}

TEST_F(Telemetry, does_not_reboot_armed) {
    firmware::vehicle.armed = true;
    EXPECT_EQ(command(MavCmd::preflight_reboot_shutdown, 1), MavResult::temporarily_rejected);
    EXPECT_NO_THROW(run_ms(1000));
}

TEST_F(Telemetry, gives_its_home_when_it_has_one) {
    EXPECT_EQ(command(MavCmd::get_home_position), MavResult::temporarily_rejected);
    firmware::vehicle.home.set = true;
    firmware::vehicle.home.position = {-353632610, 1491652300};
    firmware::vehicle.home.altitude_cm = 58412;

    EXPECT_EQ(command(MavCmd::get_home_position), MavResult::accepted);

    const auto homes = station.all<mavlink::HomePosition>();
    ASSERT_EQ(homes.size(), 1u);
    EXPECT_EQ(homes[0].latitude, -353632610);
    EXPECT_EQ(homes[0].altitude, 584120);
    EXPECT_EQ(command(MavCmd::request_message, 242), MavResult::accepted);
    EXPECT_EQ(station.all<mavlink::HomePosition>().size(), 1u);
}

TEST_F(Telemetry, home_is_set_to_the_last_digit_by_command_int) {
    mavlink::CommandInt message = {};
    message.target_system = message.target_component = 1;
    message.command = MavCmd::do_set_home;
    message.x = -353632611;
    message.y = 1491652303;
    message.z = 584.1f;
    EXPECT_EQ(ask<mavlink::CommandAck>(message).at(0).result, MavResult::accepted);
    EXPECT_EQ(*doubles::vehicle.home, (geo::Position{-353632611, 1491652303}));
    EXPECT_EQ(doubles::vehicle.home_altitude_cm, 58410);

    message.x = 910000000;
    EXPECT_EQ(ask<mavlink::CommandAck>(message).at(0).result, MavResult::denied);
    EXPECT_EQ(command(MavCmd::do_set_home, 0), MavResult::denied);  // no place given
    EXPECT_EQ(command(MavCmd::do_set_home, 1), MavResult::accepted);
    doubles::vehicle.home_can_be_set = false;
    EXPECT_EQ(command(MavCmd::do_set_home, 1), MavResult::temporarily_rejected);
}

TEST_F(Telemetry, describes_itself_in_every_way_it_can_be_asked) {
    EXPECT_EQ(command(MavCmd::request_autopilot_capabilities), MavResult::accepted);
    EXPECT_EQ(command(MavCmd::request_message, 148), MavResult::accepted);
    mavlink::AutopilotVersionRequest request = {};
    request.target_system = request.target_component = 1;
    station.send(request);
    run_ms(20);

    const auto versions = station.all<mavlink::AutopilotVersion>();
    ASSERT_EQ(versions.size(), 3u);
    using Can = mavlink::MavProtocolCapability;
    EXPECT_EQ(versions[0].capabilities, Can::mission_float | Can::mission_int | Can::param_float |
                                            Can::param_encode_c_cast | Can::command_int |
                                            Can::mavlink2);
    EXPECT_EQ(command(MavCmd::request_message, 9999), MavResult::unsupported);
    EXPECT_EQ(command(MavCmd::request_message, NAN), MavResult::unsupported);
}

TEST_F(Telemetry, the_current_item_is_set_by_command) {
    doubles::mission.items.resize(4);
    EXPECT_EQ(command(MavCmd::do_set_mission_current, 3), MavResult::accepted);
    EXPECT_EQ(station.all<mavlink::MissionCurrent>().at(0).seq, 3);
    EXPECT_EQ(command(MavCmd::do_set_mission_current, 4), MavResult::denied);
    EXPECT_EQ(command(MavCmd::do_set_mission_current, -1), MavResult::denied);
}

TEST_F(Telemetry, erases_its_storage_on_the_ground_only) {
    EXPECT_EQ(command(MavCmd::preflight_storage, 1), MavResult::accepted);  // nothing to do
    EXPECT_EQ(command(MavCmd::preflight_storage, 9), MavResult::unsupported);
    EXPECT_EQ(command(MavCmd::preflight_storage, 0, 2), MavResult::unsupported);
    firmware::vehicle.armed = true;
    EXPECT_EQ(command(MavCmd::preflight_storage, 2, 2), MavResult::temporarily_rejected);
    firmware::vehicle.armed = false;
    EXPECT_EQ(command(MavCmd::preflight_storage, 2, 2), MavResult::accepted);
    for (int i = 0; i < 1000; ++i) firmware::parametersRun();
    run_ms(100);
    EXPECT_EQ(station.texts().at(0), "Erased: restart the board");
}

TEST_F(Telemetry, calibrates_on_the_ground_only) {
    EXPECT_EQ(command(MavCmd::preflight_calibration, 1, 0, 0), MavResult::accepted);
    EXPECT_EQ(command(MavCmd::preflight_calibration, 0, 0, 1), MavResult::accepted);
    EXPECT_EQ(command(MavCmd::preflight_calibration, 0, 1, 0), MavResult::unsupported);
    firmware::vehicle.armed = true;
    EXPECT_EQ(command(MavCmd::preflight_calibration, 1, 0, 0), MavResult::temporarily_rejected);
    EXPECT_EQ(doubles::vehicle.gyro_calibrations, 1);
    EXPECT_EQ(doubles::vehicle.pressure_calibrations, 1);
}

}  // namespace
