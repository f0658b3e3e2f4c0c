// SPDX-License-Identifier: GPL-3.0-or-later
// Decisions of two conditions and more after a restart in the air, and which step waits for which,
// each as a truth table. What is wanted is what docs/restart.md says.
#include <vector>

#include "firmware/estimator/estimator.hpp"
#include "restart_bench.hpp"
#include "truth_table.hpp"

namespace {

using namespace bench;

struct Restarted : RestartBench {
    // The second of the frames shows a position that lasts; no time passes.
    static void receiveSwitch(uint16_t pulse_us) {
        for (int i = 0; i < 2; ++i) {
            fakes::receiveRc(with(8, pulse_us));
            runRadio();
            runRadio();
        }
    }
    static void resumeAfter(bool known_time) {
        begin(known_time ? ResetCause::watchdog : ResetCause::unknown);
    }
    // Decided: without an attitude the mode is not, for 450 ms.
    static void attitudeKnown(bool is) { mutable_vehicle.attitude.aligned = is; }
    static SavedHome savedHome() {
        SavedHome home = {};
        if (readHome(home) != core::Status::ok) home = {};
        return home;
    }
};
struct RestartConditions : bench::TruthTable<Restarted> {};

void sees(bool barometer) { barometerReads(barometer ? 60 : 1); }
void receiverSees(bool is) {
    mutable_vehicle.gps.healthy = true;
    mutable_vehicle.gps.fixes = 6;
    mutable_vehicle.gps.ground_speed_mps = is ? 14 : 1;
}
void armed(bool is) { mutable_vehicle.armed = is; }

// ---- the mode

// After three equal readings of the switch, or 0.2 s; but with an attitude, or 0.45 s. Until then
// nothing is armed or recorded.
TEST_F(RestartConditions, of_a_mode_that_is_decided_turn_it_alone) {
    static bool late, latest;
    static int looks;
    check({{"decided",
            {[](bool is_there) {
                 begin(ResetCause::watchdog);
                 fakes::advance_ms(10);
                 is_there ? receiveSwitch(1165) : receiveSwitch(900);
             },
             [](bool are_three) { looks = are_three ? 3 : 2; }, [](bool is) { late = is; },
             attitudeKnown, [](bool is) { latest = is; }},
            [] {
                fakes::advance_ms((latest ? 450 : late ? 449 : 199) - hal::now_ms());
                const uint8_t number = newestFastRecord().number;
                for (int i = 0; i < looks; ++i) runRestart();
                const bool decided = vehicle.mode != Mode::initialising;
                EXPECT_EQ(vehicle.resuming, !decided);
                EXPECT_EQ(vehicle.armed, decided);
                EXPECT_EQ(newestFastRecord().number != number, decided);
                return decided;
            },
            [](const Bits& is) { return is[4] || (is[3] && (is[2] || (is[0] && is[1]))); }}});
}

// The switch's, or the one that was flown; FBWA when it cannot be entered. Once 0.2 s are over, the
// first reading decides, and is not one of three.
TEST_F(RestartConditions, of_which_mode_is_flown_on_in_turn_it_alone) {
    static bool three;
    const std::vector<Set> conditions = {
        [](bool is_there) {
            requestMode(Mode::acro, ModeReason::pilot);
            keep();
            begin(ResetCause::watchdog);
            fakes::advance_ms(10);
            receiveSwitch(is_there ? 1165 : 900);
        },
        [](bool are) { three = are; },
        [](bool is_one) {
            constexpr int8_t kNoMode = 9;
            parameters.switch_mode[0] = is_one ? static_cast<int8_t>(Mode::stabilize) : kNoMode;
        }};
    static const auto flown = [] {
        fakes::advance_ms(three ? 100 : 190);
        for (int i = 0; i < 3; ++i) runRestart();
        fakes::advance_ms(90);
        runRestart();
        return vehicle.mode;
    };
    check({{"the switch's", conditions, [] { return flown() == Mode::stabilize; }, all},
           {"FBWA instead", conditions, [] { return flown() == Mode::fbwa; },
            [](const Bits& is) { return is[0] && is[1] && !is[2]; }}});
    (void)table({"the one that was flown", conditions, [] { return flown() == Mode::acro; },
                 [](const Bits& is) { return !is[0] || !is[1]; }});
}

// ---- armed again

// With a known time as soon as the mode is decided, else by evidence; in the same run.
TEST_F(RestartConditions, of_being_armed_again_turn_it_alone) {
    check({{"armed again",
            {resumeAfter, attitudeKnown, sees, receiverSees},
            [] {
                lookAtSwitch(1165);
                return vehicle.armed;
            },
            [](const Bits& is) { return is[1] && (is[0] || is[2] || is[3]); }}});
}

// 2 s for barometer and airspeed sensor, 30 s for the receiver.
TEST_F(RestartConditions, of_evidence_in_time_turn_it_alone) {
    static uint32_t until_ms;
    check({{"armed again",
            {[](bool within_30_s) {
                 resumeAfter(false);
                 lookAtSwitch(1165);
                 sees(false);
                 until_ms = within_30_s ? 29990 : 30010;
             },
             [](bool within_2_s) {
                 if (within_2_s && until_ms < 30000) until_ms = 1990;
                 runUntil_ms(until_ms);
             },
             sees, receiverSees},
            [] {
                runRestart();
                return vehicle.armed;
            },
            [](const Bits& is) { return is[0] && ((is[1] && is[2]) || is[3]); }}});
}

TEST_F(RestartConditions, of_the_text_that_it_stays_disarmed_turn_it_alone) {
    static uint32_t until_ms;
    check({{"Not armed again",
            {[](bool unknown_time) {
                 resumeAfter(!unknown_time);
                 lookAtSwitch(1165);
                 (void)statusTexts();
             },
             [](bool not_seen) { sees(!not_seen); },
             [](bool not_by_the_pilot) {
                 runUntil_ms(1000);
                 if (!not_by_the_pilot) armed(true);
             },
             [](bool had_30_s) { until_ms = had_30_s ? 30010 : 29990; }},
            [] {
                runUntil_ms(until_ms);
                for (const std::string& text : statusTexts())
                    if (text.find("Not armed again: not seen flying") != std::string::npos)
                        return true;
                return false;
            },
            all}});
}

// ---- what the next restart finds

// After 2 s without evidence the flight is forgotten, unless the receiver sees it then. With the
// inertial sensor dead as well, where no other record would be written.
TEST_F(RestartConditions, of_a_flight_that_another_restart_finds_turn_it_alone) {
    static bool aligned;
    for (const bool is : {true, false}) {
        aligned = is;
        check({{"found",
                {[](bool within_2_s) {
                     resumeAfter(false);
                     lookAtSwitch(1165);
                     sees(false);
                     attitudeKnown(aligned);
                     runUntil_ms(1980);
                     fakes::advance_ms(within_2_s ? 10 : 20);
                 },
                 receiverSees},
                [] {
                    mutable_vehicle.estimate.ground_speed_mps = 14;
                    for (int i = 0; i < 2; ++i) runRestart();
                    begin(ResetCause::watchdog);
                    return flyingOn();
                },
                any}});
    }
}

TEST_F(RestartConditions, of_a_moving_record_that_is_written_turn_it_alone) {
    static const auto written = [] {
        const uint8_t before = newestFastRecord().number;
        for (int i = 0; i < 2; ++i) runRestart();
        return newestFastRecord().number != before;
    };
    check({{"written",
            {[](bool one_before) {
                 begin(ResetCause::asked);
                 requestMode(Mode::manual, ModeReason::boot);
                 armed(true);
                 if (one_before) keep();
             },
             [](bool is_decided) {
                 if (!is_decided) mutable_vehicle.mode = Mode::initialising;
             },
             armed, attitudeKnown},
            [] { return written(); },
            [](const Bits& is) { return is[1] && is[2] && (is[0] || is[3]); }},
           {"written after a restart in the air",
            {resumeAfter, attitudeKnown, sees},
            [] {
                lookAtSwitch(1165);
                return written();
            },
            [](const Bits& is) { return is[1] && (is[0] || is[2]); }}});
}

// Half a record of each would be a place that never was.
TEST_F(RestartConditions, of_a_steady_record_that_is_written_turn_it_alone) {
    check({{"written",
            {attitudeKnown,
             [](bool is_decided) {
                 if (!is_decided) mutable_vehicle.mode = Mode::initialising;
             }},
            [] {
                mutable_vehicle.home.altitude_cm = 1;
                runRestartSlowly();
                return records.slow.home_altitude_cm == 1;
            },
            all}});
}

// ---- home in the EEPROM

// A flight that goes on is neither begun nor over before it is decided whether it is armed again.
TEST_F(RestartConditions, of_a_home_that_is_saved_or_forgotten_turn_it_alone) {
    const auto not_awaited = [](bool is) {
        resumeAfter(is);
        lookAtSwitch(1165);
    };
    const auto decided = [](bool is) { mutable_vehicle.resuming = !is; };
    check(
        {{"saved",
          {not_awaited, decided, armed, [](bool is_set) { mutable_vehicle.home.set = is_set; },
           [](bool has_moved) { mutable_vehicle.home.position.latitude_e7 += has_moved ? 10 : 0; }},
          [] {
              runRestartSlowly();
              return savedHome().position.latitude_e7 == kHome.latitude_e7 + 10;
          },
          all},
         {"forgotten",
          {not_awaited, decided, [](bool is) { armed(!is); }},
          [] {
              runRestartSlowly();
              return savedHome().position.latitude_e7 == 0;
          },
          all}});
}

TEST_F(RestartConditions, of_a_home_that_is_written_again_turn_it_alone) {
    check({{"written again",
            {[](bool north) { mutable_vehicle.home.position.latitude_e7 += north; },
             [](bool east) { mutable_vehicle.home.position.longitude_e7 += east; },
             [](bool higher) { mutable_vehicle.home.altitude_cm += higher; }},
            [] {
                const uint32_t writes = fakes::eepromWrites();
                runRestartSlowly();
                return fakes::eepromWrites() != writes;
            },
            any}});
}

// The record's where the flight goes on, else the one in the EEPROM.
TEST_F(RestartConditions, of_a_home_that_is_known_again_turn_it_alone) {
    static bool in_the_air;
    check({{"known again",
            {[](bool is) { in_the_air = is; },
             [](bool was_set) {
                 mutable_vehicle.home.set = was_set;
                 keep();
             },
             [](bool is_saved) {
                 EXPECT_EQ(is_saved ? core::Status::ok : forgetHome(), core::Status::ok);
             }},
            [] {
                if (!in_the_air) invalidate(records.slow);
                begin(ResetCause::power_on);
                EXPECT_EQ(flyingOn(), in_the_air);
                return vehicle.home.set;
            },
            [](const Bits& is) { return is[0] ? is[1] : is[2]; }}});
}

// ---- how it is reported

// Critical while it flies, else a warning when memory has survived; at the supply neither.
TEST_F(RestartConditions, of_how_a_start_is_reported_turn_it_alone) {
    const std::vector<Set> conditions = {
        [](bool is) {
            armed(is);
            keep();
        },
        [](bool survived) {
            begin(survived ? ResetCause::watchdog : ResetCause::power_on);
            (void)statusTexts();
        }};
    static const auto severity = [] {
        runRestartSlowly();
        return statusTexts().at(0).at(0);
    };
    (void)table({"critical", conditions, [] { return severity() == '2'; },
                 [](const Bits& is) { return is[0]; }});
    check({{"a warning", conditions, [] { return severity() == '4'; },
            [](const Bits& is) { return !is[0] && is[1]; }},
           {"not even that", conditions, [] { return severity() == '6'; },
            [](const Bits& is) { return !is[0] && !is[1]; }}});
}

// What an interrupt has seen of a turn counts when it belongs to the record and is long enough for
// a rate.
TEST_F(RestartConditions, of_a_turn_that_was_watched_turn_it_alone) {
    static uint8_t periods;
    check({{"counts",
            {[](bool are_ten) { periods = are_ten ? 10 : 9; },
             [](bool belongs) {
                 records.hang.turn = {{500, 500, 500}, periods};
                 updateChecksum(records.hang, newestFastRecord());
                 if (!belongs) ++records.hang.checksum;
             }},
            [] {
                begin(ResetCause::watchdog);
                mutable_vehicle.imu.calibrated = true;
                for (int i = 0; i < 10; ++i) estimator::rotateDcm();
                return vehicle.attitude.roll_rad.raw != 0;
            },
            all}});
}

}  // namespace
