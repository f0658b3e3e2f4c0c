// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "ground.hpp"

using ground::Telemetry;

namespace {

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

    ASSERT_EQ(values.size(), firmware::parameterCount());
    for (size_t i = 0; i < values.size(); ++i) {
        EXPECT_EQ(values[i].param_index, i);
        EXPECT_EQ(values[i].param_count, values.size());
    }
    EXPECT_EQ(nameOf(values[0]), "SYSID_THISMAV");
    EXPECT_EQ(values[0].param_value, 1);
}

TEST_F(Telemetry, the_parameter_list_takes_what_the_line_has_to_give) {
    station.line().endless = false;
    station.line().room = 127;
    station.send(list());
    uint32_t time_ms = 0;
    size_t received = 0;
    while (received < firmware::parameterCount() && time_ms < 10000) {
        station.line().room = static_cast<uint8_t>(std::min(station.line().room + 57, 127));
        run_ms(10);  // 57,600 baud
        time_ms += 10;
        received += station.all<mavlink::ParamValue>().size();
    }

    const uint32_t wire_ms = firmware::parameterCount() * 33u * 10u * 1000u / 57600u;
    EXPECT_LE(time_ms, wire_ms * 12 / 10);
}

TEST_F(Telemetry, streams_and_the_parameter_list_share_the_line) {
    firmware::parameters.streams[0] = {10, 10, 10, 10, 10, 10, 10, 10, 10};
    station.line().endless = false;
    station.line().room = 127;
    station.send(list());
    size_t received = 0, attitudes = 0;
    for (uint32_t ms = 0; ms < 2500; ms += 10) {
        station.line().room = static_cast<uint8_t>(std::min(station.line().room + 57, 127));
        run_ms(10);
        received += station.all<mavlink::ParamValue>().size();
        attitudes += station.all<mavlink::Attitude>().size();
    }

    EXPECT_EQ(received, firmware::parameterCount());
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

TEST_F(Telemetry, a_parameter_that_does_not_exist_is_not_invented) {
    auto request = named<mavlink::ParamRequestRead>("NO_SUCH_NAME");
    request.param_index = -1;
    EXPECT_TRUE(ask<mavlink::ParamValue>(request).empty());

    request.param_index = 9999;
    EXPECT_TRUE(ask<mavlink::ParamValue>(request).empty());

    EXPECT_TRUE(ask<mavlink::ParamValue>(setting("NO_SUCH_NAME", 1)).empty());
    EXPECT_EQ(station.texts().at(0), "No such parameter");
}

TEST_F(Telemetry, setting_a_parameter_is_answered_with_what_it_now_is) {
    const auto values = ask<mavlink::ParamValue>(setting("TRIM_ARSPD_CM", 1350.4f));

    ASSERT_EQ(values.size(), 1u);
    EXPECT_EQ(values[0].param_value, 1350);
    EXPECT_EQ(firmware::parameters.cruise_speed_cms, 1350);
}

TEST_F(Telemetry, a_value_that_is_out_of_range_changes_nothing_and_is_refused_aloud) {
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

}  // namespace
