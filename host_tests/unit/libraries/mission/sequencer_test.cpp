// SPDX-License-Identifier: GPL-3.0-or-later
// The order of execution: the rules, and what a row of them cannot say.
#include "mission/sequencer.hpp"

#include <gtest/gtest.h>

#include "flight.hpp"
#include "mission_rules.hpp"

namespace {

using namespace flight;

constexpr Set k1 = Set::apm1, k2 = Set::apm2;

// The next word of a text; "" at its end.
std::string next(const char*& text) {
    std::string word;
    for (; *text == ' '; ++text) {
    }
    for (; *text != 0 && *text != ' '; ++text) word += *text;
    return word;
}

Record item(Set set, const std::string& word) {
    const Record action = set == k1 ? action1() : action2();
    if (word == "WP") return waypoint();
    if (word == "HERE") return waypointHere();
    if (word == "ODD") return outOfRange(waypoint());
    if (word == "LAND") return land();
    if (word == "TAKEOFF") return takeoff();
    if (word == "COND") return set == k1 ? condition1() : condition2();
    if (word == "DO") return action;
    if (word == "QUIT") return leavesAuto(action);
    if (word == "WHAT") return unknown();
    if (word == "J") return toOne();
    const auto target = static_cast<uint8_t>(word[1] - '0');
    if (set == k1) return jump1(target);
    return jump2(target, word.size() == 4 ? static_cast<int16_t>(word[3] - '0') : -1);
}

void happen(Flight& f, Set set, const std::string& step) {
    world.nav_done = step == "nav" || step == "both";
    world.condition_done = step == "cond" || step == "both";
    if (step == "auto" || step == "afresh") {
        if (f.engine.ended()) f.engine.leave();
        f.enter(step == "afresh");
    } else if (step == "leave") {
        f.engine.leave();
    } else if (step == "watchdog") {
        f.engine.boot(set, 1, true, 0);
    } else if (step == "power") {
        f.engine.boot(set, 1, false, f.engine.current());
    } else if (step.substr(0, 3) == "set") {
        f.engine.setCurrent(static_cast<uint8_t>(step[3] - '0'));
    } else {
        f.pass();
    }
}

TEST(Sequencer, flies_every_row_of_the_rules) {
    for (const MissionRule& rule : kMissionRules) {
        if (rule.then != nullptr) continue;  // who commits a mission compares it: see below
        const Set set = rule.set == 1 ? k1 : k2;
        std::vector<Record> items;
        for (const char* left = rule.mission; *left != 0;) items.push_back(item(set, next(left)));
        const char* steps = rule.steps;
        const bool trailing = *steps == 't';
        if (trailing) next(steps);
        Flight f(set, items, trailing);
        std::string found;
        while (*steps != 0) {
            happen(f, set, next(steps));
            const std::string trace = f.trace();
            found += (found.empty() || trace.empty() ? "" : " ") + trace;
            if (*steps != 0 && std::string(rule.trace).find("/") != std::string::npos)
                found += found.empty() ? "/" : " /";
        }
        EXPECT_EQ(found, rule.trace) << rule.mission << ", " << rule.steps;
    }
}

// ---- 1: entering

TEST(Sequencer, an_id_of_the_other_set_is_not_run) {
    Flight f(k1, {waypoint(), action2(), action1()});
    EXPECT_EQ(f.enter().trace(), "W1! ?2 a3");
}

// ---- 2: one at a time

TEST(Sequencer, a_nav_advance_over_170_actions_takes_several_polls_and_loses_none) {
    std::vector<Record> items(169, action2());
    items.push_back(waypoint());
    Flight f(k2, items);
    f.enter();
    std::string all;
    for (int i = 1; i <= 169; ++i) all += "a" + std::to_string(i) + " ";
    EXPECT_EQ(f.trace(), all + "W170!");
    EXPECT_LE(world.max_reads, kRecordsPerPoll);
}

// ---- 3: a finished NAV

TEST(Sequencer, a_nav_is_checked_in_the_pass_after_the_one_that_loaded_it) {
    Flight f(k2, {waypoint(), waypoint()});
    world.nav_done = true;
    f.engine.enter(false);
    EXPECT_EQ(f.pass().trace(), "W1!");
}

// ---- 5: the end

TEST(Sequencer, when_no_nav_is_left_the_mission_is_complete) {
    Flight f(k2, {waypoint()});
    f.enter().reach();
    EXPECT_EQ(f.trace(), "W1! +1 RTL");
    EXPECT_TRUE(f.engine.ended());
    EXPECT_EQ(f.engine.current(), 0);
}

// ---- 6: leaving and coming back

TEST(Sequencer, a_nav_without_a_place_keeps_the_one_it_took_when_it_first_loaded) {
    Flight f(k2, {waypointHere(), waypoint()});
    EXPECT_EQ(f.enter().trace(), "W1!@500");
    f.engine.leave();
    world.here = 900;
    EXPECT_EQ(f.enter().trace(), "W1~@500");
}

TEST(Sequencer, after_a_power_loss_only_the_index_is_left_and_the_chain_is_not_run_again) {
    for (Set set : {k1, k2}) {
        const Record act = set == k1 ? action1() : action2();
        Flight f(set, {waypoint(), act, waypoint(), act, waypoint()});
        f.engine.boot(set, 1, false, 3);
        EXPECT_EQ(f.engine.current(), 3);
        EXPECT_EQ(f.enter().trace(), "W3!");
        EXPECT_EQ(f.reach().trace(), set == k1 ? "+3 W5" : "+3 a4 W5");
    }
}

TEST(Sequencer, memory_whose_seal_is_broken_or_of_another_mission_does_not_count) {
    Flight f(k2, {waypoint(), waypoint()});
    f.enter().reach();
    f.trace();
    const Memory good = f.memory;
    f.memory.nav ^= 1;
    f.engine.boot(k2, 1, true, 0);
    EXPECT_EQ(f.enter().trace(), "W1!");
    f.memory = good;
    f.engine.boot(k2, 2, true, 0);
    EXPECT_EQ(f.enter().trace(), "W1!");
    f.memory = good;
    f.engine.boot(k2, 1, true, 0);
    EXPECT_EQ(f.enter().trace(), "W2~");
}

// ---- 7: another mission

TEST(Sequencer, a_change_elsewhere_leaves_the_flight_alone_but_refills_the_jumps) {
    Flight f(k2, {waypoint(), jump2(1, 1), condition2(), action2(), waypoint()});
    f.enter().reach().reach();
    EXPECT_EQ(f.trace(), "W1! +1 W1 +1 W5 c3");
    Sequencer::InFlight items;
    ASSERT_TRUE(f.engine.inFlight(items));
    EXPECT_EQ(items.nav, 5);
    EXPECT_EQ(items.first, 2);
    EXPECT_EQ(items.last, 5);
    EXPECT_EQ(f.engine.nextRun(0), 0);

    f.engine.changed(k2, 2, true, false);

    EXPECT_EQ(f.over().trace(), "a4");
    f.engine.setCurrent(1);
    f.pass().reach();
    EXPECT_EQ(f.trace(), "W1! +1 W1");
}

TEST(Sequencer, after_a_change_elsewhere_an_apm1_jump_that_came_round_stays_passed_over) {
    Flight f(k1, {waypoint(), action1(), jump1(2), condition1(), jump1(2)});
    EXPECT_EQ(f.enter().trace(), "W1! a2 a2 c4");
    f.engine.changed(k1, 2, true, false);
    EXPECT_EQ(f.over().trace(), "a2 c4") << "no other NAV has been loaded";
}

TEST(Sequencer, a_change_in_flight_restarts_the_mission) {
    Flight f(k2, {waypoint(), waypoint(), waypoint()});
    f.enter().reach();
    f.trace();
    f.store(k1, {waypoint(), action1()});
    f.engine.changed(k1, 2, false, false);
    EXPECT_EQ(f.pass().trace(), "W1! a2");
}

TEST(Sequencer, a_clear_in_flight_completes_the_mission) {
    Flight f(k2, {waypoint(), waypoint()}, true);
    f.enter();
    f.trace();
    f.store(k2, {action2()});
    f.engine.changed(k2, 2, false, true);
    EXPECT_EQ(f.pass().trace(), "RTL") << "a mission without a NAV is empty whatever it holds";
}

TEST(Sequencer, a_mission_without_a_nav_ends_the_flight_though_what_trails_is_the_same) {
    Flight f(k2, {waypoint(), condition2(), action2()}, true);
    f.engine.setCurrent(2);
    EXPECT_EQ(f.enter().trace(), "hold0 c2");
    f.store(k2, {action2(), condition2(), action2()});
    f.engine.changed(k2, 2, true, true);
    EXPECT_EQ(f.pass().trace(), "RTL");
}

TEST(Sequencer, a_clear_after_a_land_leaves_the_airplane_landed) {
    Flight f(k2, {land()});
    f.enter();
    EXPECT_EQ(f.reach().trace(), "W1! +1 landed");
    f.store(k2, {});
    f.engine.changed(k2, 2, false, true);
    EXPECT_EQ(f.pass().trace(), "landed") << "not RTL: it stands on the ground";
}

TEST(Sequencer, nothing_in_flight_has_nothing_to_compare) {
    Flight f(k2, {waypoint()});
    Sequencer::InFlight items;
    EXPECT_FALSE(f.engine.inFlight(items));
    f.enter().reach();
    EXPECT_FALSE(f.engine.inFlight(items));
}

// ---- 8: what must never stop a mission

TEST(Sequencer, an_unknown_or_invalid_record_is_skipped_and_reported) {
    Flight f(k2, {waypoint(), unknown(), outOfRange(action2()), outOfRange(waypoint()), action2(),
                  waypoint()});
    f.enter().reach();
    EXPECT_EQ(f.trace(), "W1! +1 ?2 ?3 ?4 a5 W6");
}

TEST(Sequencer, a_record_the_store_does_not_have_yet_is_waited_for_without_losing_the_order) {
    Flight f(k2, {waypoint(), action2(), action2(), waypoint()});
    f.enter();
    f.trace();
    world.busy = {3};
    EXPECT_EQ(f.reach().trace(), "+1");
    EXPECT_EQ(f.pass().trace(), "");
    world.busy = {4};
    EXPECT_EQ(f.pass().trace(), "");
    world.busy = {};
    EXPECT_EQ(f.pass().trace(), "a2 a3 W4");
}

TEST(Sequencer, a_record_that_cannot_be_read_is_reported_and_ends_the_mission) {
    for (const int lost : {2, 4}) {
        Flight f(k2, {waypoint(), action2(), action2(), waypoint()});
        f.enter();
        f.trace();
        world.lost = {lost};
        EXPECT_EQ(f.reach().trace(), "+1 lost" + std::to_string(lost) + " RTL");
        EXPECT_TRUE(f.engine.ended());
        EXPECT_FALSE(f.engine.starved());
    }
    Flight f(k1, {waypoint(), condition1(), action1(), waypoint()});
    EXPECT_EQ(f.enter().trace(), "W1! c2");
    world.lost = {3};
    EXPECT_EQ(f.over().trace(), "lost3 RTL") << "behind a CONDITION";
    f.engine.leave();
    EXPECT_EQ(f.enter().trace(), "W1! c2") << "AUTO afterwards begins again";
}

// Two jumps that lead to one another: either has the next NAV sought among all the others again.
TEST(Sequencer, jumps_that_go_round_do_not_have_the_next_nav_sought_without_end) {
    std::vector<Record> items(169, action2());
    items[0] = jump2(2, -1);
    items[1] = jump2(1, -1);
    items.push_back(waypoint());
    Flight f(k2, items);
    f.enter();
    EXPECT_NE(f.trace().find("a169 W170!"), std::string::npos);
    EXPECT_LE(world.all_reads, 4 * 171);
}

// Its turn comes after more steps than the mission has items: the search for the NAV, the actions.
TEST(Sequencer, a_jump_behind_a_chain_of_most_of_the_mission_is_taken) {
    std::vector<Record> items(14, action2());
    items[0] = items[12] = items[13] = waypoint();
    items[11] = jump2(14, 1);
    Flight f(k2, items);
    EXPECT_EQ(f.enter().reach().trace(), "W1! +1 a2 a3 a4 a5 a6 a7 a8 a9 a10 a11 W14");
}

TEST(Sequencer, random_missions_of_both_sets_never_hang_and_every_poll_is_bounded) {
    uint32_t seed = 12345;
    const auto random = [&](uint32_t below) {
        seed = seed * 1664525u + 1013904223u;
        return (seed >> 8) % below;
    };
    for (int round = 0; round < 4000; ++round) {
        const Set set = random(2) == 0 ? k1 : k2;
        std::vector<Record> items(1 + random(12));
        const uint8_t count = static_cast<uint8_t>(items.size() + 1);
        for (Record& item : items) {
            const uint8_t target = static_cast<uint8_t>(1 + random(count - 1u));
            switch (random(7)) {
                case 0:
                case 1:
                    item = waypoint();
                    break;
                case 2:
                    item = set == k1 ? condition1() : condition2();
                    break;
                case 3:
                    item = set == k1 ? action1() : action2();
                    break;
                case 4:
                    item = unknown();
                    break;
                case 5:
                    item = set == k1 ? toOne() : jump2(target, -1);
                    break;
                default:
                    item = set == k1 ? jump1(target) : jump2(target, 1 + int(random(3)));
            }
        }
        Flight f(set, items, random(2) != 0);
        f.enter();
        for (int i = 0; i < 60; ++i) {
            world.nav_done = random(4) == 0;
            world.condition_done = random(3) == 0;
            if (random(20) == 0) f.engine.setCurrent(static_cast<uint8_t>(random(count)));
            if (random(20) == 0) f.engine.leave();
            if (random(5) == 0) f.engine.enter(false);
            f.pass();
            ASSERT_LE(world.max_reads, kRecordsPerPoll);
            ASSERT_LT(world.trace.size(), 20000u);
        }
    }
}

// ---- 9: SET_CURRENT

TEST(Sequencer, set_current_beyond_the_end_is_refused_and_changes_nothing) {
    Flight f(k2, {waypoint(), waypoint()});
    f.enter();
    f.trace();
    EXPECT_FALSE(f.engine.setCurrent(3));
    EXPECT_EQ(f.engine.current(), 1);
    f.engine.leave();
    EXPECT_TRUE(f.engine.setCurrent(2)) << "outside AUTO it is where AUTO begins";
    EXPECT_EQ(f.engine.current(), 2);
    EXPECT_TRUE(f.engine.setCurrent(1));
    f.enter();
    f.trace();
    EXPECT_EQ(f.reach().trace(), "+1 W2");
}

TEST(Sequencer, a_choice_holds_until_auto_has_taken_it_up) {
    Flight f(k2, {waypoint(), waypoint()});
    f.engine.setCurrent(2);
    f.engine.enter(true);
    f.engine.leave();  // before the next poll
    EXPECT_EQ(f.engine.current(), 2);
    EXPECT_EQ(f.enter(true).trace(), "W2!");
    f.engine.leave();
    EXPECT_EQ(f.enter(true).trace(), "W1!") << "once";
}

}  // namespace
