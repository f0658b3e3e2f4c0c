// SPDX-License-Identifier: GPL-3.0-or-later
// The APM 1.0 set in flight.
#include "mission_flight.hpp"

#include <map>

#include "firmware/app/dataflash.hpp"
#include "firmware/logger/log.hpp"
#include "host_tests/support/fakes/vehicle.hpp"

namespace firmware {
using namespace mission;
using namespace logger;
using namespace app;
namespace {

TEST_F(Apm1Flight, the_mode_is_changed_and_coming_back_goes_on_behind_the_command) {
    fly({waypoint(500), command(0x30, 12), command(0x81, 1), waypoint(900)});
    EXPECT_EQ(vehicle.mode, Mode::loiter);
    EXPECT_FALSE(relayGet());
    enterAuto();
    EXPECT_EQ(vehicle.mode, Mode::automatic);
    EXPECT_TRUE(relayGet());
    EXPECT_EQ(missionCurrent(), 1);
}

TEST_F(Apm1Flight, changing_the_mode_to_auto_does_nothing) {
    run(command(0x30, 10));
    EXPECT_EQ(vehicle.mode, Mode::automatic);
    EXPECT_EQ(missionCurrent(), 1);
}

TEST_F(Apm1Flight, cruise_speed_throttle_and_gains_are_set) {
    fly({waypoint(500), command(0x40, 15), command(0x41, 70), command(0x60, 0, 45000),
         command(0x61, 6, 20000), command(0x64, 1, 70000), command(0x73, 2, 960)});
    pass();  // more than the engine looks at in one
    EXPECT_FLOAT_EQ(vehicle.demand.airspeed_mps, 15);
    EXPECT_EQ(vehicle.demand.throttle_pct, 70);
    EXPECT_FLOAT_EQ(parameters.roll.axis.p, 0.45f);
    EXPECT_FLOAT_EQ(parameters.speed_height.integral_gain, 0.2f);
    EXPECT_FLOAT_EQ(parameters.rudder_mix, 0.7f);
    EXPECT_EQ(parameters.throttle_failsafe_us, 960);
}

TEST_F(Apm1Flight, free_channels_are_set_in_flight) {
    run(command(0x71, 4, 1910));
    run(command(0x70, 4, 1510));
    run(command(0x72, 7, 1090));
    EXPECT_EQ(parameters.channel[4].max_us, 1910);
    EXPECT_EQ(parameters.channel[4].trim_us, 1510);
    EXPECT_EQ(parameters.channel[7].min_us, 1090);
}

// Armed, as a mission is flown, what sticks and servos mean is refused to it too.
TEST_F(Apm1Flight, channels_of_sticks_and_functions_are_set_while_disarmed_only) {
    parameters.output_function[0] = 2;  // flaps on output 5
    parameters.map_yaw = 8;
    constexpr struct {
        uint8_t id, p1;
        int16_t us;
    } kCases[] = {{0x70, 4, 1510}, {0x71, 7, 1950}, {0x72, 0, 1050}};
    for (const auto& each : kCases) {
        const uint8_t slot = channelSlot(each.id, each.p1);
        float before, after;
        ASSERT_TRUE(parameterGet(slot, before));
        run(command(each.id, each.p1, each.us));
        ASSERT_TRUE(parameterGet(slot, after));
        EXPECT_EQ(after, before) << int(each.id);
        EXPECT_TRUE(hasStatusText("Mission: parameter " + std::to_string(slot) + " not set"));
        mutable_vehicle.armed = false;
        setChannel({each.id, 0, each.p1, each.us, 0, 0});
        ASSERT_TRUE(parameterGet(slot, after));
        EXPECT_EQ(after, each.us) << int(each.id);
        mutable_vehicle.armed = true;
    }
}

TEST_F(Apm1Flight, every_gain_it_accepts_goes_to_the_parameter_that_plays_the_part) {
    std::map<std::pair<int, int>, std::string> parts = {
        {{0x60, 2}, "YAW2SRV_SLIP"},    {{0x60, 4}, "TECS_SPDWEIGHT"},
        {{0x61, 4}, "TECS_INTEG_GAIN"}, {{0x61, 5}, "TECS_INTEG_GAIN"},
        {{0x61, 7}, "TECS_INTEG_GAIN"}, {{0x62, 4}, "TECS_PTCH_DAMP"},
        {{0x62, 7}, "TECS_THR_DAMP"},   {{0x60, 0}, "RLL2SRV_P"},
        {{0x60, 1}, "PTCH2SRV_P"},      {{0x61, 0}, "RLL2SRV_I"},
        {{0x61, 1}, "PTCH2SRV_I"},      {{0x61, 2}, "YAW2SRV_INT"},
        {{0x61, 6}, "TECS_INTEG_GAIN"}, {{0x62, 0}, "RLL2SRV_D"},
        {{0x62, 1}, "PTCH2SRV_D"},      {{0x62, 2}, "YAW2SRV_DAMP"},
        {{0x62, 3}, "NAVL1_DAMPING"},   {{0x62, 5}, "TECS_PTCH_DAMP"},
        {{0x62, 6}, "TECS_THR_DAMP"},   {{0x63, 0}, "RLL2SRV_IMAX"},
        {{0x63, 1}, "PTCH2SRV_IMAX"},   {{0x63, 2}, "YAW2SRV_IMAX"},
        {{0x64, 0}, "PTCH2SRV_RLL"},    {{0x64, 1}, "KFF_RDDRMIX"},
    };
    for (int id = 0x60; id <= 0x64; ++id) {
        for (int index = 0; index < 8; ++index) {
            const uint8_t slot = gainSlot(uint8_t(id), uint8_t(index));
            const std::string part = parts[{id, index}];
            EXPECT_EQ(nameOfSlot(slot), part) << std::hex << id << " " << index;
            EXPECT_EQ(slot == kNoSlot, part.empty()) << std::hex << id << " " << index;
        }
    }
}

TEST_F(Apm1Flight, every_channel_slot_is_the_parameter_it_should_be) {
    for (uint8_t i = 0; i < 8; ++i) {
        const std::string channel = "RC" + std::to_string(i + 1);
        EXPECT_EQ(nameOfSlot(channelSlot(0x70, i)), channel + "_TRIM");
        EXPECT_EQ(nameOfSlot(channelSlot(0x71, i)), channel + "_MAX");
        EXPECT_EQ(nameOfSlot(channelSlot(0x72, i)), channel + "_MIN");
    }
    EXPECT_EQ(nameOfSlot(otherRadioSlot(2)), "THR_FS_VALUE");
    EXPECT_EQ(otherRadioSlot(3), kNoSlot);
}

TEST_F(Apm1Flight, trims_of_elevons_are_those_of_their_channels_where_there_are_elevons) {
    EXPECT_EQ(answer(command(0x73, 0, 1480)), MissionResult::invalid_param1);
    EXPECT_EQ(answer(command(0x73, 1, 1480)), MissionResult::invalid_param1);
    parameters.elevon_output = 1;
    EXPECT_EQ(answer(command(0x73, 0, 1480)), MissionResult::accepted);
    mutable_vehicle.armed = false;
    setOtherRadio({0x73, 0, 0, 1480, 0, 0});
    setOtherRadio({0x73, 0, 1, 1530, 0, 0});
    EXPECT_EQ(parameters.channel[0].trim_us, 1480);
    EXPECT_EQ(parameters.channel[1].trim_us, 1530);
    EXPECT_EQ(answer(command(0x73, 3, 1480)), MissionResult::invalid_param1);
}

TEST_F(Apm1Flight, home_is_reset_here_or_as_given) {
    mutable_vehicle.estimate.position.latitude_e7 += 1000;
    run(command(0x42));
    EXPECT_EQ(vehicle.home.position, vehicle.estimate.position);
    requestMode(Mode::loiter, ModeReason::pilot);
    MissionItem home = placed(0x42, 1000, 0, 420);
    run(home);
    EXPECT_EQ(vehicle.home.position.latitude_e7, home.x);
    EXPECT_EQ(vehicle.home.altitude_cm, 42000);
}

TEST_F(Apm1Flight, a_nav_is_being_flown_when_home_moves_behind_it_and_stays_where_it_is) {
    run(placed(0x42, 0, 0, 410));  // 10 m higher
    EXPECT_FLOAT_EQ(vehicle.demand.height_m, 40);
    EXPECT_EQ(missionCurrent(), 1);
}

TEST_F(Apm1Flight, a_queried_or_broadcast_variable_is_sent_once_on_every_link) {
    const auto reported = [](hal::Port port) {
        auto& out = fakes::serial(port).out;
        const std::string text(out.begin(), out.end());
        out.clear();
        const size_t at = text.find("WP_RADIUS");
        return at != std::string::npos && text.find("WP_RADIUS", at + 1) == std::string::npos;
    };
    for (const uint16_t id : {0x32, 0x33}) {
        requestMode(Mode::loiter, ModeReason::pilot);
        reported(hal::Port::link0);
        reported(hal::Port::link1);
        run(command(id, 134));
        pass(5);
        EXPECT_TRUE(reported(hal::Port::link0)) << id;
        EXPECT_TRUE(reported(hal::Port::link1)) << id;
    }
}

// A DataFlash that is never busy; what is written into its buffers goes by as text.
class LoggedFlight : public Apm1Flight {
protected:
    void SetUp() override {
        Apm1Flight::SetUp();
        fakes::FlashBus::device = [](uint8_t) -> uint8_t {
            const std::vector<uint8_t>& sent = fakes::FlashBus::sent;
            if (sent.size() < 2) return 0xFF;
            if (sent[0] == 0x9F) return sent.size() == 2 ? 0x1F : 0x26;
            return sent[0] == 0xD7 ? 0xAC : 0xFF;
        };
        fakes::FlashBus::on_select = [this](bool low) {
            std::vector<uint8_t>& sent = fakes::FlashBus::sent;
            const bool into_buffer = !low && !sent.empty() && (sent[0] == 0x84 || sent[0] == 0x87);
            if (into_buffer && sent.size() > 4) written.append(sent.begin() + 4, sent.end());
            sent.clear();
        };
        dataflashStart();
        for (int i = 0; i < 4; ++i) {
            fakes::advance_ms(100);
            dataflashStep();
        }
        parameters.log_bitmask = 4;
        logStart();
        while (logFind()) {
        }
        writeOn();  // what every log begins with, all parameters among it
    }
    static void writeOn() {
        for (int i = 0; i < 600; ++i) {
            runLog();
            fakes::advance_ms(20);
        }
    }
    // The chip keeps nothing, so there is no mission: the row itself is run.
    bool logs(uint8_t id) {
        written.clear();
        const uint8_t row = kCommandTable.find(::mission::Set::apm1, id);
        kCommandTable.rows[row].act({id, 0, 134, 0, 0, 0});
        pass(3);
        writeOn();
        return written.find("WP_RADIUS") != std::string::npos;
    }
    std::string written;
};

TEST_F(LoggedFlight, a_broadcast_variable_is_written_to_the_log_and_a_queried_one_is_not) {
    ASSERT_TRUE(logOpen());
    EXPECT_FALSE(logs(0x32));
    EXPECT_TRUE(logs(0x33));
}

TEST_F(Apm1Flight, a_variable_followed_at_once_by_another_is_still_sent) {
    auto& port = fakes::serial(hal::Port::link0);
    port.endless = false;
    port.room = 0;
    fly({waypoint(500), command(0x32, 134), command(0x32, 102), waypoint(900)});
    port.endless = true;
    port.room = 255;
    EXPECT_TRUE(hasStatusText("parameter 134 not sent"));
}

TEST_F(Apm1Flight, a_variable_that_finds_no_room_is_sent_later) {
    auto& port = fakes::serial(hal::Port::link0);
    port.endless = false;
    port.room = 0;
    run(command(0x32, 134));
    pass(3);
    port.endless = true;
    port.room = 255;
    port.out.clear();
    pass();
    EXPECT_NE(std::string(port.out.begin(), port.out.end()).find("WP_RADIUS"), std::string::npos);
}

TEST_F(Apm1Flight, the_radio_can_be_silenced_and_heard_again) {
    run(command(0x34, 0));
    EXPECT_TRUE(telemetryMuted());
    radioHeard();
    EXPECT_FALSE(telemetryMuted());
}

TEST_F(Apm1Flight, a_servo_pulse_is_held_at_800_at_least_and_0_is_no_pulse) {
    fly({waypoint(500), command(0x82, 4, 1300), command(0x82, 5, 1), command(0x82, 6, 0)});
    EXPECT_EQ(outputPulse_us(5), 1300);
    EXPECT_EQ(outputPulse_us(6), 800);
    EXPECT_EQ(outputPulse_us(7), 0);
}

TEST_F(Apm1Flight, the_throttle_is_never_taken_while_armed) {
    (void)statusTexts();
    run(command(0x82, 2, 1300));
    EXPECT_NE(outputPulse_us(3), 1300);
    EXPECT_TRUE(hasStatusText("output 3 refused"));
}

TEST_F(Apm1Flight, a_servo_pulse_may_be_set_on_every_other_output_until_the_mode_changes) {
    for (uint8_t output : {1, 2, 4, 5, 6, 7, 8}) {
        requestMode(Mode::loiter, ModeReason::pilot);
        run(command(0x82, float(output - 1), 1300));
        EXPECT_EQ(outputPulse_us(output), 1300) << int(output);
        requestMode(Mode::loiter, ModeReason::pilot);
        pass();
        EXPECT_NE(outputPulse_us(output), 1300) << int(output);
    }
}

TEST_F(Apm1Flight, the_throttle_is_not_taken_even_from_a_disarmed_airplane) {
    mutable_vehicle.armed = mutable_vehicle.estimate.flying = false;
    (void)statusTexts();
    run(command(0x82, 2, 1300));
    EXPECT_NE(outputPulse_us(3), 1300);
    EXPECT_TRUE(hasStatusText("Mission: output 3 refused"));
}

TEST_F(Apm1Flight, jumps_to_one_fly_round_and_round) {
    fly({waypoint(500), waypoint(900), command(0x31)});
    int flown[4];
    for (int& item : flown) {
        item = missionCurrent();
        reach();
    }
    EXPECT_EQ(flown[0], 1);
    EXPECT_EQ(flown[1], 2);
    EXPECT_EQ(flown[2], 1);
    EXPECT_EQ(flown[3], 2);
}

}  // namespace
}  // namespace firmware
