// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/modes/mode_switch.hpp"

#include "firmware/notify/status_text.hpp"
#include "firmware/notify/text_queue.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware_bench.hpp"
#include "mission_rig.hpp"

namespace {

using firmware::modes::ModeReason;
using firmware::modes::requestMode;
using firmware::state::Mode;
using firmware::state::mutable_vehicle;
using firmware::state::parameters;
using firmware::state::vehicle;

class RefusedSwitch : public bench::Bench {
protected:
    void SetUp() override {
        Bench::SetUp();
        parameters.switch_mode[2] = static_cast<int8_t>(Mode::loiter);
        fly(Mode::fbwa);
        mutable_vehicle.estimate.known = false;
        move(1425);
        ASSERT_EQ(vehicle.mode, Mode::fbwa);
    }
    void move(uint16_t pulse_us) { settle(with(8, pulse_us)); }
    void wait(int quarters) {
        for (int i = 0; i < quarters; ++i) move(1425);
    }
};

TEST_F(RefusedSwitch, is_obeyed_once_its_mode_can_be_entered) {
    wait(30);
    EXPECT_EQ(vehicle.mode, Mode::fbwa);
    mutable_vehicle.estimate.known = true;
    wait(30);
    EXPECT_EQ(vehicle.mode, Mode::loiter);
    EXPECT_EQ(vehicle.mode_reason, ModeReason::pilot);
}

TEST_F(RefusedSwitch, is_forgotten_when_another_mode_is_chosen) {
    ASSERT_TRUE(requestMode(Mode::stabilize, ModeReason::ground));
    mutable_vehicle.estimate.known = true;
    wait(60);
    EXPECT_EQ(vehicle.mode, Mode::stabilize);
}

TEST_F(RefusedSwitch, is_forgotten_when_it_is_moved_on) {
    move(1815);
    ASSERT_EQ(vehicle.mode, Mode::manual);
    mutable_vehicle.estimate.known = true;
    for (int i = 0; i < 60; ++i) move(1815);
    EXPECT_EQ(vehicle.mode, Mode::manual);
}

TEST_F(RefusedSwitch, is_asked_for_again_every_5_s) {
    mutable_vehicle.estimate.known = true;
    for (int tenths = 1; tenths < 50; ++tenths) firmware::modes::runModeSwitch();
    EXPECT_EQ(vehicle.mode, Mode::fbwa);
    firmware::modes::runModeSwitch();
    EXPECT_EQ(vehicle.mode, Mode::loiter);
}

struct ModeSwitch : bench::Bench {
    // What the receiver sends, without a look at the switch.
    void send(const std::vector<uint16_t>& sticks) {
        for (int i = 0; i < 10; ++i) {
            fakes::receiveRc(sticks);
            firmware::sensors::runRadio();
            fakes::advance_ms(10);
            firmware::sensors::runRadio();
            fakes::advance_ms(10);
        }
    }
};

TEST_F(ModeSwitch, is_obeyed_when_it_is_seen_twice_in_a_position) {
    send(with(8, 1425));
    firmware::modes::runModeSwitch();
    EXPECT_EQ(vehicle.mode, Mode::manual) << "it may be on its way";
    firmware::modes::runModeSwitch();
    EXPECT_EQ(vehicle.mode, Mode::fbwa);
}

TEST_F(ModeSwitch, takes_back_what_the_ground_has_set_when_it_is_reset) {
    settle(with(8, 1425));
    ASSERT_EQ(vehicle.mode, Mode::fbwa);
    firmware::modes::requestMode(Mode::stabilize, firmware::modes::ModeReason::ground);
    firmware::modes::runModeSwitch();
    EXPECT_EQ(vehicle.mode, Mode::stabilize);
    firmware::modes::resetModeSwitch();
    firmware::modes::runModeSwitch();
    EXPECT_EQ(vehicle.mode, Mode::fbwa);
}

using SwitchAtRestart = bench::Bench;

TEST_F(SwitchAtRestart, is_left_to_the_restart_and_obeyed_behind_it) {
    mutable_vehicle.mode = Mode::initialising;
    mutable_vehicle.resuming = true;
    settle(with(8, 1425));
    EXPECT_EQ(vehicle.mode, Mode::initialising);
    mutable_vehicle.resuming = false;
    settle(with(8, 1425));
    EXPECT_EQ(vehicle.mode, Mode::fbwa);
}

class MissionSwitch : public firmware::Rig {
protected:
    void SetUp() override {
        Rig::SetUp();
        parameters.reset_mission_channel = 7;
        move(1100);
        fly({firmware::waypoint(500), firmware::waypoint(900), firmware::waypoint(1300)});
        reach();
        ASSERT_EQ(firmware::mission::missionCurrent(), 2);
    }
    void move(uint16_t pulse_us) {
        for (int i = 0; i < 8; ++i) {
            if (i % 2 == 0) fakes::receiveRc({1500, 1500, 1100, 1500, 1500, 1500, pulse_us, 0});
            firmware::sensors::runRadio();
        }
    }
    void look() {
        for (int i = 0; i < 3; ++i) firmware::modes::runModeSwitch();
        pass();
    }
};

TEST_F(MissionSwitch, begins_the_mission_anew_once_when_it_is_moved_up) {
    look();
    EXPECT_EQ(firmware::mission::missionCurrent(), 2) << "it is down";
    move(1900);
    look();
    EXPECT_EQ(firmware::mission::missionCurrent(), 1);
    reach();
    look();
    EXPECT_EQ(firmware::mission::missionCurrent(), 2) << "it stays up";
}

}  // namespace
