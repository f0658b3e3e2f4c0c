// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <map>

#include "core/maths.hpp"
#include "firmware/gcs/streams.hpp"
#include "ground.hpp"
#include "hal/clock.hpp"
#include "host_tests/support/fakes/vehicle.hpp"

using ground::Framing;
using ground::Telemetry;
using mavlink::MavDataStream;
using mavlink::MavModeFlag;
using mavlink::MavState;

namespace {

mavlink::RequestDataStream streamRequest(uint8_t stream, uint16_t rate_hz, bool start = true) {
    mavlink::RequestDataStream message = {};
    message.target_system = 1;
    message.target_component = 1;
    message.req_stream_id = stream;
    message.req_message_rate = rate_hz;
    message.start_stop = start;
    return message;
}

TEST_F(Telemetry, sends_only_a_heartbeat_a_second_when_nothing_is_requested) {
    run_ms(10000);

    EXPECT_EQ(station.all<mavlink::Heartbeat>().size(), 10u);
    EXPECT_EQ(second.all<mavlink::Heartbeat>().size(), 10u);
    EXPECT_TRUE(station.everything().empty());
}

TEST_F(Telemetry, says_what_it_is_from_its_own_address) {
    run_ms(1000);

    const auto heard = station.everything();
    ASSERT_EQ(heard.size(), 1u);
    EXPECT_EQ(heard[0].system, 1);
    EXPECT_EQ(heard[0].component, 1);
    mavlink::Heartbeat beat;
    memcpy(&beat, heard[0].payload.data(), sizeof beat);
    EXPECT_EQ(beat.type, mavlink::MavType::fixed_wing);
    EXPECT_EQ(beat.autopilot, mavlink::MavAutopilot::ardupilotmega);
    EXPECT_EQ(beat.mavlink_version, 3);
}

TEST_F(Telemetry, heartbeat_shows_mode_and_state) {
    using firmware::state::Mode;
    auto& mutable_vehicle = firmware::state::mutable_vehicle;
    firmware::state::parameters.stick_mixing = 0;
    mutable_vehicle.imu.calibrated = true;
    const struct {
        Mode mode;
        bool armed, flying, failsafe;
        uint8_t base_mode, state;
    } cases[] = {
        {Mode::manual, false, false, false, 1 | 64, MavState::standby},
        {Mode::fbwa, true, true, false, 1 | 16 | 128, MavState::active},
        {Mode::automatic, true, true, false, 1 | 16 | 8 | 128, MavState::active},
        {Mode::rtl, true, true, true, 1 | 16 | 8 | 128, MavState::critical},
    };
    for (const auto& each : cases) {
        mutable_vehicle.mode = each.mode;
        mutable_vehicle.armed = each.armed;
        mutable_vehicle.estimate.flying = each.flying;
        mutable_vehicle.failsafe_long = each.failsafe;
        station.forget();

        run_ms(1000);

        const auto beats = station.all<mavlink::Heartbeat>();
        ASSERT_EQ(beats.size(), 1u);
        EXPECT_EQ(beats[0].custom_mode, static_cast<uint32_t>(each.mode));
        EXPECT_EQ(beats[0].base_mode, each.base_mode);
        EXPECT_EQ(beats[0].system_status, each.state);
    }
}

TEST_F(Telemetry, a_stream_comes_at_the_rate_it_was_asked_for) {
    for (const uint16_t rate_hz : {1, 3, 4, 7, 10, 50}) {
        station.send(streamRequest(MavDataStream::extra1, rate_hz));
        run_ms(1000);
        station.forget();

        run_ms(5000);

        EXPECT_NEAR(station.all<mavlink::Attitude>().size(), 5 * rate_hz, 1) << rate_hz;
        EXPECT_TRUE(station.all<mavlink::VfrHud>().empty());
        EXPECT_TRUE(second.all<mavlink::Attitude>().empty());
    }
}

TEST_F(Telemetry, all_streams_start_and_stop_together) {
    station.send(streamRequest(MavDataStream::all, 10));
    run_ms(2000);
    const auto countOf = [this](uint16_t id) {
        station.forget();
        run_ms(1000);
        size_t count = 0;
        for (const auto& heard : station.everything()) count += heard.id == id;
        return count;
    };
    for (const uint16_t id : {1, 24, 27, 29, 30, 33, 35, 36, 42, 62, 65, 74, 163, 168})
        EXPECT_EQ(countOf(id), 10u) << id;
    // SYSTEM_TIME, POWER_STATUS, BATTERY_STATUS, MEMINFO, HWSTATUS, EKF_STATUS_REPORT, VIBRATION,
    // EXTENDED_SYS_STATE
    for (const uint16_t id : {2, 125, 147, 152, 165, 193, 241, 245})
        EXPECT_EQ(countOf(id), 1u) << id;

    station.send(streamRequest(MavDataStream::all, 10, false));
    run_ms(100);
    station.forget();
    run_ms(2000);

    EXPECT_EQ(station.all<mavlink::Heartbeat>().size(), 2u);
    EXPECT_TRUE(station.everything().empty());
}

TEST_F(Telemetry, the_rate_parameters_are_the_rates) {
    firmware::state::parameters.streams[1].position = 5;
    run_ms(1000);
    second.forget();

    run_ms(2000);

    EXPECT_EQ(second.all<mavlink::GlobalPositionInt>().size(), 10u);
    EXPECT_TRUE(station.all<mavlink::GlobalPositionInt>().empty());
}

TEST_F(Telemetry, a_message_can_have_an_interval_of_its_own) {
    constexpr uint16_t kAttitude = 30;
    EXPECT_EQ(command(mavlink::MavCmd::set_message_interval, kAttitude, 2e6f), 0);
    run_ms(2000);
    station.forget();
    run_ms(10000);
    EXPECT_EQ(station.all<mavlink::Attitude>().size(), 5u);

    EXPECT_EQ(command(mavlink::MavCmd::get_message_interval, kAttitude), 0);
    const auto intervals = station.all<mavlink::MessageInterval>();
    ASSERT_EQ(intervals.size(), 1u);
    EXPECT_EQ(intervals[0].interval_us, 2000000);

    EXPECT_EQ(command(mavlink::MavCmd::set_message_interval, kAttitude, -1), 0);
    station.send(streamRequest(MavDataStream::extra1, 10));
    run_ms(500);
    EXPECT_TRUE(station.all<mavlink::Attitude>().empty());

    EXPECT_EQ(command(mavlink::MavCmd::set_message_interval, kAttitude, 0), 0);
    run_ms(1000);
    EXPECT_NEAR(station.all<mavlink::Attitude>().size(), 10, 1);
}

TEST_F(Telemetry, the_heartbeat_cannot_be_turned_off) {
    EXPECT_NE(command(mavlink::MavCmd::set_message_interval, 0, -1), 0);

    run_ms(3000);

    EXPECT_EQ(station.all<mavlink::Heartbeat>().size(), 3u);
}

TEST_F(Telemetry, two_links_have_rates_of_their_own) {
    station.send(streamRequest(MavDataStream::all, 2));
    second.send(streamRequest(MavDataStream::all, 10));
    run_ms(2000);
    station.forget();
    second.forget();

    run_ms(5000);

    std::map<uint16_t, int> slow, fast;
    for (const auto& heard : station.everything()) ++slow[heard.id];
    for (const auto& heard : second.everything()) ++fast[heard.id];
    for (const uint16_t id : {1, 24, 27, 30, 33, 36, 74, 163}) {
        EXPECT_EQ(slow[id], 10) << id;
        EXPECT_EQ(fast[id], 50) << id;
    }
    EXPECT_EQ(slow[0], 5);
    EXPECT_EQ(fast[0], 5);
}

TEST_F(Telemetry, sends_only_whole_frames_and_heartbeats_on_a_slow_line) {
    memset(&firmware::state::parameters.streams[0], 10,
           sizeof firmware::state::parameters.streams[0]);
    station.line().endless = false;
    for (int i = 0; i < 1000; ++i) {  // 960 bytes a second: 9600 baud, a fifth of what is asked
        station.line().room =
            static_cast<uint8_t>(std::min<double>(station.line().room + 9.6, hal::kLinkRoom));
        run_ms(10);
    }

    EXPECT_EQ(station.broken(), 0);
    const auto heard = station.everything();
    uint32_t beats = 0, attitudes = 0, positions = 0;
    for (const auto& each : heard) {
        beats += each.id == 0;
        attitudes += each.id == 30;
        positions += each.id == 33;
    }
    EXPECT_GE(beats, 9u);
    EXPECT_GE(attitudes, 10u);  // everything has its share
    EXPECT_GE(positions, 10u);
    for (size_t i = 1; i < heard.size(); ++i)
        EXPECT_EQ(heard[i].sequence, static_cast<uint8_t>(heard[i - 1].sequence + 1));
}

TEST_F(Telemetry, slows_its_streams_when_the_radio_is_full_and_recovers) {
    firmware::state::parameters.streams[0].extra1 = 10;
    mavlink::RadioStatus radio = {};
    for (int i = 0; i < 8; ++i) {
        radio.txbuf = 10;
        station.send(radio);
        run_ms(100);
    }
    station.forget();
    run_ms(5000);
    EXPECT_LE(station.all<mavlink::Attitude>().size(), 10u);
    EXPECT_EQ(station.all<mavlink::Heartbeat>().size(), 5u);

    for (int i = 0; i < 10; ++i) {
        radio.txbuf = 99;
        station.send(radio);
        run_ms(100);
    }
    station.forget();
    run_ms(1000);
    EXPECT_NEAR(station.all<mavlink::Attitude>().size(), 10, 1);
}

TEST_F(Telemetry, messages_carry_the_vehicle_in_the_units_of_the_protocol) {
    auto& mutable_vehicle = firmware::state::mutable_vehicle;
    mutable_vehicle.home.set = true;
    mutable_vehicle.home.altitude_cm = 58400;
    mutable_vehicle.home.position = {-353632610, 1491652300};
    mutable_vehicle.estimate.position = {-353632620, 1491652400};
    mutable_vehicle.estimate.height_m = 100.5f;
    mutable_vehicle.estimate.velocity_mps = {10, -2, 0.5f};
    mutable_vehicle.estimate.wind_mps = {0, 5, 0};  // blows to the east
    mutable_vehicle.attitude.yaw_rad = core::Angle(core::radians(-90.0f));
    mutable_vehicle.throttle_demand = core::Ratio(0.45f);
    mutable_vehicle.gps.altitude_cm = 68450;
    mutable_vehicle.gps.hdop_c = 121;
    mutable_vehicle.imu.accel_mss = core::Accelerations::from(0, 0, -core::kGravity_mss);
    mutable_vehicle.baro.pressure_pa = 94500;
    mutable_vehicle.progress.nav_bearing_cd = 27000;
    station.send(streamRequest(MavDataStream::all, 4));
    run_ms(1000);

    const auto position = station.all<mavlink::GlobalPositionInt>().at(0);
    EXPECT_EQ(position.lat, -353632620);
    EXPECT_EQ(position.lon, 1491652400);
    EXPECT_EQ(position.alt, 684500);
    EXPECT_EQ(position.relative_alt, 100500);
    EXPECT_EQ(position.vx, 1000);
    EXPECT_EQ(position.vy, -200);
    EXPECT_EQ(position.vz, 50);
    EXPECT_EQ(position.hdg, 27000);
    const auto hud = station.all<mavlink::VfrHud>().at(0);
    EXPECT_EQ(hud.heading, 270);
    EXPECT_EQ(hud.throttle, 45);
    EXPECT_NEAR(hud.alt, 684.5f, 0.01f);
    const auto wind = station.all<mavlink::Wind>().at(0);
    EXPECT_NEAR(wind.direction, -90, 0.01f);  // comes from the west
    EXPECT_NEAR(wind.speed, 5, 0.01f);
    const auto gps = station.all<mavlink::GpsRawInt>().at(0);
    EXPECT_EQ(gps.alt, 684500);
    EXPECT_EQ(gps.eph, 121);
    EXPECT_EQ(station.all<mavlink::RawImu>().at(0).zacc, -1000);
    EXPECT_NEAR(station.all<mavlink::ScaledPressure>().at(0).press_abs, 945, 0.01f);
    EXPECT_EQ(station.all<mavlink::NavControllerOutput>().at(0).nav_bearing, -90);
    const auto status = station.all<mavlink::SysStatus>().at(0);
    EXPECT_EQ(status.load, 250);
    EXPECT_EQ(status.errors_count2, 3);
    EXPECT_EQ(status.errors_count3, 4321);
    const auto channels = station.all<mavlink::RcChannels>().at(0);
    EXPECT_EQ(channels.chancount, 8);
    EXPECT_EQ(channels.chan9_raw, 65535);
    EXPECT_EQ(channels.chan18_raw, 65535);
}

// -10000 to 10000 from end to end of RCn_, whatever is reversed.
TEST_F(Telemetry, channels_are_scaled_by_their_ends_and_their_trim) {
    constexpr uint16_t kRcChannelsScaled = 34;
    auto& pulses = firmware::state::mutable_vehicle.radio.pulse_us;
    firmware::state::parameters.channel[0] = {1000, 1400, 1900, -1, 30};
    struct {
        uint16_t pulse_us;
        int16_t scaled;
    } const kExpected[] = {{1000, -10000}, {1400, 0},    {1900, 10000},
                           {1200, -5000},  {1650, 5000}, {900, -10000},
                           {2100, 10000},  {1401, 20},   {0, INT16_MAX}};
    for (const auto& [pulse_us, scaled] : kExpected) {
        pulses[0] = pulse_us;
        station.forget();
        EXPECT_EQ(command(mavlink::MavCmd::request_message, kRcChannelsScaled), 0);
        run_ms(100);
        EXPECT_EQ(station.all<mavlink::RcChannelsScaled>().at(0).chan1_scaled, scaled) << pulse_us;
    }
}

// The matrix that turns a vector from the body to north, east and down, by quaternion and by
// angles.
TEST_F(Telemetry, the_quaternion_is_the_attitude) {
    constexpr uint16_t kAttitudeQuaternion = 31;
    auto& attitude = firmware::state::mutable_vehicle.attitude;
    for (const float roll : {-2.5f, -0.4f, 0.0f, 0.9f, 3.0f})
        for (const float pitch : {-1.2f, 0.3f, 1.5f})
            for (const float yaw : {-3.1f, -1.0f, 0.2f, 2.0f}) {
                attitude.roll_rad = core::Angle(roll);
                attitude.pitch_rad = core::Angle(pitch);
                attitude.yaw_rad = core::Angle(yaw);
                station.forget();
                EXPECT_EQ(command(mavlink::MavCmd::request_message, kAttitudeQuaternion), 0);
                run_ms(100);
                const auto q = station.all<mavlink::AttitudeQuaternion>().at(0);
                EXPECT_NEAR(q.q1 * q.q1 + q.q2 * q.q2 + q.q3 * q.q3 + q.q4 * q.q4, 1, 1e-4);
                // nose and right wing, as seen from the ground
                EXPECT_NEAR(1 - 2 * (q.q3 * q.q3 + q.q4 * q.q4), cosf(pitch) * cosf(yaw), 1e-3);
                EXPECT_NEAR(2 * (q.q2 * q.q3 + q.q1 * q.q4), cosf(pitch) * sinf(yaw), 1e-3);
                EXPECT_NEAR(2 * (q.q2 * q.q4 - q.q1 * q.q3), -sinf(pitch), 1e-3);
                EXPECT_NEAR(2 * (q.q3 * q.q4 + q.q1 * q.q2), sinf(roll) * cosf(pitch), 1e-3);
            }
}

TEST_F(Telemetry, the_local_position_counts_from_home_and_waits_for_one) {
    constexpr uint16_t kLocalPosition = 32;
    auto& now = firmware::state::mutable_vehicle;
    EXPECT_EQ(command(mavlink::MavCmd::request_message, kLocalPosition), 0);
    run_ms(100);
    EXPECT_TRUE(station.all<mavlink::LocalPositionNed>().empty());

    now.home.set = now.estimate.known = true;
    now.home.position = {473977420, 85455940};
    now.estimate.position = {473977420 + 9000, 85455940 - 13000};  // 100 m north, 98 m west
    now.estimate.height_m = 42;
    now.estimate.velocity_mps = {3, -4, 0.5f};
    EXPECT_EQ(command(mavlink::MavCmd::request_message, kLocalPosition), 0);
    run_ms(100);
    const auto local = station.all<mavlink::LocalPositionNed>().at(0);
    EXPECT_NEAR(local.x, 100.2f, 0.5f);
    EXPECT_NEAR(local.y, -98.1f, 0.5f);
    EXPECT_EQ(local.z, -42);
    EXPECT_EQ(local.vx, 3);
    EXPECT_EQ(local.vy, -4);
    EXPECT_EQ(local.vz, 0.5f);
}

TEST_F(Telemetry, the_target_is_where_a_mode_flies_that_guides_itself) {
    using firmware::state::Mode;
    using firmware::state::Path;
    constexpr uint16_t kTarget = 87;
    auto& now = firmware::state::mutable_vehicle;
    now.home.altitude_cm = 50000;
    now.demand.to = {473977420, 85455940};
    now.demand.height_m = 60;
    const auto sent = [&](Mode mode, Path path) {
        now.mode = mode;
        now.demand.path = path;
        station.forget();
        EXPECT_EQ(command(mavlink::MavCmd::request_message, kTarget), 0);
        run_ms(100);
        return station.all<mavlink::PositionTargetGlobalInt>();
    };
    EXPECT_TRUE(sent(Mode::fbwa, Path::circle).empty()) << "what an earlier mode has left";
    EXPECT_TRUE(sent(Mode::automatic, Path::takeoff).empty());
    for (const Path path : {Path::leg, Path::circle, Path::land}) {
        const auto target = sent(Mode::guided, path).at(0);
        EXPECT_EQ(target.lat_int, 473977420);
        EXPECT_EQ(target.lon_int, 85455940);
        EXPECT_NEAR(target.alt, 560, 0.01f);
        EXPECT_EQ(target.coordinate_frame, mavlink::MavFrame::global);
        EXPECT_EQ(target.type_mask & 7, 0) << "the position counts";
    }
}

TEST_F(Telemetry, mode_and_inertial_numbers_come_when_asked_for) {
    auto& now = firmware::state::mutable_vehicle;
    now.mode = firmware::state::Mode::loiter;
    now.imu.accel_mss.z = core::Acceleration(-9.80665f);
    now.compass.field_mg = {200, -30, 400};
    EXPECT_EQ(command(mavlink::MavCmd::request_message, 436), 0);
    EXPECT_EQ(command(mavlink::MavCmd::request_message, 26), 0);
    run_ms(100);
    EXPECT_EQ(station.all<mavlink::CurrentMode>().at(0).custom_mode, 12u);
    const auto imu = station.all<mavlink::ScaledImu>().at(0);
    EXPECT_EQ(imu.zacc, -1000);
    EXPECT_EQ(imu.xmag, 200);
    EXPECT_EQ(imu.ymag, -30);
    EXPECT_EQ(imu.zmag, 400);
}

TEST_F(Telemetry, airspeed_is_the_speed_over_ground_while_it_stands_without_a_sensor) {
    struct Row {
        bool healthy, flying;
        float reported_mps;
    };
    for (const Row& row : {Row{false, false, 1}, {false, true, 9}, {true, false, 9}}) {
        SetUp();
        firmware::state::mutable_vehicle.airspeed.healthy = row.healthy;
        firmware::state::mutable_vehicle.estimate.flying = row.flying;
        firmware::state::mutable_vehicle.estimate.equivalent_airspeed_mps = 9;
        firmware::state::mutable_vehicle.estimate.ground_speed_mps = 1;
        station.send(streamRequest(MavDataStream::all, 4));
        run_ms(1000);
        EXPECT_EQ(station.all<mavlink::VfrHud>().back().airspeed, row.reported_mps);
    }
}

TEST_F(Telemetry, sys_status_names_the_failed_sensors) {
    using Sensor = mavlink::MavSysStatusSensor;
    firmware::state::mutable_vehicle.gps.healthy = false;
    firmware::state::mutable_vehicle.baro.healthy = true;
    firmware::state::parameters.streams[0].extended_status = 4;
    firmware::state::mutable_vehicle.prearm_ok = false;

    run_ms(1000);

    const auto status = station.all<mavlink::SysStatus>().at(0);
    EXPECT_TRUE(status.onboard_control_sensors_present & Sensor::sensor_gps);
    EXPECT_FALSE(status.onboard_control_sensors_health & Sensor::sensor_gps);
    EXPECT_TRUE(status.onboard_control_sensors_health & Sensor::sensor_absolute_pressure);
    EXPECT_FALSE(status.onboard_control_sensors_health & Sensor::prearm_check);
}

TEST_F(Telemetry, extended_sys_state_shows_take_off_flight_and_landing) {
    using firmware::state::Mode;
    using firmware::state::Path;
    using Landed = mavlink::MavLandedState;
    auto& mutable_vehicle = firmware::state::mutable_vehicle;
    firmware::state::parameters.streams[0].extended_status = 1;
    const struct {
        Mode mode;
        Path path;
        bool flying;
        uint8_t landed_state;
    } cases[] = {
        {Mode::manual, Path::none, false, Landed::on_ground},
        {Mode::automatic, Path::takeoff, false, Landed::on_ground},  // waits for its launch
        {Mode::automatic, Path::takeoff, true, Landed::takeoff},
        {Mode::automatic, Path::leg, true, Landed::in_air},
        {Mode::automatic, Path::land, true, Landed::landing},
        {Mode::fbwa, Path::land, true, Landed::in_air},  // the pilot has taken over
        {Mode::automatic, Path::land, false, Landed::on_ground},
    };
    for (const auto& each : cases) {
        mutable_vehicle.mode = each.mode;
        mutable_vehicle.demand.path = each.path;
        mutable_vehicle.estimate.flying = each.flying;
        run_ms(1000);
        station.forget();

        run_ms(1000);

        const auto states = station.all<mavlink::ExtendedSysState>();
        ASSERT_EQ(states.size(), 1u);
        EXPECT_EQ(states[0].landed_state, each.landed_state);
        EXPECT_EQ(states[0].vtol_state, mavlink::MavVtolState::undefined);
    }
}

TEST_F(Telemetry, a_reached_item_is_reported_once_on_every_link) {
    doubles::plan.reached = {3, 4};

    run_ms(200);

    for (ground::Station* each : {&station, &second}) {
        const auto reached = each->all<mavlink::MissionItemReached>();
        ASSERT_EQ(reached.size(), 2u);
        EXPECT_EQ(reached[0].seq, 3);
        EXPECT_EQ(reached[1].seq, 4);
    }
}

TEST_F(Telemetry, each_picture_is_reported_once_on_every_link) {
    auto& mutable_vehicle = firmware::state::mutable_vehicle;
    mutable_vehicle.estimate.position = {473977000, 85456000};
    mutable_vehicle.estimate.height_m = 100;
    mutable_vehicle.home.altitude_cm = 48800;
    mutable_vehicle.home.set = true;
    mutable_vehicle.attitude.pitch_rad = core::Angle(core::radians(5));
    run_ms(300);
    for (uint16_t picture : {1, 2}) {
        doubles::plan.triggers = picture;
        run_ms(300);
    }
    for (ground::Station* each : {&station, &second}) {
        const auto reported = each->all<mavlink::CameraFeedback>();
        ASSERT_EQ(reported.size(), 2u);
        EXPECT_EQ(reported[0].img_idx, 1);
        EXPECT_EQ(reported[1].img_idx, 2);
        EXPECT_EQ(reported[1].lat, 473977000);
        EXPECT_NEAR(reported[1].alt_msl, 588, 0.01);
        EXPECT_NEAR(reported[1].pitch, 5, 0.01);
    }
}

TEST_F(Telemetry, each_change_of_home_is_sent_once_on_every_link) {
    auto& home = firmware::state::mutable_vehicle.home;
    run_ms(300);
    EXPECT_EQ(station.all<mavlink::HomePosition>().size(), 0u);
    home.set = true;
    for (const int32_t altitude_cm : {48800, 48900}) {
        home.altitude_cm = altitude_cm;
        ++home.changes;
        run_ms(300);
    }
    for (ground::Station* each : {&station, &second}) {
        const auto sent = each->all<mavlink::HomePosition>();
        ASSERT_EQ(sent.size(), 2u);
        EXPECT_EQ(sent[0].altitude, 488000);
        EXPECT_EQ(sent[1].altitude, 489000);
    }
}

TEST_F(Telemetry, battery_status_carries_the_pack_and_says_what_is_not_known) {
    using firmware::state::mutable_vehicle;
    using firmware::state::parameters;
    mutable_vehicle.battery = {11800, 1250, 440.6f, 5000};
    parameters.battery_monitor = 4;
    parameters.battery_capacity_mah = 2200;
    parameters.streams[0].extended_status = 10;
    run_ms(1100);
    const auto sent = station.all<mavlink::BatteryStatus>();
    ASSERT_GE(sent.size(), 1u);
    ASSERT_LE(sent.size(), 2u) << "once a second is often enough";
    const auto& status = sent[0];
    EXPECT_EQ(status.voltages[0], 11800);
    EXPECT_EQ(status.voltages[1], UINT16_MAX);
    EXPECT_EQ(status.voltages[9], UINT16_MAX);
    EXPECT_EQ(status.current_battery, 1250);
    EXPECT_EQ(status.current_consumed, 441);
    EXPECT_EQ(status.battery_remaining, 79);
    EXPECT_EQ(status.energy_consumed, -1);
    EXPECT_EQ(status.temperature, INT16_MAX);

    mutable_vehicle.battery.current_ca = -1;
    run_ms(1100);
    const auto voltage_alone = station.all<mavlink::BatteryStatus>().back();
    EXPECT_EQ(voltage_alone.current_battery, -1);
    EXPECT_EQ(voltage_alone.current_consumed, -1);
    EXPECT_EQ(voltage_alone.battery_remaining, -1);

    const auto comes = [this] {
        station.forget();
        run_ms(1100);
        return !station.all<mavlink::BatteryStatus>().empty();
    };
    EXPECT_TRUE(comes());
    parameters.streams[0].extended_status = 0;
    EXPECT_FALSE(comes());
    parameters.streams[0].extended_status = 10;
    parameters.battery_monitor = 0;
    EXPECT_FALSE(comes());
}

TEST_F(Telemetry, vibration_is_what_the_accelerometers_measure_beside_the_flight) {
    doubles::vehicle.vibration_cmss[0] = 150;
    doubles::vehicle.vibration_cmss[1] = 2;
    doubles::vehicle.vibration_cmss[2] = 3000;
    doubles::vehicle.clips = 255;
    EXPECT_EQ(command(mavlink::MavCmd::request_message, 241), 0);
    run_ms(100);
    const auto vibration = station.all<mavlink::Vibration>().at(0);
    EXPECT_NEAR(vibration.time_usec, hal::now_ms() * 1000ull, 120000);
    EXPECT_FLOAT_EQ(vibration.vibration_x, 1.5f);
    EXPECT_FLOAT_EQ(vibration.vibration_y, 0.02f);
    EXPECT_FLOAT_EQ(vibration.vibration_z, 30);
    EXPECT_EQ(vibration.clipping_0, 255u);
    EXPECT_EQ(vibration.clipping_1, 0u);
}

TEST_F(Telemetry, ekf_status_report_says_what_is_known_of_attitude_place_and_height) {
    using Flag = mavlink::EkfStatusFlags;
    constexpr uint16_t kHeight = Flag::velocity_vert | Flag::pos_vert_abs;
    constexpr uint16_t kReckoned = Flag::velocity_horiz | Flag::pos_horiz_rel;
    constexpr uint16_t kPlace =
        kReckoned | Flag::pos_horiz_abs | Flag::pred_pos_horiz_rel | Flag::pred_pos_horiz_abs;
    const struct {
        const char* what;
        bool aligned, height, known, reckoned, refused;
        uint16_t flags;
    } cases[] = {
        {"just started", false, false, false, true, false, Flag::uninitialized},
        {"not aligned yet", false, true, false, true, false, Flag::uninitialized | kHeight},
        {"no fix", true, true, false, true, false, Flag::attitude | kHeight | Flag::const_pos_mode},
        {"fix", true, true, true, false, false, Flag::attitude | kHeight | kPlace},
        {"one fix far off", true, true, true, false, true,
         Flag::attitude | kHeight | kPlace | Flag::gps_glitching},
        {"dead reckoning", true, true, true, true, false, Flag::attitude | kHeight | kReckoned},
        {"no height", true, false, true, false, false, Flag::attitude | kPlace},
        {"no inertial sensor in flight", false, true, true, false, false,
         Flag::uninitialized | kHeight | kPlace},
    };
    auto& now = firmware::state::mutable_vehicle;
    for (const auto& each : cases) {
        now.attitude.aligned = each.aligned;
        now.estimate.height_known = each.height;
        now.estimate.known = each.known;
        now.estimate.reckoned = each.reckoned;
        now.estimate.fix_refused = each.refused;
        station.forget();
        EXPECT_EQ(command(mavlink::MavCmd::request_message, 193), 0);
        run_ms(100);
        EXPECT_EQ(station.all<mavlink::EkfStatusReport>().at(0).flags, each.flags) << each.what;
    }
}

// The ratios themselves are the estimator's: its tests have the others.
TEST_F(Telemetry, ekf_status_report_carries_the_estimators_test_ratios) {
    auto& now = firmware::state::mutable_vehicle;
    now.estimate.height_known = now.baro.healthy = true;
    now.estimate.baro_height_m = 6;  // the estimate is 0; 15 m is the limit
    EXPECT_EQ(command(mavlink::MavCmd::request_message, 193), 0);
    run_ms(100);
    const auto report = station.all<mavlink::EkfStatusReport>().at(0);
    EXPECT_FLOAT_EQ(report.pos_vert_variance, 0.4f);
    EXPECT_EQ(report.velocity_variance, 0);
    EXPECT_EQ(report.pos_horiz_variance, 0);
    EXPECT_EQ(report.compass_variance, 0);
    EXPECT_EQ(report.terrain_alt_variance, 0);
    EXPECT_EQ(report.airspeed_variance, 0);
}

// Whatever the stream's rate is; an interval of its own is kept.
TEST_F(Telemetry, what_comes_slowly_comes_once_a_second_while_its_stream_does) {
    constexpr uint16_t kVibration = 241;
    const auto inFiveSeconds = [this] {
        run_ms(1000);
        station.forget();
        run_ms(5000);
        return station.all<mavlink::Vibration>().size();
    };
    auto& rate_hz = firmware::state::parameters.streams[0].extra3;
    for (const int8_t each_hz : {1, 3, 50}) {
        rate_hz = each_hz;
        EXPECT_EQ(inFiveSeconds(), 5u) << int{each_hz};
    }
    rate_hz = 0;
    EXPECT_EQ(inFiveSeconds(), 0u);
    EXPECT_EQ(command(mavlink::MavCmd::set_message_interval, kVibration, 200000), 0);
    EXPECT_EQ(inFiveSeconds(), 25u);
}

TEST_F(Telemetry, system_time_is_utc_once_there_was_a_fix_and_goes_on_without) {
    using firmware::state::mutable_vehicle;
    firmware::state::parameters.streams[0].extra3 = 4;
    doubles::vehicle.fix.week = 2400;  // began on 2026-01-04
    doubles::vehicle.fix.time_ms = 518400000 + 250;
    doubles::vehicle.fix.age_ms = 50;
    run_ms(1500);
    EXPECT_EQ(station.all<mavlink::SystemTime>().back().time_unix_usec, 0u);

    mutable_vehicle.home.set = true;
    mutable_vehicle.gps.received_ms = hal::now_ms();
    for (const int later_ms : {1500, 4000}) {
        run_ms(later_ms);
        const auto time = station.all<mavlink::SystemTime>().back();
        // 2026-01-10T00:00:00.300Z, 18 leap seconds before that
        const uint64_t began_us = (1767484800ull + 6 * 86400 - 18) * 1000000 + 300000;
        EXPECT_EQ(time.time_unix_usec,
                  began_us + (time.time_boot_ms - mutable_vehicle.gps.received_ms) * 1000ull);
    }
}

}  // namespace
