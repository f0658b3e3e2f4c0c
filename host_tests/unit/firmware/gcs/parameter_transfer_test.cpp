// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/gcs/parameter_transfer.hpp"

#include <cmath>

#include "firmware/gcs/link.hpp"
#include "ground.hpp"
#include "host_tests/support/fakes/vehicle.hpp"
#include "storage/owner.hpp"

using ground::Telemetry;

namespace {

// What the list of all parameters takes alone at 57,600 baud, by MAVLink 1.
uint32_t listWire_ms() { return firmware::state::parameterCount() * 33u * 10u * 1000u / 57600u; }

std::string nameOf(const mavlink::ParamValue& value) {
    return std::string(value.param_id, strnlen(value.param_id, sizeof value.param_id));
}

template <class Message>
Message named(const std::string& name) {
    Message message = {};
    message.target_system = message.target_component = 1;
    memcpy(message.param_id, name.data(), std::min(name.size(), sizeof message.param_id));
    return message;
}

mavlink::ParamSet setting(const std::string& name, float value) {
    auto message = named<mavlink::ParamSet>(name);
    message.param_value = value;
    message.param_type = mavlink::MavParamType::real32;
    return message;
}

mavlink::ParamRequestList list() {
    mavlink::ParamRequestList message = {};
    message.target_system = message.target_component = 1;
    return message;
}

TEST_F(Telemetry, the_parameter_list_is_complete_and_in_order) {
    const auto values = ask<mavlink::ParamValue>(list(), 3000);

    ASSERT_EQ(values.size(), firmware::state::parameterCount());
    for (size_t i = 0; i < values.size(); ++i) {
        EXPECT_EQ(values[i].param_index, i);
        EXPECT_EQ(values[i].param_count, values.size());
    }
    EXPECT_EQ(nameOf(values[0]), "FORMAT_VERSION");
    EXPECT_EQ(values[0].param_value, 1);
}

TEST_F(Telemetry, the_parameter_list_takes_what_the_line_has_to_give) {
    station.line().endless = false;
    station.line().room = hal::kLinkRoom;
    station.send(list());
    uint32_t time_ms = 0;
    size_t received = 0;
    while (received < firmware::state::parameterCount() && time_ms < 10000) {
        station.line().room =
            static_cast<uint8_t>(std::min<int>(station.line().room + 57, hal::kLinkRoom));
        run_ms(10);  // 57,600 baud
        time_ms += 10;
        received += station.all<mavlink::ParamValue>().size();
    }

    EXPECT_LE(time_ms, listWire_ms() * 12 / 10);
}

TEST_F(Telemetry, streams_and_the_parameter_list_share_the_line) {
    firmware::state::parameters.streams[0] = {10, 10, 10, 10, 10, 10, 10};
    station.line().endless = false;
    station.line().room = hal::kLinkRoom;
    station.send(list());
    size_t received = 0, attitudes = 0;
    for (uint32_t ms = 0; ms < listWire_ms() * 19 / 10; ms += 10) {
        station.line().room =
            static_cast<uint8_t>(std::min<int>(station.line().room + 57, hal::kLinkRoom));
        run_ms(10);
        received += station.all<mavlink::ParamValue>().size();
        attitudes += station.all<mavlink::Attitude>().size();
    }

    EXPECT_EQ(received, firmware::state::parameterCount());
    EXPECT_GE(attitudes, 8u);
}

TEST_F(Telemetry, a_parameter_is_read_by_name_and_by_index) {
    auto request = named<mavlink::ParamRequestRead>("SYSID_MYGCS");
    request.param_index = -1;
    const auto by_name = ask<mavlink::ParamValue>(request);
    ASSERT_EQ(by_name.size(), 1u);
    EXPECT_EQ(nameOf(by_name[0]), "SYSID_MYGCS");
    EXPECT_EQ(by_name[0].param_value, 255);

    request = {};
    request.target_system = 1;
    request.param_index = static_cast<int16_t>(by_name[0].param_index);
    const auto by_index = ask<mavlink::ParamValue>(request);
    ASSERT_EQ(by_index.size(), 1u);
    EXPECT_EQ(nameOf(by_index[0]), "SYSID_MYGCS");
}

TEST_F(Telemetry, a_missing_parameter_is_not_answered) {
    auto request = named<mavlink::ParamRequestRead>("NO_SUCH_NAME");
    request.param_index = -1;
    EXPECT_TRUE(ask<mavlink::ParamValue>(request).empty());

    request.param_index = 9999;
    EXPECT_TRUE(ask<mavlink::ParamValue>(request).empty());
    EXPECT_EQ(ask<mavlink::ParamValue>(setting("RC2_TRIM", 1501)).size(), 1u) << "nor waited for";

    EXPECT_TRUE(ask<mavlink::ParamValue>(setting("NO_SUCH_NAME", 1)).empty());
    run_ms(1000);
    EXPECT_EQ(station.texts(), std::vector<std::string>{"No such parameter"}) << "once";
}

TEST_F(Telemetry, the_parameter_list_has_an_end_and_then_nothing_to_send) {
    firmware::gcs::Link& link = firmware::gcs::links[0];
    EXPECT_FALSE(firmware::gcs::parameterListSend(link)) << "nobody has asked";
    link.next_parameter = static_cast<uint16_t>(firmware::state::parameterCount() - 1);
    EXPECT_TRUE(firmware::gcs::parameterListSend(link));
    EXPECT_FALSE(firmware::gcs::parameterListSend(link));
}

TEST_F(Telemetry, a_refused_setting_says_whether_the_value_or_being_armed_is_why) {
    (void)ask<mavlink::ParamValue>(setting("SYSID_MYGCS", -1));
    EXPECT_EQ(station.texts().at(0), "Parameter value refused: out of range");
    firmware::state::mutable_vehicle.armed = true;
    (void)ask<mavlink::ParamValue>(setting("RCMAP_ROLL", 4));
    EXPECT_EQ(station.texts().at(0), "Parameter refused: armed");
}

TEST_F(Telemetry, a_setting_that_the_store_has_no_time_for_is_answered_with_the_old_value) {
    for (const char* name : {"RC2_TRIM", "NO_SUCH_NAME"}) {
        uint8_t bytes[mavlink::kLongestFrame];
        const uint16_t size =
            mavlink::encode({mavlink::Framing::v1, 0, 255, 190}, setting(name, 1501), bytes);
        mavlink::PeerParser parser;
        for (uint16_t i = 0; i < size; ++i) (void)parser.put(bytes[i]);
        EXPECT_TRUE(firmware::gcs::refuseParamSet(firmware::gcs::links[0], parser.frame()));
        run_ms(100);
        const auto values = station.all<mavlink::ParamValue>();
        EXPECT_EQ(station.texts().at(0), "Parameter not set: store busy");
        if (std::string(name) == "RC2_TRIM") {
            ASSERT_EQ(values.size(), 1u);
            EXPECT_EQ(values[0].param_value, 1500);
        } else {
            EXPECT_TRUE(values.empty());
        }
    }
}

TEST_F(Telemetry, setting_a_parameter_is_answered_with_what_it_now_is) {
    const auto values = ask<mavlink::ParamValue>(setting("TRIM_ARSPD_CM", 1350.4f));

    ASSERT_EQ(values.size(), 1u);
    EXPECT_EQ(values[0].param_value, 1350);
    EXPECT_EQ(firmware::state::parameters.cruise_speed_cms, 1350);
}

TEST_F(Telemetry, a_value_out_of_range_is_refused_with_a_text_and_changes_nothing) {
    for (const float value : {-1.0f, 1e9f, NAN}) {
        const auto values = ask<mavlink::ParamValue>(setting("SYSID_MYGCS", value));

        ASSERT_EQ(values.size(), 1u);
        EXPECT_EQ(values[0].param_value, 255);
        EXPECT_EQ(station.texts().size(), 1u);
    }
}

TEST_F(Telemetry, many_settings_wait_for_a_slow_store_and_none_is_lost) {
    fakes::setEepromSlow(true);
    for (int i = 0; i < 6; ++i)
        station.send(setting("RC" + std::to_string(i + 1) + "_TRIM", 1501.0f + i));

    run_ms(3000);

    const auto values = station.all<mavlink::ParamValue>();
    ASSERT_EQ(values.size(), 6u);
    for (int i = 0; i < 6; ++i) EXPECT_EQ(values[i].param_value, 1501 + i);
}

TEST_F(Telemetry, a_loop_of_writes_is_stopped_before_it_wears_the_eeprom_out) {
    constexpr int kMax = 450;
    float last = 0;
    for (int i = 0; i < kMax + 5; ++i)
        last =
            ask<mavlink::ParamValue>(setting("RC2_TRIM", 1400.0f + i % 2), 100).at(0).param_value;
    EXPECT_EQ(last, 1400 + (kMax - 1) % 2) << "the last one that was taken";
    EXPECT_EQ(station.texts().at(0), "Parameter refused: too many writes");

    run_ms(10'100);  // one more is granted
    const float other = 2801 - last;
    EXPECT_EQ(ask<mavlink::ParamValue>(setting("RC2_TRIM", other)).at(0).param_value, other);
    EXPECT_EQ(ask<mavlink::ParamValue>(setting("RC2_TRIM", last)).at(0).param_value, other);
}

TEST_F(Telemetry, writes_of_the_same_value_are_no_writes) {
    for (int i = 0; i < 500; ++i) (void)ask<mavlink::ParamValue>(setting("RC2_TRIM", 1500), 100);
    EXPECT_EQ(ask<mavlink::ParamValue>(setting("RC2_TRIM", 1501)).at(0).param_value, 1501);
}

TEST_F(Telemetry, what_a_stranger_may_not_do_he_cannot_grant_himself) {
    struct {
        const char* name;
        float before, wanted;
    } const kForUsb[] = {{"SERIAL_FORCE", 0, 1}, {"SIGN_POLICY", 1, 2}, {"AFS_TERM_ACTION", 0, 42}};
    for (const auto& [name, before, wanted] : kForUsb) {
        fakes::setUsb(false);
        run_ms(20);
        station.forget();
        EXPECT_EQ(ask<mavlink::ParamValue>(setting(name, wanted)).at(0).param_value, before);
        EXPECT_EQ(station.texts().at(0), "Parameter refused: only over USB") << name;
        fakes::setUsb(true);
        run_ms(20);
        EXPECT_EQ(ask<mavlink::ParamValue>(setting(name, wanted)).at(0).param_value, wanted);
    }
}

// What the vehicle's first start does to a blank EEPROM.
void claim() { ASSERT_EQ(storage::claim(), core::Status::ok); }

// A restart with what the EEPROM then holds.
void restart() {
    fakes::restartEeprom();
    while (firmware::state::parametersLoad() == core::Status::busy) fakes::advance_ms(10);
}

TEST_F(Telemetry, a_mode_that_does_not_exist_is_no_mode_of_the_switch) {
    constexpr float kAvoid = 14;  // of ArduPlane, not of this airplane
    const float before = firmware::state::parameters.switch_mode[0];
    const auto values = ask<mavlink::ParamValue>(setting("FLTMODE1", kAvoid));

    EXPECT_EQ(values.at(0).param_value, before);
    EXPECT_EQ(ask<mavlink::ParamValue>(setting("FLTMODE1", 10)).at(0).param_value, 10);
}

TEST_F(Telemetry, a_direction_is_1_or_minus_1) {
    EXPECT_EQ(ask<mavlink::ParamValue>(setting("RC2_REV", 0)).at(0).param_value, 1);
    EXPECT_EQ(ask<mavlink::ParamValue>(setting("RC2_REV", -1)).at(0).param_value, -1);
    EXPECT_EQ(ask<mavlink::ParamValue>(setting("RC2_TRIM", 1510)).at(0).param_value, 1510);
}

TEST_F(Telemetry, a_format_of_0_makes_the_next_start_forget_what_was_stored) {
    claim();
    ask<mavlink::ParamValue>(setting("WP_RADIUS", 42));
    ask<mavlink::ParamValue>(setting("FORMAT_VERSION", 0));
    restart();
    EXPECT_EQ(firmware::state::parameters.waypoint_radius_m, 30);

    for (int i = 0; i < 100; ++i) firmware::state::parametersRun();
    restart();

    EXPECT_EQ(firmware::state::parameters.waypoint_radius_m, 30);
    EXPECT_EQ(firmware::state::parameters.format_version, 1);
    run_ms(100);
    const auto texts = station.texts();
    ASSERT_EQ(texts.size(), 1u);
    EXPECT_EQ(texts[0], "All parameters are the defaults");
    const auto values = ask<mavlink::ParamValue>(setting("WP_RADIUS", 43));
    ASSERT_EQ(values.size(), 1u);
    EXPECT_EQ(values[0].param_value, 43);
}

TEST_F(Telemetry, parameters_are_reset_by_command_and_on_the_ground_only) {
    claim();
    ask<mavlink::ParamValue>(setting("WP_RADIUS", 42));
    firmware::state::mutable_vehicle.armed = true;
    EXPECT_EQ(command(mavlink::MavCmd::preflight_storage, 2),
              mavlink::MavResult::temporarily_rejected);
    EXPECT_EQ(ask<mavlink::ParamValue>(setting("FORMAT_VERSION", 0)).at(0).param_value, 1);
    firmware::state::mutable_vehicle.armed = false;
    EXPECT_EQ(command(mavlink::MavCmd::preflight_storage, 2), mavlink::MavResult::accepted);
    EXPECT_EQ(firmware::state::parameters.waypoint_radius_m, 42);  // until the restart
    restart();
    EXPECT_EQ(firmware::state::parameters.waypoint_radius_m, 30);
    for (int i = 0; i < 100; ++i) firmware::state::parametersRun();
    restart();

    EXPECT_EQ(firmware::state::parameters.waypoint_radius_m, 30);
}

TEST_F(Telemetry, a_reset_cut_short_anywhere_is_finished_by_the_next_start) {
    claim();
    for (const char* name : {"SYSID_MYGCS", "WP_RADIUS", "BATT_CAPACITY"})
        ask<mavlink::ParamValue>(setting(name, 101));
    ask<mavlink::ParamValue>(setting("FORMAT_VERSION", 0));
    const auto before = fakes::eepromCells();
    bool in_between = false;

    for (uint32_t cut = 0; cut < 30; ++cut) {
        fakes::resetEeprom();
        fakes::setEepromCells(before);
        restart();
        fakes::cutPowerAfter(cut);
        for (int i = 0; i < 10; ++i) firmware::state::parametersRun();
        in_between |= fakes::powerWasCut();
        for (int starts = 0; starts < 2; ++starts) {
            restart();
            for (int i = 0; i < 10; ++i) firmware::state::parametersRun();
        }
        ASSERT_EQ(firmware::state::parameters.ground_system_id, 255) << cut;
        ASSERT_EQ(firmware::state::parameters.waypoint_radius_m, 30) << cut;
        ASSERT_EQ(firmware::state::parameters.battery_capacity_mah, 3300) << cut;
        ASSERT_EQ(firmware::state::parameters.format_version, 1) << cut;
    }
    EXPECT_TRUE(in_between);
}

TEST_F(Telemetry, two_links_fetch_the_list_at_once_and_each_gets_all_of_it) {
    station.send(list());
    second.send(list());
    run_ms(3000);

    for (auto* each : {&station, &second}) {
        const auto values = each->all<mavlink::ParamValue>();
        ASSERT_EQ(values.size(), firmware::state::parameterCount());
        for (size_t i = 0; i < values.size(); ++i) ASSERT_EQ(values[i].param_index, i);
    }
}

TEST_F(Telemetry, a_list_asked_for_again_begins_again) {
    station.line().endless = false;
    station.line().room = hal::kLinkRoom;
    station.send(list());
    run_ms(100);
    ASSERT_FALSE(station.all<mavlink::ParamValue>().empty());
    station.line().endless = true;
    station.line().room = hal::kLinkRoom;
    const auto values = ask<mavlink::ParamValue>(list(), 3000);

    ASSERT_GE(values.size(), firmware::state::parameterCount());
    const auto first = values.end() - firmware::state::parameterCount();
    for (auto value = first; value != values.end(); ++value)
        ASSERT_EQ(value->param_index, value - first);
}

TEST_F(Telemetry, a_setting_during_a_list_is_answered_and_the_list_goes_on) {
    station.line().endless = false;
    station.line().room = hal::kLinkRoom;
    station.send(list());
    size_t answered = 0, listed = 0;
    for (uint32_t ms = 0; ms < 3000; ms += 10) {
        if (ms == 200) station.send(setting("BATT_CAPACITY", 2200));
        station.line().room =
            static_cast<uint8_t>(std::min<int>(station.line().room + 57, hal::kLinkRoom));
        run_ms(10);
        for (const auto& value : station.all<mavlink::ParamValue>()) {
            if (value.param_index == listed) {
                ++listed;
                if (nameOf(value) == "BATT_CAPACITY") {
                    EXPECT_EQ(value.param_value, 2200);
                }
            } else {
                EXPECT_EQ(nameOf(value), "BATT_CAPACITY");
                EXPECT_EQ(value.param_value, 2200);
                ++answered;
            }
        }
    }
    EXPECT_EQ(answered, 1u);
    EXPECT_EQ(listed, firmware::state::parameterCount());
}

TEST_F(Telemetry, a_new_value_is_sent_on_the_other_link_too) {
    station.send(setting("WP_RADIUS", 55));
    run_ms(20);

    const auto heard = second.all<mavlink::ParamValue>();
    ASSERT_EQ(heard.size(), 1u);
    EXPECT_EQ(nameOf(heard[0]), "WP_RADIUS");
    EXPECT_EQ(heard[0].param_value, 55);
}

TEST_F(Telemetry, whole_numbers_travel_as_floats_and_say_their_type) {
    auto request = named<mavlink::ParamRequestRead>("ALT_HOLD_RTL");
    request.param_index = -1;
    const auto value = ask<mavlink::ParamValue>(request).at(0);

    EXPECT_EQ(value.param_type, mavlink::MavParamType::int32);
    EXPECT_EQ(value.param_value, 10000.0f);
}

}  // namespace
