// SPDX-License-Identifier: GPL-3.0-or-later
// The failsafes' tables as such: every cause alone and every pair of them, in whatever is flown and
// with every setting, against the rules as docs/failsafes.md words them.
#include <vector>

#include "firmware/safety/failsafe.hpp"
#include "firmware/safety/fence.hpp"
#include "firmware/sensors/health.hpp"
#include "firmware_bench.hpp"
#include "host_tests/support/fakes/vehicle.hpp"

namespace {

using firmware::safety::Action;
using firmware::safety::Cause;
using firmware::state::Mode;
using firmware::state::mutable_vehicle;
using firmware::state::parameters;
using firmware::state::vehicle;

constexpr int kNothing = -1;
const uint8_t kFlown[] = {firmware::safety::by_pilot, firmware::safety::by_itself,
                          firmware::safety::circling, firmware::safety::returning,
                          firmware::safety::near_ground};

bool has(uint16_t causes, Cause cause) { return (causes & firmware::safety::bitOf(cause)) != 0; }

struct Setting {
    int8_t short_action, long_action, fence_action;
    bool position, home;
};

// The rules once more, in words and not in rows.
int wanted(uint16_t causes, uint8_t flown, const Setting& set) {
    const bool way_home = set.position && set.home;
    if (has(causes, Cause::inertial)) return int(Action::sticks);
    if (has(causes, Cause::fence) && set.position && set.fence_action % 2 == 1)
        return int(Action::turn_back);
    if (flown == firmware::safety::near_ground) return kNothing;
    if (flown != firmware::safety::returning) {
        if (has(causes, Cause::battery) && way_home) return int(Action::go_home);
        if (has(causes, Cause::blown_back) && flown == firmware::safety::by_itself && way_home)
            return int(Action::go_home);
        const bool by_radio = has(causes, Cause::radio_long);
        if (by_radio || has(causes, Cause::ground_long)) {
            const bool mission = flown == firmware::safety::by_itself;
            if (set.long_action == 2) return int(Action::glide);
            const bool acts = !mission || set.long_action == 1;
            if (acts && way_home) return int(Action::go_home);
            if (mission && by_radio && set.short_action != 0 && way_home)
                return int(Action::go_home);
            if (acts && flown != firmware::safety::circling) return int(Action::circle);
        }
        const bool short_acts = flown == firmware::safety::by_pilot ||
                                (flown == firmware::safety::by_itself && set.short_action != 0);
        if (has(causes, Cause::radio_short) && short_acts)
            return int(set.short_action == 2 ? Action::glide : Action::circle);
    }
    const bool needs_place =
        flown == firmware::safety::by_itself || flown == firmware::safety::returning;
    return has(causes, Cause::no_position) && needs_place ? int(Action::circle) : kNothing;
}

std::vector<Setting> settings() {
    std::vector<Setting> all;
    for (int8_t brief = 0; brief < 3; ++brief)
        for (int8_t lasting = 0; lasting < 3; ++lasting)
            for (int8_t fence = 0; fence < 4; ++fence)
                for (int places = 0; places < 4; ++places)
                    all.push_back({brief, lasting, fence, places % 2 == 1, places / 2 == 1});
    return all;
}

class FailsafeTable : public bench::Bench {
protected:
    static void set(const Setting& setting) {
        parameters.short_action = setting.short_action;
        parameters.long_action = setting.long_action;
        parameters.fence_action = setting.fence_action;
        mutable_vehicle.estimate.known = setting.position;
        mutable_vehicle.home.set = setting.home;
    }
    static int found(uint16_t causes, uint8_t flown) {
        const uint8_t row = firmware::safety::resolve(causes, flown);
        return row == firmware::safety::kNoTransition
                   ? kNothing
                   : int(firmware::safety::kTransitions[row].action);
    }
    // Rows that hold, the first of which acts.
    static int actionsOf(uint16_t causes, uint8_t flown) {
        int actions = 0;
        for (const auto& row : firmware::safety::kTransitions)
            if ((row.causes & causes) && (row.flown & flown) && row.guard())
                actions |= 1 << int(row.action);
        return actions;
    }
};

TEST_F(FailsafeTable, each_cause_alone_and_each_pair_ends_in_the_one_action_of_the_rules) {
    int conflicts = 0;
    for (const Setting& setting : settings()) {
        set(setting);
        for (uint8_t flown : kFlown)
            for (int a = 0; a < firmware::safety::kCauses; ++a)
                for (int b = a; b < firmware::safety::kCauses; ++b) {
                    const auto causes = static_cast<uint16_t>(1 << a | 1 << b);
                    const int action = found(causes, flown);
                    ASSERT_EQ(action, wanted(causes, flown, setting))
                        << "causes " << a << " and " << b << ", flown " << int(flown);
                    const int actions = actionsOf(causes, flown);
                    ASSERT_EQ(action == kNothing, actions == 0);
                    conflicts += (actions & (actions - 1)) != 0;
                }
    }
    EXPECT_GT(conflicts, 1000) << "of pairs that want different things";
}

TEST_F(FailsafeTable, a_second_cause_never_leaves_the_airplane_with_less_than_the_first) {
    for (const Setting& setting : settings()) {
        set(setting);
        for (uint8_t flown : kFlown)
            for (int a = 0; a < firmware::safety::kCauses; ++a)
                for (int b = 0; b < firmware::safety::kCauses; ++b) {
                    const auto one = static_cast<uint16_t>(1 << a);
                    const auto both = static_cast<uint16_t>(1 << a | 1 << b);
                    if (found(one, flown) != kNothing) {
                        ASSERT_NE(found(both, flown), kNothing);
                    }
                }
    }
}

TEST_F(FailsafeTable, without_a_cause_there_is_no_action) {
    for (const Setting& setting : settings()) {
        set(setting);
        for (uint8_t flown : kFlown) EXPECT_EQ(found(0, flown), kNothing);
    }
}

TEST_F(FailsafeTable, every_row_is_the_first_for_something) {
    std::vector<int> used(firmware::safety::kTransitionCount);
    for (const Setting& setting : settings()) {
        set(setting);
        for (uint8_t flown : kFlown)
            for (int a = 0; a < firmware::safety::kCauses; ++a) {
                const uint8_t row = firmware::safety::resolve(static_cast<uint16_t>(1 << a), flown);
                if (row != firmware::safety::kNoTransition) ++used[row];
            }
    }
    for (int row = 0; row < firmware::safety::kTransitionCount; ++row)
        EXPECT_GT(used[row], 0) << "row " << row;
}

// ---- the same by the whole machine, from trigger to mode and back

struct Trigger {
    const char* name;
    Cause cause;
    void (*pull)(bool on);
    int begins_tenths;  // until it acts
};
const Trigger kTriggers[] = {
    {"inertial", Cause::inertial, [](bool on) { mutable_vehicle.imu.healthy = !on; }, 4},
    {"battery", Cause::battery,
     [](bool on) {
         parameters.battery_low_v = 10;
         mutable_vehicle.battery.voltage_mv = on ? 9900 : 12000;
     },
     101},
    {"radio", Cause::radio_short, [](bool on) { mutable_vehicle.radio.lost = on; }, 1},
    {"radio for long", Cause::radio_long, [](bool on) { mutable_vehicle.radio.lost = on; }, 52},
    {"position", Cause::no_position,
     [](bool on) {
         mutable_vehicle.estimate.known = !on;
         mutable_vehicle.estimate.reckoned = on;
     },
     1},
    {"barometer", Cause::barometer, [](bool on) { mutable_vehicle.baro.healthy = !on; }, 1},
    {"airspeed", Cause::airspeed, [](bool on) { mutable_vehicle.airspeed.healthy = !on; }, 1},
    {"compass", Cause::compass, [](bool on) { mutable_vehicle.compass.healthy = !on; }, 1},
    {"headwind", Cause::blown_back, [](bool on) { mutable_vehicle.progress.blown_back = on; }, 101},
};

Mode modeOf(int action, Mode flown) {
    switch (action) {
        case int(Action::sticks):
            return Mode::manual;
        case int(Action::go_home):
            return Mode::rtl;
        case int(Action::glide):
            return Mode::fbwa;
        case int(Action::circle):
            return Mode::circle;
        default:
            return flown;
    }
}

class FailsafeMachine : public FailsafeTable {
protected:
    void SetUp() override {
        FailsafeTable::SetUp();
        parameters.battery_monitor = 3;
        mutable_vehicle.airspeed.healthy = true;
    }
    static void tenths(int count) {
        for (int i = 0; i < count; ++i) {
            firmware::sensors::acceptReading(firmware::sensors::Sensor::inertial,
                                             i % 2 == 0 ? 100 : -100, true);
            firmware::safety::runFailsafe();
            fakes::advance_ms(100);
        }
    }
    static uint16_t causesOf(const Trigger& trigger) {
        uint16_t causes = firmware::safety::bitOf(trigger.cause);
        if (trigger.cause == Cause::radio_long)
            causes |= firmware::safety::bitOf(Cause::radio_short);
        return causes;
    }
    void start(Mode mode) {
        SetUp();
        fly(mode);
        mutable_vehicle.battery.voltage_mv = 12000;
        tenths(2);
        ASSERT_EQ(vehicle.failing, 0);
    }
};

struct FlownMode {
    Mode mode;
    uint8_t flown;
};
const FlownMode kModes[] = {{Mode::fbwa, firmware::safety::by_pilot},
                            {Mode::loiter, firmware::safety::by_itself},
                            {Mode::takeoff, firmware::safety::by_itself},
                            {Mode::circle, firmware::safety::circling},
                            {Mode::rtl, firmware::safety::returning}};

TEST_F(FailsafeMachine, every_pair_of_triggers_at_once_ends_in_one_mode) {
    for (const FlownMode& flown : kModes)
        for (const Trigger& a : kTriggers)
            for (const Trigger& b : kTriggers) {
                start(flown.mode);
                a.pull(true);
                b.pull(true);
                tenths(std::max(a.begins_tenths, b.begins_tenths) + 60);
                uint16_t causes = causesOf(a) | causesOf(b);
                if (has(causes, Cause::radio_short))  // by now it is for long
                    causes |= firmware::safety::bitOf(Cause::radio_long);
                const Setting setting = {0, 0, 0, vehicle.estimate.known, true};
                EXPECT_EQ(vehicle.mode, modeOf(wanted(causes, flown.flown, setting), flown.mode))
                    << a.name << " and " << b.name << " in " << int(flown.mode);
            }
}

TEST_F(FailsafeMachine, order_does_not_matter) {
    for (const FlownMode& flown : kModes)
        for (const Trigger& a : kTriggers)
            for (const Trigger& b : kTriggers) {
                // taken home by its battery the airplane is no longer the pilot's
                const uint16_t pair = causesOf(a) | causesOf(b);
                if (flown.mode == Mode::fbwa && has(pair, Cause::battery) &&
                    has(pair, Cause::no_position))
                    continue;
                Mode ends[2];
                for (int turn = 0; turn < 2; ++turn) {
                    start(flown.mode);
                    (turn == 0 ? a : b).pull(true);
                    tenths(170);
                    (turn == 0 ? b : a).pull(true);
                    tenths(170);
                    ends[turn] = vehicle.mode;
                }
                EXPECT_EQ(ends[0], ends[1])
                    << a.name << " and " << b.name << " in " << int(flown.mode);
            }
}

TEST_F(FailsafeMachine, the_position_back_everything_is_flown_on) {
    for (Mode mode : {Mode::rtl, Mode::loiter}) {
        start(mode);
        const geo::Position centre = vehicle.demand.to;
        kTriggers[4].pull(true);
        tenths(2);
        ASSERT_EQ(vehicle.mode, Mode::circle);
        mutable_vehicle.estimate.position.latitude_e7 += 5000;
        kTriggers[4].pull(false);
        tenths(2);
        EXPECT_EQ(vehicle.mode, mode);
        EXPECT_EQ(vehicle.demand.to.latitude_e7, centre.latitude_e7) << "and in the same place";
    }
}

TEST_F(FailsafeMachine, the_inertial_sensor_back_is_trusted_when_the_attitude_is_found) {
    start(Mode::loiter);
    mutable_vehicle.imu.healthy = mutable_vehicle.attitude.aligned = false;
    tenths(2);
    EXPECT_EQ(vehicle.mode, Mode::loiter) << "it may start anew";
    tenths(2);
    EXPECT_EQ(vehicle.mode, Mode::manual);
    mutable_vehicle.imu.healthy = true;
    tenths(5);
    EXPECT_EQ(vehicle.mode, Mode::manual);
    mutable_vehicle.attitude.aligned = true;
    tenths(2);
    EXPECT_EQ(vehicle.mode, Mode::loiter);
}

TEST_F(FailsafeMachine, a_mode_that_needs_an_attitude_is_refused_without_one) {
    start(Mode::fbwa);
    mutable_vehicle.imu.healthy = mutable_vehicle.attitude.aligned = false;
    tenths(5);
    ASSERT_EQ(vehicle.mode, Mode::manual);
    EXPECT_FALSE(firmware::modes::requestMode(Mode::fbwa, firmware::modes::ModeReason::pilot));
    EXPECT_EQ(vehicle.mode, Mode::manual);
}

TEST_F(FailsafeMachine, a_mode_of_the_sticks_is_refused_without_a_receiver) {
    start(Mode::loiter);
    mutable_vehicle.radio.lost = true;
    tenths(70);
    ASSERT_EQ(vehicle.mode, Mode::loiter);
    EXPECT_FALSE(
        firmware::modes::requestMode(Mode::stabilize, firmware::modes::ModeReason::ground));
    tenths(2);
    EXPECT_EQ(vehicle.mode, Mode::loiter);
}

TEST_F(FailsafeMachine, fbwa_of_the_pilot_is_no_glide_and_a_glide_ends_with_the_receiver_back) {
    start(Mode::fbwa);
    parameters.short_action = 2;
    EXPECT_FALSE(firmware::state::vehicle.failsafe_glides);
    mutable_vehicle.radio.lost = true;
    tenths(2);
    EXPECT_TRUE(firmware::state::vehicle.failsafe_glides);
    mutable_vehicle.radio.lost = false;
    tenths(2);
    EXPECT_FALSE(firmware::state::vehicle.failsafe_glides);
    EXPECT_EQ(vehicle.mode, Mode::fbwa);
}

TEST_F(FailsafeMachine, take_off_and_landing_are_flown_to_their_end) {
    using firmware::state::Path;
    const struct {
        Mode mode;
        Path path;
    } all[] = {{Mode::automatic, Path::takeoff},
               {Mode::automatic, Path::land},
               {Mode::takeoff, Path::takeoff}};
    for (const auto& each : all) {
        start(Mode::loiter);
        mutable_vehicle.mode = each.mode;
        mutable_vehicle.demand.path = each.path;
        tenths(1);
        parameters.long_action = parameters.short_action = 1;
        mutable_vehicle.radio.lost = true;
        kTriggers[4].pull(true);
        tenths(100);
        EXPECT_EQ(vehicle.mode, each.mode);
        kTriggers[4].pull(false);
        mutable_vehicle.demand.path = firmware::state::Path::leg;
        tenths(2);
        EXPECT_EQ(vehicle.mode, Mode::rtl);
        mutable_vehicle.radio.lost = false;
        mutable_vehicle.mode = Mode::initialising;
    }
}

TEST_F(FailsafeMachine, a_low_battery_stays_low_and_the_pilot_may_fly_on) {
    start(Mode::fbwa);
    kTriggers[1].pull(true);
    tenths(99);
    EXPECT_EQ(vehicle.mode, Mode::fbwa);
    kTriggers[1].pull(false);
    tenths(1);
    kTriggers[1].pull(true);
    tenths(102);
    ASSERT_EQ(vehicle.mode, Mode::rtl);
    kTriggers[1].pull(false);
    tenths(20);
    EXPECT_TRUE(firmware::safety::failing(Cause::battery));
    firmware::modes::requestMode(Mode::fbwa, firmware::modes::ModeReason::pilot);
    tenths(20);
    EXPECT_EQ(vehicle.mode, Mode::fbwa);
}

TEST_F(FailsafeMachine, little_remaining_capacity_is_low_battery_too_but_not_on_usb) {
    start(Mode::fbwa);
    parameters.battery_low_mah = 500;
    mutable_vehicle.battery.consumed_mah = 2700;
    tenths(120);
    EXPECT_EQ(vehicle.mode, Mode::fbwa);
    mutable_vehicle.battery.consumed_mah = 2900;
    fakes::setUsb(true);
    tenths(120);
    EXPECT_EQ(vehicle.mode, Mode::fbwa);
    fakes::setUsb(false);
    tenths(102);
    EXPECT_EQ(vehicle.mode, Mode::rtl);
}

}  // namespace
