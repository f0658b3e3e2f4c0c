// SPDX-License-Identifier: GPL-3.0-or-later
// The order of execution, rule by rule (docs/mission.md has the same numbers).
#include "mission/sequencer.hpp"

#include <gtest/gtest.h>

#include "flight.hpp"

namespace {

using namespace flight;

constexpr Set k1 = Set::apm1, k2 = Set::apm2;

// ---- 1: entering

TEST(Sequencer, entering_auto_loads_the_first_nav_and_home_is_never_flown) {
    Flight f(k2, {waypoint(), waypoint()});
    EXPECT_EQ(f.enter().trace(), "W1!");
    EXPECT_EQ(f.reach().trace(), "+1 W2");
}

TEST(Sequencer, in_apm1_what_stands_before_the_first_nav_is_not_run) {
    Flight f(k1, {action1(), condition1(), waypoint()});
    EXPECT_EQ(f.enter().trace(), "W3!");
}

TEST(Sequencer, in_apm2_what_stands_before_the_first_nav_accompanies_it) {
    Flight f(k2, {action2(), waypoint(), waypoint()});
    EXPECT_EQ(f.enter().trace(), "a1 W2!");
}

TEST(Sequencer, an_id_of_the_other_set_is_not_run) {
    Flight f(k1, {waypoint(), action2(), action1()});
    EXPECT_EQ(f.enter().trace(), "?2 a3 W1!");
}

// ---- 2: one at a time

TEST(Sequencer, while_a_condition_runs_every_later_condition_and_action_waits) {
    Flight f(k1, {waypoint(), condition1(), action1(), condition1(), action1()});
    EXPECT_EQ(f.enter().trace(), "W1! c2");
    EXPECT_EQ(f.pass().trace(), "");
    EXPECT_EQ(f.over().trace(), "a3 c4");
    EXPECT_EQ(f.over().trace(), "a5");
    EXPECT_EQ(f.pass().trace(), "");
}

TEST(Sequencer, an_action_is_executed_once) {
    Flight f(k2, {waypoint(), action2(), waypoint()});
    f.enter().reach();
    f.trace();
    for (int i = 0; i < 20; ++i) f.pass();
    EXPECT_EQ(f.trace(), "");
}

TEST(Sequencer, any_number_of_actions_run_in_one_pass) {
    std::vector<Record> items(10, action2());
    items.push_back(waypoint());
    Flight f(k2, items);
    EXPECT_EQ(f.enter().trace(), "a1 a2 a3 a4 a5 a6 a7 a8 a9 a10 W11!");
}

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

TEST(Sequencer, a_finished_nav_cancels_the_condition_and_drops_the_rest_of_its_chain) {
    Flight one(k1, {waypoint(), condition1(), action1(), waypoint(), action1()});
    one.enter();
    EXPECT_EQ(one.reach().trace(), "W1! c2 +1 a5 W4");
    Flight two(k2, {condition2(), action2(), waypoint(), action2(), waypoint()});
    two.enter();
    EXPECT_EQ(two.reach().trace(), "W3! c1 +3 a4 W5");
}

TEST(Sequencer, when_nav_and_condition_end_in_one_pass_the_nav_comes_first) {
    Flight f(k2, {waypoint(), condition2(), action2(), waypoint(), waypoint()});
    f.enter().reach();
    f.trace();
    world.condition_done = true;
    EXPECT_EQ(f.reach().trace(), "+4 W5");
}

TEST(Sequencer, a_nav_is_checked_in_the_pass_after_the_one_that_loaded_it) {
    Flight f(k2, {waypoint(), waypoint()});
    world.nav_done = true;
    f.engine.enter(false);
    EXPECT_EQ(f.pass().trace(), "W1!");
}

// ---- 4: which NAV the others accompany

TEST(Sequencer, in_apm1_commands_after_a_nav_run_while_it_is_flown) {
    Flight f(k1, {waypoint(), action1(), waypoint()});
    EXPECT_EQ(f.enter().trace(), "a2 W1!");
    EXPECT_EQ(f.reach().trace(), "+1 W3");
}

TEST(Sequencer, in_apm2_commands_after_a_nav_run_while_the_next_one_is_flown) {
    Flight f(k2, {waypoint(), action2(), waypoint()});
    EXPECT_EQ(f.enter().trace(), "W1!");
    EXPECT_EQ(f.reach().trace(), "+1 a2 W3");
}

TEST(Sequencer, in_apm2_set_home_between_two_waypoints_runs_at_the_first_and_alone_never) {
    Flight with(k2, {waypoint(), action2(), waypoint()});
    with.enter();
    EXPECT_EQ(with.reach().trace(), "W1! +1 a2 W3");
    Flight without(k2, {waypoint(), action2()});
    without.enter();
    EXPECT_EQ(without.reach().trace(), "W1! +1 RTL");
}

TEST(Sequencer, in_apm1_what_follows_the_last_nav_accompanies_it) {
    Flight f(k1, {waypoint(), action1()});
    EXPECT_EQ(f.enter().trace(), "a2 W1!");
    EXPECT_EQ(f.reach().trace(), "+1 RTL");
}

TEST(Sequencer, trailing_commands_run_when_asked_for_while_the_last_place_is_circled) {
    Flight f(k2, {waypoint(), action2(), condition2(), action2()}, true);
    EXPECT_EQ(f.enter().trace(), "W1!");
    EXPECT_EQ(f.reach().trace(), "+1 hold1 a2 c3");
    EXPECT_EQ(f.reach().trace(), "") << "no NAV is there to finish";
    EXPECT_EQ(f.over().trace(), "a4 RTL");
}

TEST(Sequencer, without_trailing_commands_there_is_nothing_to_hold_for) {
    Flight f(k2, {waypoint()}, true);
    f.enter();
    EXPECT_EQ(f.reach().trace(), "W1! +1 RTL");
}

TEST(Sequencer, a_trailing_jump_continues_the_mission) {
    Flight f(k2, {waypoint(), waypoint(), jump2(1, 1)}, true);
    f.enter().reach().reach();
    EXPECT_EQ(f.trace(), "W1! +1 W2 +2 hold2 W1");
    f.reach().reach();
    EXPECT_EQ(f.trace(), "+1 W2 +2 hold2 RTL");
}

TEST(Sequencer, nothing_trails_a_land) {
    Flight f(k2, {waypoint(), land(), action2()}, true);
    f.enter().reach().reach();
    EXPECT_EQ(f.trace(), "W1! +1 W2 +2 landed");
}

TEST(Sequencer, a_jump_of_n_repeats_flies_the_body_n_plus_1_times_and_is_then_passed_over) {
    Flight f(k2, {waypoint(), waypoint(), jump2(1, 2), action2(), waypoint()});
    f.enter();
    for (int i = 0; i < 6; ++i) f.reach();
    EXPECT_EQ(f.trace(), "W1! +1 W2 +2 W1 +1 W2 +2 W1 +1 W2 +2 a4 W5");
}

TEST(Sequencer, commands_after_a_jump_run_only_when_it_is_passed_over) {
    Flight f(k2, {waypoint(), jump2(1, 1), action2(), waypoint()});
    f.enter().reach();
    EXPECT_EQ(f.trace(), "W1! +1 W1");
    EXPECT_EQ(f.reach().trace(), "+1 a3 W4");
}

TEST(Sequencer, an_apm2_jump_behind_a_condition_waits_for_it_and_abandons_the_nav) {
    Flight f(k2, {waypoint(), condition2(), jump2(1, 1), action2(), waypoint()});
    f.enter().reach();
    EXPECT_EQ(f.trace(), "W1! +1 W5 c2");
    EXPECT_EQ(f.pass().trace(), "");
    EXPECT_EQ(f.over().trace(), "W1!") << "mid-leg: the leg begins at the airplane";
}

TEST(Sequencer, an_apm2_jump_to_an_action_runs_it_beside_the_nav_that_follows) {
    Flight f(k2, {waypoint(), action2(), waypoint(), jump2(2, 1), waypoint()});
    f.enter().reach().reach();
    EXPECT_EQ(f.trace(), "W1! +1 a2 W3 +3 a2 W3");
}

TEST(Sequencer, an_apm2_jump_past_the_last_nav_completes_or_runs_what_trails) {
    const std::vector<Record> items = {waypoint(), jump2(4, 1), waypoint(), action2()};
    Flight without(k2, items);
    without.enter().reach();
    EXPECT_EQ(without.trace(), "W1! +1 RTL");
    Flight with(k2, items, true);
    with.enter().reach();
    EXPECT_EQ(with.trace(), "W1! +1 hold3 a4 RTL");
}

TEST(Sequencer, the_apm1_jump_to_one_flies_1_2_1_2) {
    Flight f(k1, {waypoint(), waypoint(), toOne()});
    f.enter();
    for (int i = 0; i < 4; ++i) f.reach();
    EXPECT_EQ(f.trace(), "W1! +1 W2 +2 W1 +1 W2 +2 W1");
}

TEST(Sequencer, an_apm1_jump_does_not_abandon_the_nav_being_flown) {
    Flight f(k1, {waypoint(), action1(), condition1(), jump1(2), waypoint()});
    EXPECT_EQ(f.enter().trace(), "a2 W1! c3");
    EXPECT_EQ(f.over().trace(), "a2 c3") << "the relay works again";
    EXPECT_EQ(f.over().trace(), "a2 c3");
    EXPECT_EQ(f.reach().trace(), "+1 W5");
}

TEST(Sequencer, an_apm1_jump_to_a_nav_waits_until_the_nav_being_flown_finishes) {
    Flight f(k1, {waypoint(), waypoint(), jump1(4), waypoint(), waypoint()});
    f.enter().reach();
    f.trace();
    EXPECT_EQ(f.pass().trace(), "");
    EXPECT_EQ(f.reach().trace(), "+2 W4");
}

TEST(Sequencer, an_apm1_jump_not_reached_when_the_nav_finishes_is_dropped) {
    Flight f(k1, {waypoint(), condition1(), jump1(1), waypoint()});
    f.enter();
    EXPECT_EQ(f.reach().trace(), "W1! c2 +1 W4");
}

TEST(Sequencer, in_apm1_a_condition_holds_a_jump) {
    Flight f(k1, {waypoint(), condition1(), toOne(), waypoint()});
    f.enter();
    EXPECT_EQ(f.over().trace(), "W1! c2");
    EXPECT_EQ(f.reach().trace(), "+1 W1 c2");
}

// ---- 5: the end

TEST(Sequencer, when_no_nav_is_left_the_mission_is_complete) {
    Flight f(k2, {waypoint()});
    f.enter().reach();
    EXPECT_EQ(f.trace(), "W1! +1 RTL");
    EXPECT_TRUE(f.engine.ended());
    EXPECT_EQ(f.engine.current(), 0);
}

TEST(Sequencer, after_a_land_only_a_takeoff_is_loaded) {
    Flight f(k2, {land(), action2(), takeoff(), waypoint()});
    f.enter().reach();
    EXPECT_EQ(f.trace(), "W1! +1 a2 W3");
    EXPECT_EQ(f.reach().trace(), "+3 W4!");
    Flight g(k2, {land(), waypoint()});
    EXPECT_EQ(g.enter().reach().trace(), "W1! +1 landed");
    Flight h(k1, {land(), action1(), waypoint()});
    EXPECT_EQ(h.enter().reach().trace(), "a2 W1! +1 landed");
}

TEST(Sequencer, a_jump_cannot_fly_an_airplane_that_stands_after_a_land) {
    Flight f(k2, {waypoint(), land(), jump2(1, -1), takeoff()});
    f.enter().reach().reach();
    EXPECT_EQ(f.trace(), "W1! +1 W2 +2 landed");
}

// ---- 6: leaving and coming back

TEST(Sequencer, coming_back_resumes_the_nav_and_the_chain_where_it_stood) {
    Flight f(k2, {waypoint(), action2(), condition2(), action2(), waypoint()});
    f.enter().reach();
    EXPECT_EQ(f.trace(), "W1! +1 a2 W5 c3");
    f.engine.leave();
    world.condition_done = true;
    EXPECT_EQ(f.pass().trace(), "") << "nothing runs outside AUTO";

    EXPECT_EQ(f.enter().trace(), "W5~ c3") << "the condition begins again, the action does not";
    EXPECT_EQ(f.over().trace(), "a4");
}

TEST(Sequencer, what_had_been_dropped_stays_dropped_after_a_resume) {
    Flight f(k2, {waypoint(), condition2(), action2(), waypoint(), waypoint()});
    f.enter().reach().reach();
    f.engine.leave();
    f.trace();
    EXPECT_EQ(f.enter().trace(), "W5~");
    EXPECT_EQ(f.over().trace(), "");
}

TEST(Sequencer, a_nav_without_a_place_keeps_the_one_it_took_when_it_first_loaded) {
    Flight f(k2, {waypointHere(), waypoint()});
    EXPECT_EQ(f.enter().trace(), "W1!@500");
    f.engine.leave();
    world.here = 900;
    EXPECT_EQ(f.enter().trace(), "W1~@500");
}

TEST(Sequencer, jump_counters_survive_leaving_auto_but_not_a_restart) {
    const std::vector<Record> items = {waypoint(), jump2(1, 1), waypoint()};
    Flight f(k2, items);
    f.enter().reach();
    f.engine.leave();
    f.enter();
    f.trace();
    EXPECT_EQ(f.reach().trace(), "+1 W3") << "the one jump had been taken";

    f.engine.leave();
    EXPECT_EQ(f.enter(true).trace(), "W1!") << "MIS_RESTART";
    EXPECT_EQ(f.reach().trace(), "+1 W1");
}

TEST(Sequencer, entering_after_completion_is_a_restart) {
    Flight f(k2, {waypoint(), jump2(1, 1), waypoint()});
    f.enter().reach().reach().reach();
    EXPECT_EQ(f.trace(), "W1! +1 W1 +1 W3 +3 RTL");
    f.engine.leave();
    f.enter().reach();
    EXPECT_EQ(f.trace(), "W1! +1 W1");
}

TEST(Sequencer, a_handler_that_ends_auto_in_the_middle_of_a_pass_is_not_run_twice) {
    Flight f(k1, {waypoint(), action1(), action1()});
    world.leave_at_action = true;
    EXPECT_EQ(f.enter().trace(), "a2");
    EXPECT_FALSE(f.engine.active());
    world.leave_at_action = false;
    EXPECT_EQ(f.enter().trace(), "a3 W1!");
}

TEST(Sequencer, coming_back_begins_a_new_pass_so_a_jump_taken_before_is_taken_again) {
    Flight one(k1, {waypoint(), action1(), jump1(2)});
    world.leave_at_action = true;
    EXPECT_EQ(one.enter().trace(), "a2");
    EXPECT_EQ(one.enter().trace(), "a2");
    EXPECT_EQ(one.enter().trace(), "a2");
    Flight two(k2, {action2(), jump2(1, -1), waypoint()});
    world.leave_at_action = true;
    for (int i = 0; i < 6; ++i) EXPECT_EQ(two.enter().trace(), "a1");
}

TEST(Sequencer, memory_that_survived_a_reset_resumes_with_counters_and_chain_position) {
    Flight f(k2, {waypoint(), jump2(1, 1), action2(), condition2(), action2(), waypoint()});
    f.enter().reach().reach();
    EXPECT_EQ(f.trace(), "W1! +1 W1 +1 a3 W6 c4");

    f.engine.boot(k2, 1, true, 1);

    EXPECT_EQ(f.enter().trace(), "W6~ c4");
    EXPECT_EQ(f.over().trace(), "a5");
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
    EXPECT_FALSE(items.to_end);

    f.engine.changed(k2, 2, true, false);

    EXPECT_EQ(f.over().trace(), "a4");
    f.engine.setCurrent(1);
    f.pass().reach();
    EXPECT_EQ(f.trace(), "W1! +1 W1");
}

TEST(Sequencer, after_a_change_elsewhere_an_apm1_jump_that_came_round_stays_passed_over) {
    Flight f(k1, {waypoint(), action1(), jump1(2), condition1(), jump1(2)});
    EXPECT_EQ(f.enter().trace(), "a2 a2 W1! c4");
    f.engine.changed(k1, 2, true, false);
    EXPECT_EQ(f.over().trace(), "a2 c4") << "no other NAV has been loaded";
}

TEST(Sequencer, a_change_in_flight_restarts_the_mission) {
    Flight f(k2, {waypoint(), waypoint(), waypoint()});
    f.enter().reach();
    f.trace();
    f.store(k1, {waypoint(), action1()});
    f.engine.changed(k1, 2, false, false);
    EXPECT_EQ(f.pass().trace(), "a2 W1!");
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

TEST(Sequencer, a_jump_to_itself_is_skipped_at_run_time) {
    Flight f(k2, {waypoint(), jump2(2, -1), waypoint()});
    f.enter().reach();
    EXPECT_EQ(f.trace(), "W1! +1 ?2 W3");
}

TEST(Sequencer, apm2_jumps_that_never_meet_a_nav_end_after_count_steps) {
    Flight f(k2, {action2(), jump2(1, -1), action2(), waypoint()});
    f.enter();
    // 5 items: a1 j a1 j a1, then jumps are passed over
    EXPECT_EQ(f.trace(), "a1 a1 a1 loop2 a3 W4!");
    EXPECT_EQ(f.pass().trace(), "");
    EXPECT_EQ(f.reach().trace(), "+4 RTL");
}

TEST(Sequencer, a_jump_passed_over_for_the_step_limit_costs_no_count) {
    Flight f(k2, {waypoint(), action2(), jump2(2, 9), waypoint()});
    f.enter().reach();
    EXPECT_EQ(f.trace(), "W1! +1 a2 a2 a2 loop3 W4") << "5 steps: a j a j a";
    f.engine.setCurrent(2);
    f.pass();
    EXPECT_EQ(f.trace(), "a2 a2 a2 loop3 W4!");
    for (int i = 0; i < 2; ++i) {
        f.engine.setCurrent(2);
        f.pass();
    }
    f.trace();
    f.engine.setCurrent(2);
    f.pass();
    EXPECT_EQ(f.trace(), "a2 a2 W4!") << "9 jumps in all: 2 + 2 + 2 + 2 and now the last";
}

TEST(Sequencer, the_nav_loaded_at_the_end_of_a_pass_is_checked_whatever_jumps_do) {
    Flight f(k2, {waypoint(), jump2(1, -1), waypoint()});
    f.enter();
    for (int i = 0; i < 5; ++i) EXPECT_NE(f.reach().trace().find("+1"), std::string::npos);
}

TEST(Sequencer, an_apm1_jump_that_comes_round_is_passed_over_until_the_next_nav_loads) {
    Flight f(k1, {waypoint(), action1(), jump1(2), action1(), condition1(), jump1(2), waypoint()});
    EXPECT_EQ(f.enter().trace(), "a2 a2 a4 W1! c5");
    EXPECT_EQ(f.over().trace(), "a2 a4 c5") << "the second jump is taken, the first passed over";
    EXPECT_EQ(f.reach().trace(), "+1 W7");
    f.engine.setCurrent(1);
    EXPECT_EQ(f.pass().trace(), "a2 a2 a4 W1! c5") << "it had been loaded anew";
}

TEST(Sequencer, two_apm1_jumps_that_point_at_each_other_do_not_hang) {
    Flight f(k1, {waypoint(), jump1(3), jump1(2), action1(), waypoint()});
    EXPECT_EQ(f.enter().trace(), "a4 W1!");
    EXPECT_EQ(f.reach().trace(), "+1 W5");
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

TEST(Sequencer, set_current_abandons_the_nav_and_goes_on_at_the_item) {
    Flight two(k2, {waypoint(), waypoint(), action2(), waypoint()});
    two.enter();
    two.trace();
    ASSERT_TRUE(two.engine.setCurrent(3));
    EXPECT_EQ(two.pass().trace(), "a3 W4!");
    Flight one(k1, {waypoint(), waypoint(), action1(), waypoint(), action1()});
    one.enter();
    one.trace();
    ASSERT_TRUE(one.engine.setCurrent(3));
    EXPECT_EQ(one.pass().trace(), "a5 W4!") << "the first NAV at or after it";
}

TEST(Sequencer, set_current_beyond_the_end_is_refused_and_changes_nothing) {
    Flight f(k2, {waypoint(), waypoint()});
    f.enter();
    f.trace();
    EXPECT_FALSE(f.engine.setCurrent(3));
    EXPECT_EQ(f.engine.current(), 1);
    EXPECT_EQ(f.reach().trace(), "+1 W2");
}

TEST(Sequencer, set_current_outside_auto_sets_where_auto_begins) {
    Flight f(k2, {waypoint(), jump2(1, 1), waypoint()});
    ASSERT_TRUE(f.engine.setCurrent(3));
    EXPECT_EQ(f.engine.current(), 3);
    EXPECT_EQ(f.enter().trace(), "W3!");
    f.engine.leave();
    ASSERT_TRUE(f.engine.setCurrent(1));
    EXPECT_EQ(f.enter(true).trace(), "W1!") << "MIS_RESTART does not overrule it";
    EXPECT_EQ(f.reach().trace(), "+1 W1") << "jump tracking is set up before the first AUTO";
}

TEST(Sequencer, set_current_costs_no_count_and_0_restarts_with_everything_reset) {
    Flight f(k2, {waypoint(), jump2(1, 1), waypoint()});
    f.enter().reach();
    f.engine.setCurrent(1);
    f.pass();
    f.trace();
    EXPECT_EQ(f.reach().trace(), "+1 W3") << "the count was used up before";
    f.engine.setCurrent(0);
    f.pass();
    EXPECT_EQ(f.reach().trace(), "W1! +1 W1");
}

// ---- 10: the leg

TEST(Sequencer, a_leg_begins_where_the_last_nav_finished) {
    Flight f(k2, {waypoint(), waypoint(), jump2(1, 1), waypoint()});
    f.enter().reach();
    f.trace();
    EXPECT_EQ(f.reach().trace(), "+2 W1") << "the abandoned NAV 4 was never started";
}

TEST(Sequencer, a_leg_begins_at_the_airplane_after_a_takeoff) {
    Flight f(k2, {takeoff(), waypoint(), waypoint()});
    EXPECT_EQ(f.enter().reach().reach().trace(), "W1! +1 W2! +2 W3");
}

TEST(Sequencer, an_abandoned_nav_never_becomes_a_legs_start) {
    Flight f(k2, {waypoint(), condition2(), jump2(5, 1), waypoint(), waypoint(), waypoint()});
    f.enter().reach();
    EXPECT_EQ(f.trace(), "W1! +1 W4 c2");
    EXPECT_EQ(f.over().trace(), "W5!");
    EXPECT_EQ(f.reach().trace(), "+5 W6");
}

TEST(Sequencer, a_nav_that_a_jump_abandons_in_the_pass_that_loaded_it_is_not_started) {
    Flight f(k2, {waypoint(), jump2(4, 1), land(), waypoint()});
    f.enter();
    EXPECT_EQ(f.reach().trace(), "W1! +1 W4");
}

}  // namespace
