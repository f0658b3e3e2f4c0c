// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "firmware/gcs/aux_switches.hpp"
#include "firmware/mission/speed.hpp"
#include "firmware/sensors/radio.hpp"
#include "ground.hpp"
#include "host_tests/support/fakes/io.hpp"
#include "host_tests/support/fakes/vehicle.hpp"

using firmware::state::Mode;
using ground::Telemetry;
using mavlink::MavCmd;
using mavlink::MavFrame;
using mavlink::MavResult;

namespace {

TEST_F(Telemetry, a_command_it_does_not_know_is_answered_unsupported) {
    for (const uint16_t id : {0, 23, 42, 30001}) EXPECT_EQ(command(id), MavResult::unsupported);
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
    EXPECT_EQ(firmware::state::vehicle.mode, Mode::rtl);
    EXPECT_EQ(command(MavCmd::do_set_mode, 209, 5), MavResult::accepted);  // other bits set too
    EXPECT_EQ(firmware::state::vehicle.mode, Mode::fbwa);
    EXPECT_EQ(command(MavCmd::do_set_mode, 220), MavResult::accepted);  // MAV_MODE_AUTO_ARMED
    EXPECT_EQ(firmware::state::vehicle.mode, Mode::automatic);
    EXPECT_EQ(command(MavCmd::do_set_mode, 64), MavResult::accepted);
    EXPECT_EQ(firmware::state::vehicle.mode, Mode::manual);
    EXPECT_EQ(command(MavCmd::nav_return_to_launch), MavResult::accepted);
    EXPECT_EQ(firmware::state::vehicle.mode, Mode::rtl);
    EXPECT_EQ(command(MavCmd::nav_loiter_unlim), MavResult::accepted);
    EXPECT_EQ(firmware::state::vehicle.mode, Mode::loiter);
    EXPECT_EQ(command(MavCmd::mission_start), MavResult::accepted);
    EXPECT_EQ(firmware::state::vehicle.mode, Mode::automatic);

    mavlink::SetMode message = {};
    message.target_system = 1;
    message.base_mode = 1;
    message.custom_mode = 2;
    const auto acks = ask<mavlink::CommandAck>(message);
    ASSERT_EQ(acks.size(), 1u);
    EXPECT_EQ(acks[0].command, 11);
    EXPECT_EQ(acks[0].result, MavResult::accepted);
    EXPECT_EQ(firmware::state::vehicle.mode, Mode::stabilize);
}

TEST_F(Telemetry, set_mode_in_mavlink_1_with_a_component_like_base_mode_is_understood) {
    mavlink::SetMode message = {};
    message.target_system = 1;
    message.base_mode = 217;  // stands where other messages have their component
    message.custom_mode = 10;
    EXPECT_EQ(ask<mavlink::CommandAck>(message).size(), 1u);
    EXPECT_EQ(firmware::state::vehicle.mode, Mode::automatic);
}

TEST_F(Telemetry, modes_are_set_by_what_they_are_on_every_vehicle) {
    const struct {
        float standard;
        Mode mode;
    } cases[] = {{3, Mode::cruise},
                 {4, Mode::fbwb},
                 {5, Mode::rtl},
                 {6, Mode::automatic},
                 {8, Mode::takeoff}};
    for (const auto& each : cases) {
        EXPECT_EQ(command(MavCmd::do_set_standard_mode, each.standard), MavResult::accepted);
        EXPECT_EQ(firmware::state::vehicle.mode, each.mode) << each.standard;
    }
    // not standard, position hold, orbit, land; nothing
    for (const float none : {0.0f, 1.0f, 2.0f, 7.0f, 9.0f, 255.0f, static_cast<float>(NAN)})
        EXPECT_EQ(command(MavCmd::do_set_standard_mode, none), MavResult::denied) << none;
    EXPECT_EQ(firmware::state::vehicle.mode, Mode::takeoff);
}

TEST_F(Telemetry, a_mode_that_does_not_exist_is_denied) {
    for (const float mode : {99.0f, 300.0f, -1.0f, static_cast<float>(NAN)})
        EXPECT_EQ(command(MavCmd::do_set_mode, 1, mode), MavResult::denied);
    EXPECT_TRUE(doubles::vehicle.modes.empty());
}

TEST_F(Telemetry, a_mode_that_cannot_be_entered_now_is_rejected_for_now) {
    doubles::vehicle.mode_can_be_entered = false;
    EXPECT_EQ(command(MavCmd::mission_start), MavResult::temporarily_rejected);
    EXPECT_EQ(firmware::state::vehicle.mode, Mode::manual);
}

TEST_F(Telemetry, arms_and_disarms) {
    EXPECT_EQ(command(MavCmd::component_arm_disarm, 1), MavResult::accepted);
    EXPECT_TRUE(firmware::state::vehicle.armed);
    EXPECT_FALSE(doubles::vehicle.force);
    EXPECT_EQ(command(MavCmd::component_arm_disarm, 0), MavResult::accepted);
    EXPECT_FALSE(firmware::state::vehicle.armed);
}

TEST_F(Telemetry, an_arming_that_fails_says_why) {
    doubles::vehicle.can_arm = false;

    EXPECT_EQ(command(MavCmd::component_arm_disarm, 1), MavResult::failed);

    EXPECT_FALSE(firmware::state::vehicle.armed);
    EXPECT_EQ(station.texts().at(0), "PreArm: no GPS fix");
    EXPECT_EQ(command(MavCmd::run_prearm_checks), MavResult::failed);
    EXPECT_EQ(station.texts().at(0), "PreArm: no GPS fix");
}

TEST_F(Telemetry, arming_is_forced_by_the_documented_number_only) {
    fakes::setUsb(true);
    run_ms(20);
    doubles::vehicle.can_arm = false;
    EXPECT_EQ(command(MavCmd::component_arm_disarm, 1, 1), MavResult::failed);
    EXPECT_EQ(command(MavCmd::component_arm_disarm, 1, 2989), MavResult::accepted);
    EXPECT_EQ(command(MavCmd::component_arm_disarm, 0, 21196), MavResult::accepted);
    EXPECT_TRUE(doubles::vehicle.force);
}

// A stranger with a radio ends no flight, and starts no motor past the checks.
TEST_F(Telemetry, force_is_refused_unless_it_comes_over_usb) {
    doubles::vehicle.can_arm = false;
    EXPECT_EQ(command(MavCmd::component_arm_disarm, 1, 2989), MavResult::denied);
    EXPECT_EQ(station.texts().at(0), "Force refused: only over USB");
    EXPECT_FALSE(firmware::state::vehicle.armed);
    firmware::state::mutable_vehicle.armed = true;
    EXPECT_EQ(command(MavCmd::component_arm_disarm, 0, 21196), MavResult::denied);
    EXPECT_TRUE(firmware::state::vehicle.armed);

    firmware::state::parameters.force_everywhere = 1;
    EXPECT_EQ(command(MavCmd::component_arm_disarm, 0, 21196), MavResult::accepted);
    EXPECT_FALSE(firmware::state::vehicle.armed);
}

TEST_F(Telemetry, usb_on_one_link_grants_nothing_to_the_other) {
    fakes::setUsb(true);
    run_ms(20);
    firmware::state::mutable_vehicle.armed = true;
    mavlink::CommandLong message = {};
    message.target_system = message.target_component = 1;
    message.command = MavCmd::component_arm_disarm;
    message.param2 = 21196;
    second.send(message);
    run_ms(40);
    EXPECT_EQ(second.all<mavlink::CommandAck>().at(0).result, MavResult::denied);
    EXPECT_TRUE(firmware::state::vehicle.armed);
}

TEST_F(Telemetry, restarts_armed_by_the_documented_number_over_usb_alone) {
    firmware::state::mutable_vehicle.armed = true;
    constexpr float kWhateverHappens = 20190226;
    const auto forced = [this] {
        return command(MavCmd::preflight_reboot_shutdown, 1, 0, 0, 0, 0, kWhateverHappens);
    };
    EXPECT_EQ(forced(), MavResult::denied);
    EXPECT_NO_THROW(run_ms(1000));
    fakes::setUsb(true);
    run_ms(20);
    EXPECT_EQ(forced(), MavResult::accepted);
    EXPECT_THROW(run_ms(1000), fakes::Rebooted);
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
    firmware::state::mutable_vehicle.armed = true;
    EXPECT_EQ(command(MavCmd::preflight_reboot_shutdown, 1), MavResult::temporarily_rejected);
    EXPECT_NO_THROW(run_ms(1000));
}

TEST_F(Telemetry, gives_its_home_when_it_has_one) {
    EXPECT_EQ(command(MavCmd::get_home_position), MavResult::temporarily_rejected);
    firmware::state::mutable_vehicle.home.set = true;
    firmware::state::mutable_vehicle.home.position = {-353632610, 1491652300};
    firmware::state::mutable_vehicle.home.altitude_cm = 58412;

    EXPECT_EQ(command(MavCmd::get_home_position), MavResult::accepted);

    const auto homes = station.all<mavlink::HomePosition>();
    ASSERT_EQ(homes.size(), 1u);
    EXPECT_EQ(homes[0].latitude, -353632610);
    EXPECT_EQ(homes[0].altitude, 584120);
    EXPECT_EQ(command(MavCmd::request_message, 242), MavResult::accepted);
    EXPECT_EQ(station.all<mavlink::HomePosition>().size(), 1u);
}

mavlink::CommandInt commandInt(uint16_t id, uint8_t frame, int32_t x, int32_t y, float z) {
    mavlink::CommandInt message = {};
    message.target_system = message.target_component = 1;
    message.command = id;
    message.frame = frame;
    message.x = x;
    message.y = y;
    message.z = z;
    return message;
}

TEST_F(Telemetry, home_is_set_to_the_last_digit_by_command_int) {
    auto message =
        commandInt(MavCmd::do_set_home, MavFrame::global, -353632611, 1491652303, 584.1f);
    EXPECT_EQ(ask<mavlink::CommandAck>(message).at(0).result, MavResult::accepted);
    const auto& act = doubles::plan.acts.at(0);
    EXPECT_EQ(act.command, MavCmd::do_set_home);
    EXPECT_EQ(act.x, -353632611);
    EXPECT_EQ(act.y, 1491652303);
    EXPECT_EQ(act.z, 584.1f);

    message.frame = MavFrame::global_relative_alt;
    message.z = 10;
    EXPECT_EQ(ask<mavlink::CommandAck>(message).at(0).result, MavResult::temporarily_rejected)
        << "relative to no home";
    firmware::state::mutable_vehicle.home.set = true;
    firmware::state::mutable_vehicle.home.altitude_cm = 58400;
    EXPECT_EQ(ask<mavlink::CommandAck>(message).at(0).result, MavResult::accepted);
    EXPECT_EQ(doubles::plan.acts.at(1).z, 594);
    EXPECT_EQ(doubles::plan.acts.at(1).frame, MavFrame::global);
}

TEST_F(Telemetry, home_is_set_here_or_not_without_a_place) {
    EXPECT_EQ(command(MavCmd::do_set_home, 0), MavResult::denied);
    EXPECT_TRUE(doubles::plan.acts.empty());
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
    EXPECT_EQ(versions[0].capabilities,
              Can::mission_float | Can::mission_int | Can::mission_fence | Can::mission_rally |
                  Can::param_float | Can::param_encode_c_cast | Can::command_int | Can::mavlink2 |
                  Can::ftp | Can::set_position_target_global_int | Can::compass_calibration);
    EXPECT_EQ(versions[0].vendor_id, 0x1E);
    EXPECT_EQ(versions[0].product_id, 0x9801);
    EXPECT_NE(versions[0].board_version, 0u);
    EXPECT_EQ(versions[0].uid, 0u);
    EXPECT_EQ(command(MavCmd::request_message, 9999), MavResult::unsupported);
    EXPECT_EQ(command(MavCmd::request_message, NAN), MavResult::unsupported);
}

TEST_F(Telemetry, the_current_item_is_set_by_command) {
    doubles::plan.items.resize(4);
    EXPECT_EQ(command(MavCmd::do_set_mission_current, 3), MavResult::accepted);
    EXPECT_EQ(station.all<mavlink::MissionCurrent>().at(0).seq, 3);
    EXPECT_EQ(command(MavCmd::do_set_mission_current, 4), MavResult::denied);
    EXPECT_EQ(command(MavCmd::do_set_mission_current, -2), MavResult::denied);
}

TEST_F(Telemetry, erases_its_storage_on_the_ground_only) {
    EXPECT_EQ(command(MavCmd::preflight_storage, 1), MavResult::accepted);  // nothing to do
    EXPECT_EQ(command(MavCmd::preflight_storage, 9), MavResult::unsupported);
    EXPECT_EQ(command(MavCmd::preflight_storage, 0, 2), MavResult::unsupported);
    firmware::state::mutable_vehicle.armed = true;
    EXPECT_EQ(command(MavCmd::preflight_storage, 2, 2), MavResult::temporarily_rejected);
    firmware::state::mutable_vehicle.armed = false;
    EXPECT_EQ(command(MavCmd::preflight_storage, 2, 2), MavResult::accepted);
    for (int i = 0; i < 1000; ++i) firmware::state::parametersRun();
    run_ms(100);
    EXPECT_EQ(station.texts().at(0), "Erased: restart the board");
}

// ---- every row of the table, and what it answers to parameters it cannot have

struct Case {
    const char* what;
    uint16_t command;
    std::vector<float> params;
    uint8_t result;
};
const float kNan = NAN;
const Case kCases[] = {
    {"a part of a mission", MavCmd::mission_start, {2, 5}, MavResult::denied},
    {"no parts given", MavCmd::mission_start, {kNan, kNan}, MavResult::accepted},
    {"a mode and a half", MavCmd::do_set_mode, {1, 5.5f}, MavResult::denied},
    {"no base mode", MavCmd::do_set_mode, {kNan, 5}, MavResult::denied},
    {"no such item", MavCmd::do_set_mission_current, {kNan}, MavResult::denied},
    {"half an item", MavCmd::do_set_mission_current, {0.5f}, MavResult::denied},
    {"too large a frame", MavCmd::do_change_altitude, {50, 256}, MavResult::denied},
    {"no frame", MavCmd::do_change_altitude, {50, kNan}, MavResult::denied},
    {"faster than anything", MavCmd::do_reposition, {1000, 1}, MavResult::denied},
    {"some other side", MavCmd::preflight_calibration, {0, 0, 0, 0, 3}, MavResult::unsupported},
    {"gyros and six sides", MavCmd::preflight_calibration, {1, 0, 0, 0, 1}, MavResult::unsupported},
    {"temperature", MavCmd::preflight_calibration, {3}, MavResult::unsupported},
    {"the motor's compass",
     MavCmd::preflight_calibration,
     {0, 0, 0, 0, 0, 1},
     MavResult::unsupported},
    {"nothing at all", MavCmd::preflight_calibration, {}, MavResult::unsupported},
    {"another sensor's offsets",
     MavCmd::preflight_set_sensor_offsets,
     {0, 1, 2, 3},
     MavResult::unsupported},
    {"offsets too large",
     MavCmd::preflight_set_sensor_offsets,
     {2, 10, 401, 30},
     MavResult::failed},
    {"no offsets", MavCmd::preflight_set_sensor_offsets, {2, kNan, 1, 2}, MavResult::failed},
    {"no storage action", MavCmd::preflight_storage, {kNan}, MavResult::unsupported},
    {"shut down", MavCmd::preflight_reboot_shutdown, {2}, MavResult::denied},
    {"do nothing", MavCmd::preflight_reboot_shutdown, {0}, MavResult::accepted},
    {"restart what", MavCmd::preflight_reboot_shutdown, {kNan}, MavResult::denied},
    {"an interval of nothing", MavCmd::set_message_interval, {30, kNan}, MavResult::denied},
    {"an interval of no message", MavCmd::get_message_interval, {-1}, MavResult::denied},
    {"to land on the ground", MavCmd::nav_land, {}, MavResult::temporarily_rejected},
    {"a parachute", 208, {2}, MavResult::unsupported},
    {"a go-around of nothing", MavCmd::do_go_around, {30}, MavResult::temporarily_rejected},
    {"a landing on the ground", MavCmd::do_land_start, {}, MavResult::temporarily_rejected},
    {"a jump outside of a mission", MavCmd::do_jump, {1, 2}, MavResult::unsupported},
    {"a parameter by its slot", MavCmd::do_set_parameter, {87, 4000}, MavResult::unsupported},
};

TEST_F(Telemetry, what_cannot_be_had_is_answered_and_changes_nothing) {
    const firmware::state::Parameters before = firmware::state::parameters;
    for (const Case& c : kCases) {
        float p[7] = {};
        std::copy(c.params.begin(), c.params.end(), p);
        EXPECT_EQ(command(c.command, p[0], p[1], p[2], p[3], p[4], p[5], p[6]), c.result) << c.what;
    }
    EXPECT_EQ(memcmp(&before, &firmware::state::parameters, sizeof before), 0);
    EXPECT_EQ(doubles::vehicle.gyro_calibrations, 0);
    EXPECT_NO_THROW(run_ms(1000));
}

TEST_F(Telemetry, what_a_mission_does_at_once_is_done_on_command) {
    for (const uint16_t id : {MavCmd::do_set_relay, MavCmd::do_repeat_relay, MavCmd::do_set_servo,
                              MavCmd::do_repeat_servo, MavCmd::do_change_speed}) {
        EXPECT_EQ(command(id, 0, 1500, 3, 4), MavResult::accepted);
        const auto& act = doubles::plan.acts.back();
        EXPECT_EQ(act.command, id);
        EXPECT_EQ(act.frame, MavFrame::mission);
        EXPECT_EQ(act.param1, 0);
        EXPECT_EQ(act.param2, 1500);
        EXPECT_EQ(act.param3, 3);
        EXPECT_EQ(act.param4, 4);
    }
    doubles::plan.answer = firmware::mission::MissionResult::invalid_param1;
    EXPECT_EQ(command(MavCmd::do_set_servo, 3, 1500), MavResult::denied);
}

TEST_F(Telemetry, starts_the_landing_of_the_mission_and_aborts_it) {
    firmware::state::mutable_vehicle.estimate.flying = true;
    EXPECT_EQ(command(MavCmd::do_land_start), MavResult::denied) << "the mission has none";
    EXPECT_EQ(command(MavCmd::nav_land), MavResult::denied);
    doubles::plan.land_start = doubles::plan.landing = true;
    EXPECT_EQ(command(MavCmd::do_land_start), MavResult::accepted);
    EXPECT_EQ(command(MavCmd::do_go_around, 45), MavResult::accepted);
    EXPECT_EQ(doubles::plan.around_m, std::vector<float>{45});
}

TEST_F(Telemetry, takes_pictures_on_command) {
    EXPECT_EQ(command(MavCmd::do_digicam_control, 0, 0, 0, 0, 1), MavResult::accepted);
    EXPECT_EQ(command(MavCmd::do_set_cam_trigg_dist, 12.5f), MavResult::accepted);
    ASSERT_EQ(doubles::plan.acts.size(), 2u);
    EXPECT_EQ(doubles::plan.acts[1].param1, 12.5f);
}

TEST_F(Telemetry, a_ground_speed_is_taken_only_by_who_follows_one) {
    EXPECT_EQ(command(MavCmd::do_change_speed, 1, 15), MavResult::temporarily_rejected);
    firmware::state::mutable_vehicle.mode = Mode::guided;
    EXPECT_EQ(command(MavCmd::do_change_speed, 1, 15), MavResult::accepted);
}

TEST_F(Telemetry, guides_to_a_place_to_the_last_digit) {
    auto message = commandInt(MavCmd::do_reposition, MavFrame::global_relative_alt_int, 473977001,
                              85456003, 70);
    message.param1 = -1;
    message.param3 = 80;
    message.param4 = 1;
    EXPECT_EQ(ask<mavlink::CommandAck>(message).at(0).result, MavResult::temporarily_rejected)
        << "not in GUIDED, and not asked to enter it";
    message.param2 = 1;
    EXPECT_EQ(ask<mavlink::CommandAck>(message).at(0).result, MavResult::accepted);
    const auto& target = doubles::vehicle.targets.at(0);
    EXPECT_EQ(target.command, MavCmd::nav_waypoint);
    EXPECT_EQ(target.frame, MavFrame::global_relative_alt_int);
    EXPECT_EQ(target.x, 473977001);
    EXPECT_EQ(target.y, 85456003);
    EXPECT_EQ(target.z, 70);
    EXPECT_EQ(target.param3, 80);
    EXPECT_EQ(target.param4, 1);

    firmware::state::mutable_vehicle.mode = Mode::guided;
    message.param2 = 0;
    EXPECT_EQ(ask<mavlink::CommandAck>(message).at(0).result, MavResult::accepted);
    doubles::plan.answer = firmware::mission::MissionResult::unsupported_frame;
    EXPECT_EQ(ask<mavlink::CommandAck>(message).at(0).result,
              MavResult::command_unsupported_mav_frame);
    doubles::plan.answer = firmware::mission::MissionResult::error;
    EXPECT_EQ(ask<mavlink::CommandAck>(message).at(0).result, MavResult::temporarily_rejected);
}

TEST_F(Telemetry, a_missing_position_is_distinguished_from_an_invalid_one) {
    EXPECT_EQ(command(MavCmd::do_reposition, -1, 1, 0, 0, kNan, kNan, kNan), MavResult::accepted);
    EXPECT_EQ(doubles::vehicle.targets.at(0).x, INT32_MAX);
    EXPECT_TRUE(std::isnan(doubles::vehicle.targets.at(0).z));
    EXPECT_EQ(command(MavCmd::do_reposition, -1, 1, 0, 0, 500, 500, 50), MavResult::accepted);
    EXPECT_EQ(doubles::vehicle.targets.at(1).x, INT32_MIN);  // which no range holds
    EXPECT_EQ(command(MavCmd::do_reposition, -1, 1, 0, 0, 47.5f, 8.5f, 50), MavResult::accepted);
    EXPECT_EQ(doubles::vehicle.targets.at(2).x, 475000000);
    EXPECT_EQ(doubles::vehicle.targets.at(2).frame, MavFrame::global);
}

TEST_F(Telemetry, a_mission_item_that_is_an_order_for_guided_is_acknowledged_as_an_item) {
    mavlink::MissionItemInt item = {};
    item.target_system = item.target_component = 1;
    item.command = MavCmd::nav_waypoint;
    item.frame = MavFrame::global_relative_alt;
    item.current = 2;
    item.param3 = 15;  // of a waypoint: how far beside it to pass, no radius
    item.x = 473977001;
    item.y = 85456003;
    item.z = 70;
    EXPECT_EQ(ask<mavlink::MissionAck>(item).at(0).type, 0);
    EXPECT_EQ(doubles::vehicle.targets.at(0).x, 473977001);
    EXPECT_EQ(doubles::vehicle.targets.at(0).param3, 0);
    item.current = 3;
    EXPECT_EQ(ask<mavlink::MissionAck>(item).at(0).type, 0);
    EXPECT_EQ(doubles::vehicle.heights.at(0).z, 70);
    doubles::plan.answer = firmware::mission::MissionResult::unsupported_frame;
    EXPECT_EQ(ask<mavlink::MissionAck>(item).at(0).type, 2);
    item.current = 4;
    EXPECT_EQ(ask<mavlink::MissionAck>(item).at(0).type, 3);
}

TEST_F(Telemetry, changes_height_and_speed_by_the_orders_for_guided) {
    EXPECT_EQ(command(MavCmd::guided_change_altitude, 0, 0, 0, 0, 0, 0, 90),
              MavResult::temporarily_rejected);
    EXPECT_EQ(command(MavCmd::guided_change_speed, 0, 14), MavResult::temporarily_rejected);
    firmware::state::mutable_vehicle.mode = Mode::guided;
    EXPECT_EQ(command(MavCmd::guided_change_altitude, 0, 0, 0, 0, 0, 0, 90), MavResult::accepted);
    EXPECT_EQ(doubles::vehicle.heights.at(0).z, 90);
    EXPECT_EQ(doubles::vehicle.heights.at(0).command, +MavCmd::nav_waypoint);
    EXPECT_EQ(command(MavCmd::guided_change_speed, 0, 14, 2.5f), MavResult::accepted);
    EXPECT_EQ(doubles::plan.acts.at(0).command, +MavCmd::do_change_speed);
    EXPECT_EQ(doubles::plan.acts.at(0).param2, 14);
    EXPECT_EQ(doubles::plan.acts.at(0).param3, -1) << "an acceleration is no throttle";
}

TEST_F(Telemetry, a_take_off_is_above_home_but_in_a_frame_that_was_given) {
    EXPECT_EQ(command(MavCmd::nav_takeoff, 12, 0, 0, 0, 0, 0, 50), MavResult::accepted);
    EXPECT_EQ(doubles::vehicle.takeoffs.at(0).z, 50);
    EXPECT_EQ(doubles::vehicle.takeoffs.at(0).param1, 12);
    EXPECT_EQ(doubles::vehicle.takeoffs.at(0).frame, +MavFrame::global_relative_alt);
    mavlink::CommandInt message = {};
    message.command = MavCmd::nav_takeoff;
    message.frame = MavFrame::global;
    message.z = 450;
    message.target_system = message.target_component = 1;
    EXPECT_EQ(ask<mavlink::CommandAck>(message).at(0).result, MavResult::accepted);
    EXPECT_EQ(doubles::vehicle.takeoffs.at(1).z, 450);
    EXPECT_EQ(doubles::vehicle.takeoffs.at(1).frame, +MavFrame::global);
    doubles::plan.answer = firmware::mission::MissionResult::error;
    EXPECT_EQ(command(MavCmd::nav_takeoff), MavResult::temporarily_rejected);
}

TEST_F(Telemetry, an_auxiliary_function_enters_a_mode_and_gives_it_back_to_the_switch) {
    constexpr float kLow = 0, kMiddle = 1, kHigh = 2;
    struct {
        float function;
        Mode mode;
    } const kAll[] = {{4, Mode::rtl},        {16, Mode::automatic}, {51, Mode::manual},
                      {52, Mode::acro},      {55, Mode::guided},    {56, Mode::loiter},
                      {68, Mode::stabilize}, {72, Mode::circle},    {77, Mode::takeoff},
                      {92, Mode::fbwa},      {150, Mode::cruise}};
    int resets = 0;
    for (const auto& [function, mode] : kAll) {
        firmware::state::mutable_vehicle.mode = Mode::training;
        for (const float position : {kLow, kMiddle})
            EXPECT_EQ(command(MavCmd::do_aux_function, function, position), MavResult::accepted);
        EXPECT_EQ(firmware::state::vehicle.mode, Mode::training) << function;
        EXPECT_EQ(doubles::vehicle.switch_resets, resets) << "it flew another mode";
        EXPECT_EQ(command(MavCmd::do_aux_function, function, kHigh), MavResult::accepted);
        EXPECT_EQ(firmware::state::vehicle.mode, mode) << function;
        EXPECT_EQ(command(MavCmd::do_aux_function, function, kLow), MavResult::accepted);
        EXPECT_EQ(doubles::vehicle.switch_resets, ++resets);
    }
    doubles::vehicle.mode_can_be_entered = false;
    EXPECT_EQ(command(MavCmd::do_aux_function, 4, kHigh), MavResult::temporarily_rejected);
    for (const float position : {-1.0f, 3.0f, NAN})
        EXPECT_EQ(command(MavCmd::do_aux_function, 4, position), MavResult::denied) << position;
    for (const float function : {0.0f, 2.0f, 300.0f, NAN})
        EXPECT_EQ(command(MavCmd::do_aux_function, function, kHigh), MavResult::unsupported);
}

TEST_F(Telemetry, an_auxiliary_function_does_what_its_command_does) {
    struct {
        float function, position;
        uint16_t command;
        float param1, param2;
    } const kAll[] = {{9, 2, MavCmd::do_digicam_control, 1, 0},
                      {28, 2, MavCmd::do_set_relay, 0, 1},
                      {28, 0, MavCmd::do_set_relay, 0, 0},
                      {43, 2, MavCmd::do_inverted_flight, 1, 0},
                      {43, 0, MavCmd::do_inverted_flight, 0, 0}};
    for (const auto& each : kAll) {
        EXPECT_EQ(command(MavCmd::do_aux_function, each.function, each.position),
                  MavResult::accepted);
        const auto& act = doubles::plan.acts.back();
        EXPECT_EQ(act.command, each.command) << each.function;
        EXPECT_EQ(act.param1, each.param1) << each.function;
        EXPECT_EQ(act.param2, each.param2) << each.function;
    }
    EXPECT_EQ(command(MavCmd::do_aux_function, 9, 0), MavResult::accepted);
    EXPECT_EQ(command(MavCmd::do_aux_function, 28, 1), MavResult::accepted);
    EXPECT_EQ(doubles::plan.acts.size(), std::size(kAll)) << "nothing to be done there";

    EXPECT_EQ(command(MavCmd::do_aux_function, 153, 2), MavResult::accepted);
    EXPECT_TRUE(firmware::state::vehicle.armed);
    EXPECT_FALSE(doubles::vehicle.force);
    EXPECT_EQ(command(MavCmd::do_aux_function, 153, 0), MavResult::accepted);
    EXPECT_FALSE(firmware::state::vehicle.armed);
}

// ---- the same by switches of the transmitter

struct AuxSwitches : Telemetry {
    static constexpr int kLost = 0, kLow = 1, kMiddle = 2, kHigh = 3;
    std::vector<uint16_t> pulses_us = std::vector<uint16_t>(8, 1100);

    void SetUp() override {
        Telemetry::SetUp();
        mutable_vehicle.mode = Mode::training;
        firmware::gcs::runAuxSwitches();  // nothing was received yet
    }
    void receive() {
        for (int i = 0; i < 3; ++i) {
            fakes::receiveRc(pulses_us);
            for (int run = 0; run < 2; ++run) {  // switches are read between two frames
                firmware::sensors::runRadio();
                fakes::advance_ms(10);
            }
        }
        firmware::gcs::runAuxSwitches();
    }
    void move(int channel, int position) {
        constexpr uint16_t kPulses_us[] = {0, 1200, 1500, 1800};
        mutable_vehicle.radio.lost = position == kLost;
        if (position == kLost) return firmware::gcs::runAuxSwitches();
        pulses_us[channel - 1] = kPulses_us[position];
        receive();
    }
};

TEST_F(AuxSwitches, enter_a_mode_for_the_pilot_and_give_it_back_to_the_mode_switch) {
    parameters.switch_option[1] = 4;
    receive();
    move(6, kMiddle);
    EXPECT_TRUE(doubles::vehicle.modes.empty());
    move(6, kHigh);
    ASSERT_EQ(doubles::vehicle.modes.size(), 1u);
    EXPECT_EQ(doubles::vehicle.modes[0], std::pair(Mode::rtl, firmware::state::ModeReason::pilot));
    for (int i = 0; i < 3; ++i) firmware::gcs::runAuxSwitches();
    EXPECT_EQ(doubles::vehicle.modes.size(), 1u) << "once for each move";
    move(6, kLow);
    EXPECT_EQ(doubles::vehicle.switch_resets, 1);
}

TEST_F(AuxSwitches, have_a_function_each) {
    const uint16_t kCommands[] = {MavCmd::do_inverted_flight, MavCmd::do_digicam_control};
    parameters.switch_option[0] = 43, parameters.switch_option[3] = 9;
    receive();
    size_t done = 0;
    for (const int channel : {5, 8}) {
        move(channel, kHigh);
        ASSERT_EQ(doubles::plan.acts.size(), done + 1);
        EXPECT_EQ(doubles::plan.acts.back().command, kCommands[done++]);
    }
    for (const int channel : {1, 4, 6, 7}) move(channel, kHigh);
    EXPECT_EQ(doubles::plan.acts.size(), 2u);
}

TEST_F(AuxSwitches, do_nothing_where_they_stand_when_they_are_first_received) {
    parameters.switch_option[0] = 4;
    move(5, kHigh);
    EXPECT_TRUE(doubles::vehicle.modes.empty());
    move(5, kLow);
    move(5, kHigh);
    EXPECT_EQ(doubles::vehicle.modes.size(), 1u);
}

TEST_F(AuxSwitches, do_nothing_when_the_radio_comes_back_with_them_where_they_were) {
    parameters.switch_option[1] = 4;
    for (const int position : {kLow, kLost, kLow, kLost, kLow}) move(6, position);
    EXPECT_EQ(doubles::vehicle.switch_resets, 0);
    move(6, kLost);
    move(6, kHigh);
    EXPECT_EQ(doubles::vehicle.modes.size(), 1u) << "moved meanwhile";
}

TEST_F(AuxSwitches, do_nothing_when_they_are_given_a_function) {
    move(6, kHigh);
    parameters.switch_option[1] = 4;
    for (int i = 0; i < 3; ++i) firmware::gcs::runAuxSwitches();
    EXPECT_TRUE(doubles::vehicle.modes.empty());
}

TEST_F(AuxSwitches, arm_without_force_and_disarm) {
    parameters.switch_option[1] = 153;
    receive();
    move(6, kHigh);
    EXPECT_TRUE(firmware::state::vehicle.armed);
    EXPECT_FALSE(doubles::vehicle.force);
    move(6, kLow);
    EXPECT_FALSE(firmware::state::vehicle.armed);
}

TEST_F(Telemetry, guided_is_sent_along_a_course_over_the_ground) {
    for (const float course_deg : {0.0f, 90.0f, 359.5f, 360.0f}) {
        EXPECT_EQ(command(MavCmd::guided_change_heading, 0, course_deg), MavResult::accepted);
        EXPECT_NEAR(doubles::vehicle.courses_rad.back(), core::radians(course_deg), 1e-5);
    }
    for (const float wrong : {-1.0f, 361.0f, NAN})
        EXPECT_EQ(command(MavCmd::guided_change_heading, 0, wrong), MavResult::denied) << wrong;
    EXPECT_EQ(command(MavCmd::guided_change_heading, 1, 90), MavResult::denied) << "a heading";
    EXPECT_EQ(doubles::vehicle.courses_rad.size(), 4u);
    doubles::plan.answer = firmware::mission::MissionResult::error;
    EXPECT_EQ(command(MavCmd::guided_change_heading, 0, 90), MavResult::temporarily_rejected);
}

TEST_F(Telemetry, a_flight_is_terminated_where_the_owner_allows_it) {
    firmware::state::parameters.termination_action = 0;
    EXPECT_EQ(command(MavCmd::do_flighttermination, 1), MavResult::denied);
    firmware::state::parameters.termination_action = 42;
    for (const float param1 : {0.0f, 2.0f, NAN}) {
        EXPECT_EQ(command(MavCmd::do_flighttermination, param1), MavResult::denied) << param1;
        EXPECT_FALSE(firmware::state::vehicle.terminated);
    }
    EXPECT_EQ(command(MavCmd::do_flighttermination, 1), MavResult::accepted);
    run_ms(1100);
    EXPECT_EQ(station.all<mavlink::Heartbeat>().back().system_status,
              +mavlink::MavState::flight_termination);
}

TEST_F(Telemetry, autotune_begins_and_ends_by_command) {
    EXPECT_EQ(command(MavCmd::do_autotune_enable, 0), MavResult::accepted);
    EXPECT_EQ(firmware::state::vehicle.mode, Mode::manual);
    EXPECT_EQ(command(MavCmd::do_autotune_enable, 1), MavResult::accepted);
    EXPECT_EQ(firmware::state::vehicle.mode, Mode::autotune);
    EXPECT_EQ(command(MavCmd::do_autotune_enable, 0), MavResult::accepted);
    EXPECT_EQ(firmware::state::vehicle.mode, Mode::fbwa);
}

TEST_F(Telemetry, the_banner_is_sent_when_asked_for) {
    run_ms(100);
    station.forget();
    EXPECT_EQ(command(MavCmd::do_send_banner), MavResult::accepted);
    run_ms(40);
    EXPECT_EQ(station.texts(), std::vector<std::string>{"ArduPilotMega autopilot, airplane"});
}

TEST_F(Telemetry, changes_the_height_alone) {
    EXPECT_EQ(command(MavCmd::do_change_altitude, 120, 3), MavResult::accepted);
    EXPECT_EQ(doubles::vehicle.heights.at(0).z, 120);
    EXPECT_EQ(doubles::vehicle.heights.at(0).frame, MavFrame::global_relative_alt);
    EXPECT_EQ(doubles::vehicle.heights.at(0).command, MavCmd::nav_waypoint);
}

TEST_F(Telemetry, a_mission_begins_anew_when_asked_to) {
    doubles::plan.items.resize(4);
    doubles::plan.current = 2;
    EXPECT_EQ(command(MavCmd::do_set_mission_current, 3, 1), MavResult::accepted);
    EXPECT_EQ(doubles::plan.restarts, 1);
    EXPECT_EQ(doubles::plan.current, 3);
    EXPECT_EQ(command(MavCmd::do_set_mission_current, -1, 1), MavResult::accepted);
    EXPECT_EQ(doubles::plan.restarts, 2);
    EXPECT_EQ(doubles::plan.current, 3);
    EXPECT_EQ(command(MavCmd::do_set_mission_current, 9, 1), MavResult::denied);
    EXPECT_EQ(doubles::plan.restarts, 2);
}

TEST_F(Telemetry, restarts_for_the_bootloader_as_well) {
    EXPECT_EQ(command(MavCmd::preflight_reboot_shutdown, 3), MavResult::accepted);
    EXPECT_THROW(run_ms(1000), fakes::Rebooted);
}

TEST_F(Telemetry, calibrates_on_the_ground_only) {
    firmware::state::mutable_vehicle.armed = true;
    EXPECT_EQ(command(MavCmd::preflight_calibration, 1), MavResult::temporarily_rejected);
    firmware::state::mutable_vehicle.estimate.flying = true;
    EXPECT_EQ(command(MavCmd::preflight_calibration, 1), MavResult::denied);
    EXPECT_EQ(command(MavCmd::preflight_calibration, 0, 0, 0, 0, 2), MavResult::denied);
    EXPECT_EQ(doubles::vehicle.gyro_calibrations, 0);
}

TEST_F(Telemetry, a_calibration_is_in_progress_until_it_is_done) {
    station.framing = ground::Framing::v2;
    EXPECT_EQ(command(MavCmd::preflight_calibration, 1, 0, 1), MavResult::in_progress);
    EXPECT_EQ(doubles::vehicle.gyro_calibrations, 1);
    EXPECT_EQ(doubles::vehicle.pressure_calibrations, 1);
    run_ms(3000);
    EXPECT_GE(station.all<mavlink::CommandAck>().size(), 2u) << "still at it, once a second";
    EXPECT_EQ(command(MavCmd::preflight_calibration, 1, 0, 1), MavResult::in_progress);
    EXPECT_EQ(doubles::vehicle.gyro_calibrations, 1) << "asked again, not begun again";

    firmware::state::mutable_vehicle.imu.calibrated = true;
    firmware::state::mutable_vehicle.baro.ground_pressure_pa = 95000;
    run_ms(40);
    const auto acks = station.all<mavlink::CommandAck>();
    ASSERT_EQ(acks.size(), 1u);
    EXPECT_EQ(acks[0].command, MavCmd::preflight_calibration);
    EXPECT_EQ(acks[0].result, MavResult::accepted);
    EXPECT_EQ(acks[0].target_system, 255);
    EXPECT_EQ(acks[0].target_component, 190);
    run_ms(3000);
    EXPECT_TRUE(station.all<mavlink::CommandAck>().empty());
    EXPECT_TRUE(second.all<mavlink::CommandAck>().empty());
}

TEST_F(Telemetry, a_calibration_that_never_ends_has_failed) {
    EXPECT_EQ(command(MavCmd::preflight_calibration, 1), MavResult::in_progress);
    run_ms(32000);
    const auto acks = station.all<mavlink::CommandAck>();
    ASSERT_GE(acks.size(), 20u);
    EXPECT_EQ(acks.back().result, MavResult::failed);
    run_ms(3000);
    EXPECT_TRUE(station.all<mavlink::CommandAck>().empty());
}

TEST_F(Telemetry, the_sticks_and_the_board_find_their_middle) {
    using firmware::state::mutable_vehicle;
    EXPECT_EQ(command(MavCmd::preflight_calibration, 0, 0, 0, 1), MavResult::failed) << "no radio";
    mutable_vehicle.radio.heard = true;
    mutable_vehicle.radio.pulse_us[0] = 1512;
    mutable_vehicle.radio.pulse_us[1] = 1488;
    mutable_vehicle.radio.pulse_us[2] = 1100;
    mutable_vehicle.radio.pulse_us[3] = 1503;
    EXPECT_EQ(command(MavCmd::preflight_calibration, 0, 0, 0, 1), MavResult::accepted);
    EXPECT_EQ(firmware::state::parameters.channel[0].trim_us, 1512);
    EXPECT_EQ(firmware::state::parameters.channel[1].trim_us, 1488);
    EXPECT_EQ(firmware::state::parameters.channel[2].trim_us, 1500);
    EXPECT_EQ(firmware::state::parameters.channel[3].trim_us, 1503);

    mutable_vehicle.attitude.roll_rad = core::Angle(0.02f);
    mutable_vehicle.attitude.pitch_rad = core::Angle(-0.03f);
    EXPECT_EQ(command(MavCmd::preflight_calibration, 0, 0, 0, 0, 2), MavResult::failed)
        << "not aligned";
    mutable_vehicle.attitude.aligned = true;
    firmware::state::parameters.level_trim_rad[0] = 0.01f;
    EXPECT_EQ(command(MavCmd::preflight_calibration, 0, 0, 0, 0, 2), MavResult::accepted);
    EXPECT_NEAR(firmware::state::parameters.level_trim_rad[0], 0.03f, 1e-4);
    EXPECT_NEAR(firmware::state::parameters.level_trim_rad[1], -0.03f, 1e-4);
    mutable_vehicle.attitude.roll_rad = core::Angle(0.5f);
    EXPECT_EQ(command(MavCmd::preflight_calibration, 0, 0, 0, 0, 2), MavResult::failed);
    EXPECT_NEAR(firmware::state::parameters.level_trim_rad[0], 0.03f, 1e-4);
}

TEST_F(Telemetry, the_compass_is_given_its_offsets) {
    EXPECT_EQ(command(MavCmd::preflight_set_sensor_offsets, 2, 10, -20, 30), MavResult::accepted);
    EXPECT_EQ(firmware::state::parameters.compass.offset_mg[0], 10);
    EXPECT_EQ(firmware::state::parameters.compass.offset_mg[1], -20);
    EXPECT_EQ(firmware::state::parameters.compass.offset_mg[2], 30);
}

}  // namespace
