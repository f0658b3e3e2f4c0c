// SPDX-License-Identifier: GPL-3.0-or-later
// host_tests/oracle/mission/all_missions_test.cpp compares it with the engine.
#include "mission/longest_pass.hpp"

#include <gtest/gtest.h>

namespace {

using mission::Class;
using mission::LongestPass;
using mission::Set;
using Verdict = LongestPass::Verdict;

struct Outcome {
    Verdict verdict;
    uint8_t item;
    uint16_t longest;
    int calls;
};

// A letter an item: W a NAV, C a CONDITION, D a DO, J a jump and K one with a count to the item
// whose number stands behind it in two digits.
Outcome pass(Set set, const char* items) {
    LongestPass passes;
    passes.begin(set);
    uint8_t count = 1;
    for (const char* c = items; *c != 0; ++c, ++count) {
        const Class kind = *c == 'W'   ? Class::nav
                           : *c == 'C' ? Class::condition
                           : *c == 'D' ? Class::action
                                       : Class::jump;
        mission::Jump jump = {0, static_cast<int16_t>(*c == 'K' ? 3 : mission::kForEver)};
        if (kind == Class::jump) {
            jump.target = static_cast<uint8_t>(10 * (c[1] - '0') + c[2] - '0');
            c += 2;
        }
        passes.add(count, kind, jump);
    }
    Outcome outcome = {Verdict::busy, 0, 0, 0};
    while (outcome.verdict == Verdict::busy) {
        outcome.verdict = passes.step(count);
        ++outcome.calls;
    }
    outcome.item = passes.item();
    outcome.longest = passes.longest();
    return outcome;
}

constexpr uint16_t kLook = LongestPass::kLook, kRun = LongestPass::kRun;

TEST(LongestPass, of_a_mission_without_jumps_is_its_longest_chain) {
    EXPECT_EQ(pass(Set::apm2, "WWW").longest, kLook);
    EXPECT_EQ(pass(Set::apm2, "WDDWDDDW").longest, 4 * kLook + 3 * kRun);
    EXPECT_EQ(pass(Set::apm1, "WDDWDDDW").longest, 4 * kLook + 3 * kRun) << "to item 4, and item 8";
    EXPECT_EQ(pass(Set::apm2, "WDCDDDW").longest, 4 * kLook + 3 * kRun) << "behind the CONDITION";
    EXPECT_EQ(pass(Set::apm1, "WDCDDDW").longest, kLook + 3 * kRun);
}

TEST(LongestPass, goes_where_jumps_lead) {
    EXPECT_EQ(pass(Set::apm2, "WDJ05WDDW").longest,
              3 * kLook + kRun + kLook + 3 * kLook + 2 * kRun);
    EXPECT_EQ(pass(Set::apm1, "WDJ05WDDW").longest, kLook + kRun + kLook + 2 * kRun + kLook);
    EXPECT_EQ(pass(Set::apm2, "WDDK01W").longest, 4 * kLook + 2 * kRun + kLook + kLook);
    EXPECT_EQ(pass(Set::apm2, "WDK01DDDW").longest, 6 * kLook + 4 * kRun + kLook) << "passed over";
    EXPECT_EQ(pass(Set::apm2, "WWJ01").longest, kLook + kLook + kLook) << "a loop";
}

TEST(LongestPass, more_than_a_second_and_a_half_is_refused_where_it_begins) {
    const auto relays = [](size_t number) { return "WW" + std::string(number, 'D') + "W"; };
    EXPECT_EQ(pass(Set::apm2, relays(145).c_str()).verdict, Verdict::fine);
    const Outcome over = pass(Set::apm2, relays(146).c_str());
    EXPECT_EQ(over.verdict, Verdict::too_long);
    EXPECT_EQ(over.item, 3);
    EXPECT_EQ(pass(Set::apm1, relays(168).c_str()).verdict, Verdict::fine) << "no NAV is sought";
}

TEST(LongestPass, jumps_that_go_round_without_a_nav_or_condition_are_refused) {
    EXPECT_EQ(pass(Set::apm2, "J02J01W").verdict, Verdict::goes_round);
    EXPECT_EQ(pass(Set::apm2, "WDJ02W").item, 3);
    EXPECT_EQ(pass(Set::apm2, "WDK02W").verdict, Verdict::goes_round) << "with a count, too";
    EXPECT_EQ(pass(Set::apm1, "WDJ02W").verdict, Verdict::goes_round);
    EXPECT_EQ(pass(Set::apm2, "WDK01J02W").verdict, Verdict::goes_round) << "once it is used up";
    EXPECT_EQ(pass(Set::apm2, "WDJ01W").verdict, Verdict::fine);
    EXPECT_EQ(pass(Set::apm2, "WDCJ02W").verdict, Verdict::fine);
    EXPECT_EQ(pass(Set::apm1, "WDCJ02W").verdict, Verdict::fine);
}

// The mission that held up the next NAV for a minute and a half, when looks were not counted.
TEST(LongestPass, two_jumps_before_170_actions_are_refused) {
    EXPECT_EQ(pass(Set::apm2, ("J02J01" + std::string(167, 'D') + "W").c_str()).verdict,
              Verdict::goes_round);
}

TEST(LongestPass, more_jumps_than_it_has_room_for_are_refused) {
    std::string jumps = "W";
    for (int i = 0; i < LongestPass::kMaxJumps; ++i) jumps += "J01";
    EXPECT_EQ(pass(Set::apm2, (jumps + "W").c_str()).verdict, Verdict::fine);
    const Outcome over = pass(Set::apm2, (jumps + "J01W").c_str());
    EXPECT_EQ(over.verdict, Verdict::too_many);
    EXPECT_EQ(over.item, 34);
}

TEST(LongestPass, it_comes_to_an_end_soon_whatever_the_jumps_are) {
    int most = 0;
    uint32_t random = 1;
    const auto below = [&random](uint32_t limit) {
        random = random * 1664525u + 1013904223u;
        return (random >> 8) % limit;
    };
    for (int n = 0; n < 3000; ++n) {
        std::string items;
        const uint32_t length = 1 + below(90), jumps = below(32);
        for (uint32_t i = 0; i < length; ++i) {
            const bool jump = below(length) < jumps;
            items += jump ? (below(2) == 0 ? "J" : "K") : std::string(1, "WCDDDD"[below(6)]);
            if (!jump) continue;
            const uint32_t target = 1 + below(length);
            items += static_cast<char>('0' + target / 10);
            items += static_cast<char>('0' + target % 10);
        }
        most = std::max(most, pass(n % 2 == 0 ? Set::apm1 : Set::apm2, items.c_str()).calls);
    }
    EXPECT_LE(most, 168) << "8,000 steps";
    std::string each = "W";  // a jump with a count before every NAV
    for (int i = 0; i < 15; ++i) each += "DDDK01W";
    EXPECT_LE(pass(Set::apm2, each.c_str()).calls, 10);
    EXPECT_LE(pass(Set::apm2, std::string(99, 'W').c_str()).calls, 3);
}

}  // namespace
