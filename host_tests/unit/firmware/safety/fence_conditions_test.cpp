// SPDX-License-Identifier: GPL-3.0-or-later
// Decisions of two conditions and more about the fence, each as a truth table. What is wanted is
// what docs/fence.md says.
#include <vector>

#include "fence_bench.hpp"
#include "firmware/safety/fence.hpp"
#include "hal/eeprom.hpp"
#include "truth_table.hpp"

namespace firmware {
namespace {

using bench::all;
using bench::any;
using bench::Bits;
using bench::Set;

constexpr int16_t kFloor_m = 30, kCeiling_m = 120;

struct Fenced : FenceBench {
    void SetUp() override {
        fakes::reset();
        FenceBench::SetUp();
        parameters.fence_min_m = kFloor_m;
        parameters.fence_max_m = kCeiling_m;
        raise();
        requestMode(Mode::fbwa, ModeReason::pilot);
    }
    // A fence in its place whose return point is outside.
    static void fit(bool is) {
        if (is) return;
        ASSERT_EQ(store(MavMissionType::fence, square(beside(kSide_e7 + 9, 0))),
                  MissionResult::accepted);
        tenths(8);
        ASSERT_EQ(fenceLine(), Line::unfit);
    }
    static Items withoutReturnPoint() {
        Items corners = square();
        corners.erase(corners.begin());
        return corners;
    }
    static void keepEepromBusy() {
        fakes::setEepromSlow(true);
        const uint8_t other = fakes::eepromCell(100) ^ 1;
        EXPECT_EQ(hal::eepromWrite(100, &other, 1), core::Status::ok);
    }
    static void switchedOff(bool is) {
        if (!is) return;
        EXPECT_TRUE(fenceEnable(0));
    }
    static void switchedOn(bool is) { switchedOff(!is); }
    static void isOutside(bool is) { is ? leave() : comeBack(); }
    static void isAt(float height_m) {
        mutable_vehicle.estimate.height_m = height_m;
        tenths(1);
    }
    static bool isBroken() {
        tenths(6);
        return fenceReport().breach != Breach::none;
    }
};
struct FenceConditions : bench::TruthTable<Fenced> {};

void action(int8_t is) { parameters.fence_action = is; }
void hasAction(bool is) { action(is ? 2 : 0); }
void armed(bool is) { mutable_vehicle.armed = is; }
void flying(bool is) { mutable_vehicle.estimate.flying = is; }
void placeKnown(bool is) { mutable_vehicle.estimate.known = is; }
void tooHigh(bool is) { mutable_vehicle.estimate.height_m = is ? kCeiling_m + 1 : kCeiling_m; }
void outside(bool is) {
    mutable_vehicle.estimate.position = is ? beside(kSide_e7 + 10, 0) : beside(0, 0);
}
void limited(bool is) { parameters.fence_max_m = is ? kCeiling_m : kFloor_m; }

// ---- when it is broken

TEST_F(FenceConditions, of_a_broken_fence_turn_it_alone) {
    check({{"broken",
            {switchedOn, fit, hasAction, armed, flying, placeKnown, outside, tooHigh},
            isBroken,
            [](const Bits& is) {
                return is[0] && is[1] && is[2] && is[3] && is[4] && is[5] && (is[6] || is[7]);
            }}});
}

// Both limits only when the upper one is larger; the lower one after the airplane has been above it
// in this flight.
TEST_F(FenceConditions, of_the_height_limits_turn_them_alone) {
    check({{"too high",
            {[](bool is) { parameters.fence_min_m = is ? kFloor_m : kCeiling_m; }, tooHigh},
            isBroken,
            all},
           {"too low",
            {limited,
             [](bool is) {
                 mutable_vehicle.estimate.height_m = kFloor_m;
                 (void)fenceEnable(1);  // forgets what was above it before
                 EXPECT_TRUE(fenceEnable(is ? 1 : 2));
             },
             [](bool is) { isAt(is ? kFloor_m + 1 : kFloor_m); },
             [](bool is) {
                 if (is) return;
                 flying(false);
                 tenths(1);
                 flying(true);
             },
             [](bool is) { mutable_vehicle.estimate.height_m = is ? kFloor_m - 1 : kFloor_m; }},
            isBroken,
            all}});
}

TEST_F(FenceConditions, of_a_report_turn_it_alone) {
    static int before;
    const std::vector<Set> before_and_now = {[](bool is) {
                                                 action(2);
                                                 isOutside(is);
                                                 before = fenceReport().breaches;
                                                 (void)statusTexts();
                                             },
                                             isOutside};
    check({{"a text", before_and_now, [] { return hasStatusText("Fence"); },
            [](const Bits& is) { return is[0] != is[1]; }},
           {"one more", before_and_now, [] { return fenceReport().breaches == before + 1; },
            [](const Bits& is) { return !is[0] && is[1]; }}});
}

// ---- what is then done

TEST_F(FenceConditions, of_the_return_turn_it_alone) {
    static float height_m;
    const std::vector<Set> heights = {[](bool is) { parameters.fence_return_m = is ? 60 : 0; },
                                      limited,
                                      [](bool is) { parameters.rtl_height_cm = is ? -1 : 9000; },
                                      [](bool) {
                                          height_m = vehicle.estimate.height_m;
                                          leave();
                                      }};
    const auto decided = [&](const char* what, bool (*taken)(), bool (*wanted)(const Bits&)) {
        (void)table({what, heights, taken, wanted});
    };
    decided(
        "at FENCE_RETALT", [] { return vehicle.demand.height_m == 60; },
        [](const Bits& is) { return is[0]; });
    decided(
        "midway between the limits",
        [] { return vehicle.demand.height_m == (kFloor_m + kCeiling_m) / 2; },
        [](const Bits& is) { return !is[0] && is[1]; });
    decided(
        "at the present height", [] { return vehicle.demand.height_m == height_m; },
        [](const Bits& is) { return !is[0] && !is[1] && is[2]; });
    decided(
        "at ALT_HOLD_RTL", [] { return vehicle.demand.height_m == 90; },
        [](const Bits& is) { return !is[0] && !is[1] && !is[2]; });
}

// The return point may first have to be read; without one home is returned to at once.
TEST_F(FenceConditions, of_turning_back_turn_it_alone) {
    check({{"turned back",
            {[](bool has_none) {
                 if (has_none) raise(withoutReturnPoint());
             },
             [](bool can_be_read) {
                 if (!can_be_read) keepEepromBusy();
             }},
            [] {
                const bool done = fenceTurnBack();
                EXPECT_EQ(vehicle.mode != Mode::fbwa, done);
                return done;
            },
            any}});
}

TEST_F(FenceConditions, of_what_the_sticks_have_no_say_in_turn_it_alone) {
    const auto no_mode_chosen = [](bool is) {
        if (is) return;
        requestMode(Mode::loiter, ModeReason::ground);
        tenths(1);
    };
    const auto throttle_too = [](bool is) {
        action(is ? 1 : 3);
        tenths(1);
    };
    check({{"roll and pitch", {isOutside, no_mode_chosen}, [] { return vehicle.fence_holds; }, all},
           {"the throttle is the pilot's",
            {isOutside, no_mode_chosen, throttle_too},
            [] { return vehicle.fence_throttle; },
            [](const Bits& is) { return is[0] && is[1] && !is[2]; }}});
}

TEST_F(FenceConditions, of_the_mode_that_is_given_back_turn_it_alone) {
    static bool off;
    const std::vector<Set> conditions = {isOutside,
                                         [](bool is) {
                                             if (!is) requestMode(Mode::loiter, ModeReason::ground);
                                             tenths(1);
                                         },
                                         [](bool is) { off = is; }};
    static const auto is_given_back = [] {
        const uint8_t entries = vehicle.mode_entries;
        switchedOff(off);
        tenths(2);
        return vehicle.mode_entries != entries && vehicle.mode == Mode::fbwa;
    };
    check({{"after it has turned back", conditions, [] { return is_given_back(); }, all},
           {"after it has turned back twice", conditions,
            [] {
                if (vehicle.fence_holds) {
                    comeBack();
                    leave();
                }
                return is_given_back();
            },
            all}});
}

// ---- when it is on

TEST_F(FenceConditions, of_its_switch_turn_it_alone) {
    const auto not_lost = [](bool is) { mutable_vehicle.radio.lost = !is; };
    check({{"switched on",
            {switchedOff, [](bool is) { parameters.fence_channel = is ? 7 : 0; },
             [](bool is) { receiveSwitch(is ? 1751 : 1750); }, not_lost},
            [] {
                tenths(1);
                return fenceOn();
            },
            [](const Bits& is) { return !is[0] || (is[1] && is[2] && is[3]); }},
           {"switched off",
            {[](bool is) {
                 parameters.fence_channel = 7;
                 moveSwitch(1900);
                 parameters.fence_channel = is ? 7 : 0;
             },
             [](bool is) { receiveSwitch(is ? 1100 : 1900); }, not_lost},
            [] {
                tenths(1);
                return !fenceOn();
            },
            all}});
}

// A new one is looked at first: at its records, and in the next tenth at its return point.
TEST_F(FenceConditions, of_when_it_is_looked_after_turn_it_alone) {
    static bool has_return_point, looked_at;
    check({{"its switch is followed",
            {[](bool has) { has_return_point = has; },
             [](bool is_new) {
                 switchedOff(true);
                 parameters.fence_channel = 7;
                 receiveSwitch(1900);
                 if (!is_new) return;
                 const Items items = has_return_point ? square() : withoutReturnPoint();
                 EXPECT_EQ(store(MavMissionType::fence, items), MissionResult::accepted);
             },
             [](bool was) { looked_at = was; },
             [](bool is_busy) {
                 if (is_busy) keepEepromBusy();
             }},
            [] {
                for (int looks = looked_at ? 2 : 1; looks > 0; --looks) runFence();
                return hasStatusText("Fence on");
            },
            [](const Bits& is) { return !is[1] || (!is[3] && (is[2] || !is[0])); }}});
}

TEST_F(FenceConditions, of_a_flight_that_switches_it_turn_it_alone) {
    const auto enabled = [](bool is) { parameters.fence_auto_enable = is; };
    const auto automatic = [](bool is) {
        mutable_vehicle.mode = is ? Mode::automatic : Mode::loiter;
    };
    check({{"on after the take-off",
            {[](bool is) {
                 switchedOff(true);
                 parameters.fence_auto_enable = is;
             },
             automatic,
             [](bool is) {
                 mutable_vehicle.demand.path = is ? Path::takeoff : Path::leg;
                 tenths(1);
             },
             automatic,
             [](bool is) { mutable_vehicle.demand.path = is ? Path::leg : Path::takeoff; }},
            [] {
                tenths(1);
                return fenceOn();
            },
            all},
           {"off before the landing",
            {switchedOn, enabled, automatic,
             [](bool is) {
                 (void)statusTexts();
                 mutable_vehicle.demand.path = is ? Path::land : Path::leg;
             }},
            [] {
                tenths(1);
                return hasStatusText("Fence off");
            },
            all}});
}

TEST_F(FenceConditions, of_an_order_that_is_obeyed_turn_it_alone) {
    static uint16_t order;
    const auto off = [](bool is) {
        if (is) order = 0;
    };
    const auto none = [](bool is) {
        if (is) order = 3;
    };
    const auto obeyed = [] { return fenceEnable(order); };
    const auto wanted = [](const Bits& is) { return !is[2] && (is[1] || is[0]); };
    check({{"on",
            {[](bool is) {
                 order = 1;
                 fit(is);
             },
             off, none},
            obeyed,
            wanted},
           {"the floor off",
            {[](bool is) {
                 order = 2;
                 fit(is);
             },
             off, none},
            obeyed,
            wanted}});
}

TEST_F(FenceConditions, of_a_fence_that_stands_against_arming_turn_it_alone) {
    const auto switch_up = [](bool is) {
        parameters.fence_channel = 7;
        if (is) moveSwitch(1900);
    };
    check({{"stands against arming",
            {switchedOn, [](bool is) { fit(!is); }, switch_up, hasAction,
             [](bool is) { parameters.fence_auto_enable = is; }},
            fenceBad,
            [](const Bits& is) { return is[1] && is[3] && (is[0] || is[2] || is[4]); }}});
}

TEST_F(FenceConditions, of_a_fence_that_is_there_turn_it_alone) {
    static bool looked_at;
    check({{"there",
            {[](bool is) {
                 EXPECT_EQ(store(MavMissionType::fence, is ? square() : Items()),
                           MissionResult::accepted);
             },
             [](bool is) { looked_at = is; }},
            [] {
                if (looked_at) tenths(3);
                return fenceThere();
            },
            all}});
}

}  // namespace
}  // namespace firmware
