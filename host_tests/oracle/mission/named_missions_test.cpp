// SPDX-License-Identifier: GPL-3.0-or-later
// The missions that the rules of docs/mission.md name, and the traps other autopilots' users fell
// into: engine and oracle agree on each, and on what is written here.
#include <gtest/gtest.h>

#include <sstream>

#include "trial.hpp"

namespace {

using namespace oracle;

// A mission in words: WP LAND TAKEOFF HERE (a waypoint at 0, 0) COND DO QUIT (a DO that leaves
// AUTO) WHAT (unknown id) ODD (a NAV out of range), J2x3 (2.0 jump to 2, three times), J2 (for
// ever; in the 1.0 set SET_INDEX 2), J (1.0: to the first).
Bytes item(CommandSet set, const std::string& word, int index) {
    const bool apm1 = set == CommandSet::apm1;
    if (word == "WP") return make(set, 0x10, 0, index, 1, 1);
    if (word == "HERE") return make(set, 0x10, 0, index, 0, 0);
    if (word == "ODD") return make(set, 0x10, kOutOfRange, index, 1, 1);
    if (word == "LAND") return make(set, 0x15, 0, index, 1, 1);
    if (word == "TAKEOFF") return make(set, 0x16, 0, index, 0, 0);
    if (word == "COND") return make(set, apm1 ? 0x20 : 0x70, 0, index, 0, 0);
    if (word == "DO") return make(set, apm1 ? 0x81 : 0xB5, 0, index, 0, 0);
    if (word == "QUIT") return make(set, apm1 ? 0x30 : 0xB5, kLeavesAuto, index, 0, 0);
    if (word == "WHAT") return make(set, 0xEE, 0, index, 0, 0);
    if (word == "J") return make(set, 0x31, 0, 0, 0, 0);
    const size_t times = word.find('x');
    const int target = std::stoi(word.substr(1));
    if (apm1) return make(set, 0x75, 0, target, 0, 0);
    return make(set, 0xB1, target, 0,
                times == std::string::npos ? -1 : std::stoi(word.substr(times + 1)), 0);
}

Stored store(CommandSet set, const std::string& words) {
    Stored stored{set, {make(set, 0x10, 0, 0, 7, 7)}};
    std::istringstream in(words);
    std::string word;
    while (in >> word)
        stored.mission.push_back(item(set, word, static_cast<int>(stored.mission.size())));
    return stored;
}

// What happens, a word each: auto, afresh, leave, pass, nav, cond, both (have finished), trail,
// set3, commit (the second mission), watchdog, power.
Step step(const std::string& word) {
    Step step;
    if (word == "nav" || word == "both") step.how.nav = true;
    if (word == "cond" || word == "both") step.how.condition = true;
    if (word == "auto") step.what = Happens::enter;
    if (word == "afresh") step.what = Happens::enter_afresh;
    if (word == "leave") step.what = Happens::leave;
    if (word == "watchdog") step.what = Happens::watchdog;
    if (word == "power") step.what = Happens::power_loss;
    if (word == "trail") step = {Happens::trailing, 1, {}};
    if (word == "commit") step = {Happens::commit, 1, {}};
    if (word.compare(0, 3, "set") == 0)
        step = {Happens::set_current, std::stoi(word.substr(3)), {}};
    return step;
}

// What the engine says, without parameters and resets; or where it and the oracle part.
std::string flown(CommandSet set, const std::string& mission, const std::string& happens,
                  const std::string& then = "") {
    Trial trial;
    trial.missions = {store(set, mission), store(set, then)};
    std::istringstream in(happens);
    std::string word, said, plain;
    while (in >> word) trial.steps.push_back(step(word));
    const std::string parted = fly(trial, &said);
    if (!parted.empty()) return parted;
    std::istringstream words(said);
    while (words >> word)
        if (word != "reset") plain += (plain.empty() ? "" : " ") + word.substr(0, word.find('('));
    return plain;
}
std::string one(const std::string& mission, const std::string& happens,
                const std::string& then = "") {
    return flown(CommandSet::apm1, mission, happens, then);
}
std::string two(const std::string& mission, const std::string& happens,
                const std::string& then = "") {
    return flown(CommandSet::apm2, mission, happens, then);
}

TEST(NamedMission, rule_1_what_stands_before_the_first_nav) {
    EXPECT_EQ(one("DO COND WP", "auto"), "W3!");
    EXPECT_EQ(two("DO WP", "auto"), "a1 W2!");
    EXPECT_EQ(two("DO COND DO WP", "auto cond"), "a1 W4! c2 a3");
}

TEST(NamedMission, rule_2_one_at_a_time_and_a_do_once) {
    EXPECT_EQ(one("WP COND DO COND DO", "auto pass cond pass cond pass"), "W1! c2 a3 c4 a5");
    EXPECT_EQ(two("WP DO DO DO WP", "auto nav pass pass"), "W1! +1 a2 a3 a4 W5");
}

TEST(NamedMission, rule_3_a_finished_nav_cancels_and_drops) {
    EXPECT_EQ(one("WP COND DO WP DO", "auto nav"), "W1! c2 +1 a5 W4");
    EXPECT_EQ(two("WP COND DO WP WP", "auto nav both"), "W1! +1 W4 c2 +4 W5");
}

TEST(NamedMission, rule_4_set_home_between_two_waypoints) {
    EXPECT_EQ(two("WP DO WP", "auto nav"), "W1! +1 a2 W3");
    EXPECT_EQ(two("WP DO", "auto nav"), "W1! +1 RTL");
    EXPECT_EQ(one("WP DO WP", "auto nav"), "a2 W1! +1 W3");
}

TEST(NamedMission, rule_4_what_trails_the_last_nav) {
    EXPECT_EQ(two("WP DO COND DO", "trail auto nav nav cond"), "W1! +1 hold a2 c3 a4 RTL");
    EXPECT_EQ(two("WP WP J1x1", "trail auto nav nav nav nav"),
              "W1! +1 W2 +2 hold W1 +1 W2 +2 hold RTL");
    EXPECT_EQ(two("WP LAND DO", "trail auto nav nav"), "W1! +1 W2 +2 landed");
    EXPECT_EQ(one("WP DO", "trail auto nav"), "a2 W1! +1 RTL");
}

TEST(NamedMission, rule_4_an_apm2_jump_abandons_the_nav_and_goes_on_at_its_target) {
    EXPECT_EQ(two("WP COND J1x1 DO WP", "auto nav pass cond nav cond"),
              "W1! +1 W5 c2 W1! +1 W5 c2 a4");
    EXPECT_EQ(two("WP DO WP J2x1 WP", "auto nav nav nav"), "W1! +1 a2 W3 +3 a2 W3 +3 W5");
    EXPECT_EQ(two("WP J4x1 WP DO", "auto nav"), "W1! +1 RTL");
    EXPECT_EQ(two("WP J4x1 WP DO", "trail auto nav"), "W1! +1 hold a4 RTL");
}

TEST(NamedMission, rule_4_the_apm1_jumps_move_the_queue_only) {
    EXPECT_EQ(one("WP WP J", "auto nav nav nav nav"), "W1! +1 W2 +2 W1 +1 W2 +2 W1");
    EXPECT_EQ(one("WP DO COND J2 WP", "auto cond cond nav"), "a2 W1! c3 a2 c3 a2 c3 +1 W5");
    EXPECT_EQ(one("WP COND J1 WP", "auto nav"), "W1! c2 +1 W4");
}

TEST(NamedMission, rule_5_the_end) {
    EXPECT_EQ(two("WP", "auto nav"), "W1! +1 RTL");
    EXPECT_EQ(two("LAND WP", "auto nav"), "W1! +1 landed");
    EXPECT_EQ(one("LAND DO TAKEOFF WP", "auto nav nav"), "a2 W1! +1 W3 +3 W4!");
    EXPECT_EQ(two("DO COND", "trail auto pass"), "") << "empty: AUTO is refused";
}

TEST(NamedMission, rule_6_leaving_and_coming_back) {
    EXPECT_EQ(two("WP DO COND DO WP", "auto nav leave cond auto cond"),
              "W1! +1 a2 W5 c3 W5~ c3 a4");
    EXPECT_EQ(two("WP COND DO WP WP", "auto nav nav leave auto cond"), "W1! +1 W4 c2 +4 W5 W5~");
    EXPECT_EQ(two("HERE", "auto leave pass auto"), "W1! W1~");
    EXPECT_EQ(two("WP J1x1 WP", "auto nav leave auto nav leave afresh nav"),
              "W1! +1 W1 W1~ +1 W3 W1! +1 W1");
    EXPECT_EQ(two("WP", "auto nav auto"), "W1! +1 RTL W1!");
    EXPECT_EQ(one("WP QUIT DO", "auto auto"), "a2 a3 W1!");
}

TEST(NamedMission, rule_6_a_reset_in_the_air) {
    EXPECT_EQ(two("WP J1x1 DO COND DO WP", "auto nav nav watchdog auto cond"),
              "W1! +1 W1 +1 a3 W6 c4 W6~ c4 a5");
    EXPECT_EQ(two("WP DO WP DO WP", "auto nav power auto nav"), "W1! +1 a2 W3 W3! +3 a4 W5");
    EXPECT_EQ(one("WP DO WP DO WP", "auto nav power auto nav"), "a2 W1! +1 a4 W3 W3! +3 W5");
}

TEST(NamedMission, rule_7_another_mission_in_flight) {
    EXPECT_EQ(two("WP DO COND WP WP", "auto nav commit cond nav", "WP DO COND WP LAND"),
              "W1! +1 a2 W4 c3 +4 W5");
    EXPECT_EQ(two("WP DO COND WP", "auto nav commit pass", "WP COND DO WP"), "W1! +1 a2 W4 c3 W1!");
    EXPECT_EQ(two("WP J1x1 WP", "auto nav commit nav", "WP J1x1 WP"), "W1! +1 W1 +1 W1");
    EXPECT_EQ(one("WP DO", "auto commit nav", "WP DO WP"), "a2 W1! +1 W3") << "appended";
    EXPECT_EQ(two("WP", "auto commit", ""), "W1! RTL");
    EXPECT_EQ(two("LAND", "auto nav commit", ""), "W1! +1 landed landed");
}

TEST(NamedMission, rule_8_what_never_stops_a_mission) {
    EXPECT_EQ(two("WP WHAT ODD DO WP", "auto nav"), "W1! +1 ?2 ?3 a4 W5");
    EXPECT_EQ(two("DO J1 DO WP", "auto pass nav"), "a1 a1 a1 loop2 a3 W4! +4 RTL");
    EXPECT_EQ(one("WP J3 J2 DO WP", "auto nav"), "a4 W1! +1 W5");
    EXPECT_EQ(one("WP J2 DO", "auto"), "a3 W1!");
}

TEST(NamedMission, rule_9_a_chosen_item) {
    EXPECT_EQ(two("WP WP DO WP", "auto set3 pass"), "W1! a3 W4!");
    EXPECT_EQ(one("WP WP DO WP DO", "auto set3 pass"), "W1! a5 W4!");
    EXPECT_EQ(two("WP WP", "auto set3 nav"), "W1! +1 W2");
    EXPECT_EQ(two("WP J1x1 WP", "set3 auto leave set1 afresh nav"), "W3! W1! +1 W1");
    EXPECT_EQ(two("WP J1x1 WP", "auto nav set1 pass nav set0 pass nav"),
              "W1! +1 W1 W1! +1 W3 W1! +1 W1");
}

TEST(NamedMission, rule_10_where_a_leg_begins) {
    EXPECT_EQ(two("WP WP J1x1 WP", "auto nav nav"), "W1! +1 W2 +2 W1");
    EXPECT_EQ(two("TAKEOFF WP WP", "auto nav nav"), "W1! +1 W2! +2 W3");
    EXPECT_EQ(two("WP COND J5x1 WP WP WP", "auto nav cond nav"), "W1! +1 W4 c2 W5! +5 W6");
    EXPECT_EQ(two("WP J4x1 LAND WP", "auto nav"), "W1! +1 W4") << "the LAND is not started";
}

// ---- traps

TEST(NamedMission, a_second_flight_has_its_repeats_again) {
    EXPECT_EQ(two("WP J1x1 WP", "auto nav nav nav auto nav"), "W1! +1 W1 +1 W3 +3 RTL W1! +1 W1");
}

TEST(NamedMission, a_jump_as_the_last_item) {
    EXPECT_EQ(two("WP J1x1", "auto nav"), "W1! +1 RTL");
    EXPECT_EQ(two("WP J1x1", "trail auto nav nav"), "W1! +1 hold W1 +1 hold RTL");
    EXPECT_EQ(one("WP J", "auto nav nav"), "W1! +1 W1 +1 W1");
}

TEST(NamedMission, a_jump_to_itself_does_not_end_the_mission) {
    EXPECT_EQ(two("WP J2 WP", "auto nav"), "W1! +1 ?2 W3");
}

TEST(NamedMission, what_follows_a_finite_jump_waits_until_it_is_passed_over) {
    EXPECT_EQ(two("WP J1x2 DO WP", "auto nav nav nav"), "W1! +1 W1 +1 W1 +1 a3 W4");
}

TEST(NamedMission, a_jump_to_a_condition_or_do_begins_there) {
    EXPECT_EQ(two("WP COND WP J2x1 WP", "auto nav nav cond"), "W1! +1 W3 c2 +3 W3 c2");
    EXPECT_EQ(one("WP J4 WP DO WP", "auto nav"), "a4 W1! +1 W5");
}

TEST(NamedMission, a_condition_holds_the_jump_behind_it) {
    EXPECT_EQ(two("WP COND J1x1 WP", "auto nav pass pass cond"), "W1! +1 W4 c2 W1!");
    EXPECT_EQ(one("WP COND J WP", "auto pass cond nav"), "W1! c2 +1 W1 c2");
}

TEST(NamedMission, an_item_chosen_before_the_first_auto_keeps_count_of_jumps) {
    EXPECT_EQ(two("WP WP J1x1 WP", "set2 auto nav nav nav"), "W2! +2 W1 +1 W2 +2 W4");
}

}  // namespace
