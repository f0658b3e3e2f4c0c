// SPDX-License-Identifier: GPL-3.0-or-later
// Decisions of two conditions and more about the receiver, each as a truth table. What is wanted is
// said by docs/failsafes.md (when the radio is lost), docs/mavlink.md (who has the sticks) and
// radio.hpp (which frame moves a switch).
#include <vector>

#include "firmware/sensors/radio.hpp"
#include "firmware/sensors/rc_override.hpp"
#include "firmware_bench.hpp"
#include "hal/clock.hpp"
#include "truth_table.hpp"

namespace {

using namespace firmware::sensors;
using bench::all;
using bench::Bits;
using firmware::state::Mode;
using firmware::state::mutable_vehicle;
using firmware::state::parameters;
using firmware::state::vehicle;

constexpr uint16_t kNotHeld = UINT16_MAX;
constexpr uint16_t kFailsafe_us = 950;  // THR_FS_VALUE

// What the next frames have, and what the ground station holds.
struct Hands {
    std::vector<uint16_t> sticks = bench::kCentred;
    uint16_t ground[8] = {kNotHeld, kNotHeld, kNotHeld, kNotHeld,
                          kNotHeld, kNotHeld, kNotHeld, kNotHeld};
    int frames = 1;
    bool whole = true;
};
Hands hands;

struct Received : bench::Bench {
    void SetUp() override {
        rcOverrideRelease();
        Bench::SetUp();
        hands = {};
        parameters.throttle_failsafe = 1;
        parameters.throttle_failsafe_us = kFailsafe_us;
    }
};
struct RadioConditions : bench::TruthTable<Received> {};

// A frame every 20 ms, as the task table has it: its pulses are read in one run, whether it was
// whole in the next.
void receiveFrame() {
    hands.whole ? fakes::receiveRc(hands.sticks) : fakes::receiveBrokenRc(hands.sticks);
    runRadio();
    fakes::advance_ms(10);
    runRadio();
    fakes::advance_ms(10);
}
void receiveFrames() {
    for (int i = 0; i < hands.frames; ++i) receiveFrame();
}
void receiveThrottle(bool good) {
    hands.sticks[2] = good ? kFailsafe_us : kFailsafe_us - 1;
    receiveFrame();
}

void throttleFailsafe(bool is) { parameters.throttle_failsafe = is; }
void throttleBelow(bool is) { hands.sticks[2] = is ? kFailsafe_us - 1 : kFailsafe_us; }
void throttleNotBelow(bool is) { throttleBelow(!is); }
void comeTwice(bool are) { hands.frames = are ? 2 : 1; }

// Roll, pitch and throttle: what stands in for a receiver.
void groundHoldsSticks(bool does) {
    if (!does) return;
    for (int i = 0; i < 3; ++i) hands.ground[i] = hands.sticks[i];
    setRcOverride(hands.ground);
}

// ---- when the radio is lost

// No frame for 1 s, or ten throttle pulses under THR_FS_VALUE in a row (THR_FAILSAFE). A ground
// station that holds the sticks is a receiver, too.
TEST_F(RadioConditions, of_a_lost_radio_turn_it_alone) {
    static bool silent;
    check(
        {{"lost",
          {throttleFailsafe, throttleBelow, [](bool are) { hands.frames = are ? 10 : 9; },
           [](bool is) { silent = is; }, groundHoldsSticks},
          [] {
              if (silent) fakes::advance_ms(1000);
              for (int i = 0; i < hands.frames; ++i) {
                  if (!silent) fakes::receiveRc(hands.sticks);
                  runRadio();
              }
              return vehicle.radio.lost;
          },
          [](const Bits& is) { return (is[0] && is[1] && is[2]) || (is[3] && !is[4]); }},
         {"lost by the silence of a second",
          {[](bool is) { fakes::advance_ms(is ? 990 : 980); },  // since 10 ms after the last frame
           [](bool does) { groundHoldsSticks(!does); }},
          [] {
              runRadio();
              return vehicle.radio.lost;
          },
          all}});
}

TEST_F(RadioConditions, of_a_radio_that_is_back_turn_it_alone) {
    static bool second_good, third_comes;
    const std::vector<bench::Set> three_in_a_row = {[](bool is) { second_good = is; },
                                                    [](bool is) { third_comes = is; }};
    static const auto receive_up_to_three = [] {
        receiveThrottle(true);
        receiveThrottle(second_good);
        if (third_comes) receiveThrottle(true);
    };
    check({{"back after it was lost", three_in_a_row,
            [] {
                for (int i = 0; i < 10; ++i) receiveThrottle(false);
                EXPECT_TRUE(vehicle.radio.lost);
                receive_up_to_three();
                return !vehicle.radio.lost;
            },
            all},
           {"obeyed again after one pulse that was low", three_in_a_row,
            [] {
                receiveThrottle(false);
                hands.sticks[0] = 1900;
                receive_up_to_three();
                return vehicle.radio.roll_cd == 4500;
            },
            all}});
}

// Of a single channel the other sticks would stay where they were; a ground station that falls
// silent must not hold the airplane in its last turn.
TEST_F(RadioConditions, of_a_ground_station_that_flies_turn_it_alone) {
    check({{"stands in for the receiver",
            {[](bool is) { hands.ground[0] = is ? 1600 : kNotHeld; },
             [](bool is) { hands.ground[1] = is ? 1600 : kNotHeld; },
             [](bool is) { hands.ground[2] = is ? 1600 : kNotHeld; },
             [](bool is) {
                 setRcOverride(hands.ground);
                 fakes::advance_ms(is ? 3000 : 3001);
             }},
            [] {
                runRadio();
                return !vehicle.radio.lost;
            },
            all}});
}

// ---- the sticks

TEST_F(RadioConditions, of_sticks_that_are_obeyed_turn_it_alone) {
    static bool comes;
    check({{"the roll stick is obeyed",
            {throttleNotBelow, [](bool is) { comes = is; },
             [](bool does) {
                 hands.sticks[0] = 1900;
                 groundHoldsSticks(does);
             }},
            [] {
                if (comes) fakes::receiveRc(hands.sticks);
                runRadio();
                return vehicle.radio.roll_cd == 4500;
            },
            [](const Bits& is) { return is[0] && (is[1] || is[2]); }}});
}

// RCn_DZ is a dead zone where an attitude is held; in MANUAL the stick is the surface.
TEST_F(RadioConditions, of_a_stick_that_deflects_turn_it_alone) {
    const auto manual = [](bool is) {
        mutable_vehicle.mode = is ? Mode::manual : Mode::fbwa;
        parameters.channel[0].dead_zone_us = 30;
    };
    static const auto deflects = [] {
        receiveFrame();
        return vehicle.radio.roll_cd != 0;
    };
    const auto outside = [](const Bits& is) { return is[0] || (is[1] && is[2]); };
    check({{"above its trim",
            {manual, [](bool is) { hands.sticks[0] = is ? 1531 : 1530; },
             [](bool is) { parameters.channel[0].max_us = is ? 1900 : 1530; }},
            [] { return deflects(); },
            outside},
           {"below its trim",
            {manual, [](bool is) { hands.sticks[0] = is ? 1469 : 1470; },
             [](bool is) { parameters.channel[0].min_us = is ? 1100 : 1470; }},
            [] { return deflects(); },
            outside}});
}

TEST_F(RadioConditions, of_which_way_a_stick_goes_turn_it_alone) {
    const auto either = [](const Bits& is) { return is[0] != is[1]; };
    check({{"to the right",
            {[](bool is) { hands.sticks[0] = is ? 1900 : 1100; },
             [](bool is) { parameters.channel[0].reverse = is ? -1 : 1; }},
            [] {
                receiveFrame();
                EXPECT_NE(vehicle.radio.roll_cd, 0);
                return vehicle.radio.roll_cd > 0;
            },
            either},
           {"open",
            {[](bool is) { hands.sticks[2] = is ? 1900 : 1100; },
             [](bool is) { parameters.channel[2].reverse = is ? -1 : 1; }},
            [] {
                receiveFrame();
                return vehicle.radio.throttle_pct == 100;
            },
            either}});
}

// ---- the switches

bool switchHasMoved() { return modeSwitchPosition() == 2; }

// A frame moves a switch when it is whole and the next one shows the same, or when the switch is
// turned slowly. A ground station that holds the channel needs no frame for it. Neither counts
// while the throttle is below THR_FS_VALUE: the frames may be the encoder's own.
TEST_F(RadioConditions, of_a_switch_that_is_moved_turn_it_alone) {
    const auto ground_holds_it = [](bool does) {
        if (!does) return;
        hands.ground[7] = 1300;
        setRcOverride(hands.ground);
    };
    const auto slowly = [](bool is) {
        for (int i = 0; i < 2; ++i) {
            hands.sticks[7] = 1210;
            receiveFrame();
        }
        EXPECT_EQ(modeSwitchPosition(), 1);
        hands.sticks[7] = is ? 1260 : 1261;
    };
    check(
        {{"the switch is moved",
          {slowly, throttleNotBelow, comeTwice, [](bool is) { hands.whole = is; }, ground_holds_it},
          [] {
              receiveFrames();
              return switchHasMoved();
          },
          [](const Bits& is) { return is[1] && (is[4] || (is[3] && (is[0] || is[2]))); }}});
}

// The encoder's own frames are whole. What came while the radio was lost is not read later either.
TEST_F(RadioConditions, of_frames_whose_switches_count_turn_it_alone) {
    static bool lost, obeyed_before;
    check({{"the switches of a frame count",
            {throttleNotBelow, [](bool is) { lost = !is; }, [](bool is) { obeyed_before = is; }},
            [] {
                hands.sticks[7] = 1300;
                for (int i = 0; i < 2; ++i) {
                    fakes::receiveRc(hands.sticks);
                    runRadio();
                    const bool heard = vehicle.radio.heard;
                    mutable_vehicle.radio.lost = lost;
                    if (!obeyed_before) mutable_vehicle.radio.heard = false;
                    runRadio();
                    mutable_vehicle.radio.lost = false;
                    mutable_vehicle.radio.heard = heard;
                }
                runRadio();
                return switchHasMoved();
            },
            all}});
}

TEST_F(RadioConditions, of_where_a_switch_stands_turn_it_alone) {
    const auto not_lost = [](bool is) { mutable_vehicle.radio.lost = !is; };
    static int8_t channel;
    check({{"the mode switch has a position",
            {[](bool is) {
                 hands.sticks[7] = is ? 901 : 900;
                 hands.frames = 2;
                 receiveFrames();
             },
             not_lost, [](bool is) { mutable_vehicle.radio.heard = is; }},
            [] { return modeSwitchPosition() != 0; },
            all},
           {"a switch is up",
            {[](bool is) {
                 hands.sticks[6] = is ? 1751 : 1750;
                 hands.frames = 2;
                 receiveFrames();
             },
             not_lost, [](bool is) { channel = is ? 7 : 0; }},
            [] { return switchIsUp(channel); },
            all}});
}

}  // namespace
