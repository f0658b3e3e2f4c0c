// SPDX-License-Identifier: GPL-3.0-or-later
#include "host_tests/unit/simulator/invariants/flown.hpp"

namespace simulator::invariants {

Flown inAMode() {
    Flown flown;
    flown.run(20);
    return flown;
}

TEST(ModeHasACause, a_change_without_a_cause_violates_it) {
    Flown flown = inAMode();
    flown.mode = 11;
    flown.run(5);
    EXPECT_EQ(flown.violated(), "mode_without_cause ");
}

struct Reason {
    const char* name;
    void (*give)(Flown&);
};
void expectAllowed(std::initializer_list<Reason> reasons) {
    for (const Reason& reason : reasons) {
        Flown flown = inAMode();
        reason.give(flown);
        flown.run(0.5);
        flown.mode = 11;
        flown.run(5);
        EXPECT_EQ(flown.violated(), "") << reason.name;
    }
}

TEST(ModeHasACause, each_stated_cause_is_allowed) {
    expectAllowed({
        {"the switch", [](Flown& flown) { flown.now.stick_us[7] = 1165; }},
        {"a stick that is the switch",
         [](Flown& flown) {
             flown.sets("FLTMODE_CH", 1);
             flown.run(5);
             flown.now.stick_us[0] = 1700;
         }},
        {"a command", [](Flown& flown) { flown.command(mavlink::MavCmd::nav_return_to_launch); }},
        {"a failsafe", [](Flown& flown) { flown.text("Failsafe: mode 11"); }},
        {"the radio that is back", [](Flown& flown) { flown.text("Radio back"); }},
        {"a mission that cannot be flown, RTL in its place",
         [](Flown& flown) { flown.text("AUTO: mission has no NAV command"); }},
        {"the mission's end", [](Flown& flown) { flown.text("Mission complete"); }},
    });
}

TEST(ModeHasACause, what_the_receiver_does_is_a_cause) {
    expectAllowed({
        {"the first receiver",
         [](Flown& flown) {
             flown.now.transmitting = false;
             flown.run(3);
             flown.now.transmitting = true;
         }},
        {"a lost receiver where no failsafe looks for it",
         [](Flown& flown) {
             flown.parameter("THR_FAILSAFE", 0);
             flown.inTheAir();
             flown.run(2);
             flown.now.transmitting = false;
         }},
        {"a receiver that is lost while its pulses have an edge too many, and nobody looks for it",
         [](Flown& flown) {
             flown.parameter("THR_FAILSAFE", 0);
             flown.inTheAir();
             flown.now.faulty[static_cast<size_t>(Faulty::radio)] = true;
             flown.run(2);
             flown.now.transmitting = false;
         }},
        {"the first receiver, while its pulses have an edge too many",
         [](Flown& flown) {
             flown.now.transmitting = false;
             flown.now.faulty[static_cast<size_t>(Faulty::radio)] = true;
             flown.run(3);
             flown.now.transmitting = true;
         }},
        {"the switch that has the mode switch obeyed again",
         [](Flown& flown) {
             flown.sets("RST_SWITCH_CH", 2.46f);
             flown.run(5);
             flown.now.stick_us[1] = 1862;
         }},
        {"a receiver of another travel", [](Flown& flown) { flown.now.wide = true; }},
        {"a receiver of another travel, lost by its throttle stick until that is raised",
         [](Flown& flown) {
             flown.now.wide = true;
             flown.now.stick_us[2] = 1100;
             flown.run(3);
             flown.now.stick_us[2] = 1500;
         }},
    });
}

TEST(ModeHasACause, other_events_are_no_cause) {
    const Reason others[] = {
        {"a stick", [](Flown& flown) { flown.now.stick_us[0] = 1900; }},
        {"another command", [](Flown& flown) { flown.command(mavlink::MavCmd::do_set_servo); }},
        {"the receiver's loss alone",
         [](Flown& flown) {
             flown.now.transmitting = false;
             flown.text("Radio lost: short failsafe");
         }},
        {"a receiver that is back in the air, and no text says so",
         [](Flown& flown) {
             flown.inTheAir();
             flown.now.transmitting = false;
             flown.run(3);
             flown.now.transmitting = true;
         }},
        {"a failsafe to another mode", [](Flown& flown) { flown.text("Failsafe: mode 5"); }},
        {"another text", [](Flown& flown) { flown.text("Compass lost"); }},
    };
    for (const Reason& other : others) {
        Flown flown = inAMode();
        other.give(flown);
        flown.run(0.5);
        flown.mode = 11;
        flown.run(5);
        EXPECT_EQ(flown.violated(), "mode_without_cause ") << other.name;
    }
}

TEST(ModeHasACause, an_override_of_the_sticks_ends_after_three_seconds) {
    for (const int after_s : {3, 6}) {
        Flown flown = inAMode();
        flown.sent(mavlink::RcChannelsOverride{});
        flown.run(after_s);
        flown.mode = 11;
        flown.run(5);
        EXPECT_EQ(flown.violated(), after_s == 3 ? "" : "mode_without_cause ");
    }
}

TEST(ModeHasACause, a_command_may_wait_behind_a_parameter) {
    for (const bool behind : {true, false}) {
        Flown flown = inAMode();
        if (behind) flown.sent(mavlink::ParamSet{});
        flown.command(mavlink::MavCmd::nav_return_to_launch);
        flown.run(3);
        flown.mode = 11;
        flown.run(5);
        EXPECT_EQ(flown.violated(), behind ? "" : "mode_without_cause ");
    }
}

TEST(ModeHasACause, an_override_may_wait_behind_a_parameter_too) {
    for (const bool behind : {true, false}) {
        Flown flown = inAMode();
        flown.sent(mavlink::RcChannelsOverride{});
        flown.run(4.5);
        if (behind) flown.sent(mavlink::ParamSet{});
        flown.run(1.4);
        flown.mode = 11;
        flown.run(5);
        EXPECT_EQ(flown.violated(), behind ? "" : "mode_without_cause ");
    }
}

TEST(ModeHasACause, what_was_refused_is_asked_for_again) {
    for (const char* refused :
         {"Mode refused: no radio", "RTL needs a home", "AUTO: mission is being read"}) {
        for (const int after_s : {4, 8}) {
            Flown flown = inAMode();
            flown.text(refused);
            flown.run(after_s);
            flown.mode = 10;
            flown.run(5);
            EXPECT_EQ(flown.violated(), after_s == 4 ? "" : "mode_without_cause ") << refused;
        }
    }
}

TEST(ModeHasACause, what_was_refused_is_asked_for_again_later_where_the_switch_was_overridden) {
    for (const bool overridden : {true, false}) {
        Flown flown = inAMode();
        flown.text("AUTO: mission is being read");
        flown.run(2);
        if (overridden) flown.sent(mavlink::RcChannelsOverride{});
        flown.run(6);
        flown.mode = 10;
        flown.run(5);
        EXPECT_EQ(flown.violated(), overridden ? "" : "mode_without_cause ");
    }
}

// A receiver that is back: where its frames have another number of channels it is read a second
// later.
std::string violatedAfter(double back_s, bool nine_before, bool nine_now) {
    Flown flown = inAMode();
    flown.now.nine_channels = nine_before;
    flown.run(10);
    flown.now.transmitting = false;
    flown.run(2.9);
    flown.now.nine_channels = nine_now;
    flown.now.transmitting = true;
    flown.run(back_s);
    flown.mode = 11;
    flown.run(5);
    return flown.violated();
}

TEST(ModeHasACause, a_receiver_of_another_number_of_channels_may_be_obeyed_after_a_second) {
    EXPECT_EQ(violatedAfter(1.2, false, true), "");
    EXPECT_EQ(violatedAfter(1.2, true, false), "");
    EXPECT_EQ(violatedAfter(2.2, false, true), "mode_without_cause ");
    EXPECT_EQ(violatedAfter(1.2, false, false), "mode_without_cause ");
    EXPECT_EQ(violatedAfter(1.2, true, true), "mode_without_cause ");
}

TEST(ModeHasACause, a_cause_of_three_seconds_ago_is_none) {
    Flown flown = inAMode();
    flown.command(mavlink::MavCmd::nav_return_to_launch);
    flown.run(4);
    flown.mode = 11;
    flown.run(5);
    EXPECT_EQ(flown.violated(), "mode_without_cause ");
}

}  // namespace simulator::invariants
