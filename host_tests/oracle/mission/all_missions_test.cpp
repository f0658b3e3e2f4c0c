// SPDX-License-Identifier: GPL-3.0-or-later
// Every mission of up to three commands of every class, in both sets: engine and oracle agree on
// every flight of it, and its longest pass is as long as computed: by passes.cpp for any mission,
// by the board's LongestPass for those that a board takes. What it refuses has jumps that go round.
// ORACLE_LENGTH=4 flies those of up to four, ORACLE_WIDE=1 those of every kind of a class.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "mission/longest_pass.hpp"
#include "passes.hpp"
#include "trial.hpp"

namespace {

using namespace oracle;

// More NAVs, CONDITIONs and DOs, and what is out of range.
const int kWide1[][5] = {{0x10, 0, 0, 0, 0},
                         {0x11, 0, 0, 1, 1},
                         {0x12, 1, 0, 1, 1},
                         {0x13, 1, 0, 1, 1},
                         {0x14, 0, 0, 0, 0},
                         {0x21, 0, 0, 0, 0},
                         {0x10, kOutOfRange, 0, 1, 1},
                         {0x20, kOutOfRange, 0, 0, 0},
                         {0x81, kOutOfRange, 0, 0, 0},
                         {0x40, 0, 0, 0, 0},
                         {0x82, 0, 0, 0, 0}};
const int kWide2[][5] = {{0x10, 0, 0, 0, 0},           {0x12, 1, 0, 1, 1},
                         {0x14, 0, 0, 0, 0},           {0x17, 0, 0, 1, 1},
                         {0x1E, 0, 0, 0, 0},           {0x1F, 0, 0, 1, 1},
                         {0x72, 0, 0, 0, 0},           {0x10, kOutOfRange, 0, 1, 1},
                         {0x70, kOutOfRange, 0, 0, 0}, {0xB5, kOutOfRange, 0, 0, 0}};

std::vector<Bytes> alphabet(CommandSet set, int length) {
    const bool apm1 = set == CommandSet::apm1;
    std::vector<Bytes> all = {
        make(set, 0x10, 0, 0, 1, 1),
        make(set, 0x15, 0, 0, 1, 1),
        make(set, 0x16, 0, 0, 0, 0),
        make(set, apm1 ? 0x20 : 0x70, 0, 0, 0, 0),
        make(set, apm1 ? 0x81 : 0xB5, 0, 0, 0, 0),
        make(set, 0xEE, 0, 0, 0, 0),
    };
    if (apm1) all.push_back(make(set, 0x31, 0, 0, 0, 0));
    const bool wide = std::getenv("ORACLE_WIDE") != nullptr;
    const auto add = [&](const int(&c)[5]) {
        all.push_back(make(set, c[0], c[1], c[2], c[3], c[4]));
    };
    if (wide && apm1) std::for_each(std::begin(kWide1), std::end(kWide1), add);
    if (wide && !apm1) std::for_each(std::begin(kWide2), std::end(kWide2), add);
    for (int target = 1; target <= length; ++target) {
        if (apm1) all.push_back(make(set, 0x75, 0, target, 0, 0));
        if (apm1 && wide) all.push_back(make(set, 0x75, target, 0, 0, 0));
        for (const int times : {-1, 1, 2})
            if (!apm1) all.push_back(make(set, 0xB1, target, 0, times, 0));
    }
    return all;
}

std::vector<mission_tool::PassItem> itemsOf(const Stored& stored, bool& counted, bool& jumps) {
    std::vector<mission_tool::PassItem> items;
    for (size_t i = 0; i < stored.mission.size(); ++i) {
        const Command c = decode(stored.set, stored.mission, static_cast<int>(i));
        mission_tool::PassItem item;
        item.good = c.kind != Kind::nothing;
        item.kind = c.kind == Kind::nav         ? mission::Class::nav
                    : c.kind == Kind::condition ? mission::Class::condition
                    : c.kind == Kind::jump      ? mission::Class::jump
                                                : mission::Class::action;
        if (c.kind == Kind::jump) {
            const bool in_p1 = c.id == 0xB1 || c.p2 == 0;
            item.target = static_cast<size_t>(c.id == 0x31 ? 1 : in_p1 ? c.p1 : c.p2);
            item.counted = c.id == 0xB1 && c.p3 > 0;
            counted = counted || item.counted;
            jumps = true;
        }
        items.push_back(item);
    }
    return items;
}

struct Sums {
    long missions = 0, flown = 0, taken = 0, refused = 0, exact = 0;
};

// What a board computes before it takes a mission, if it can be stored at all.
void compareWithBoard(const Stored& stored, const std::vector<mission_tool::PassItem>& items,
                      int flown, Sums& sums) {
    using mission::LongestPass;
    const auto count = static_cast<uint8_t>(items.size());
    const bool apm1 = stored.set == CommandSet::apm1;
    const auto set = apm1 ? mission::Set::apm1 : mission::Set::apm2;
    LongestPass board;
    board.begin(set);
    bool counted = false;
    for (uint8_t i = 1; i < count; ++i) {
        if (!items[i].good) return;
        counted = counted || items[i].counted;
        board.add(i, items[i].kind,
                  {static_cast<uint8_t>(items[i].target),
                   static_cast<int16_t>(items[i].counted ? 1 : mission::kForEver)});
    }
    LongestPass::Verdict verdict;
    while ((verdict = board.step(count)) == LongestPass::Verdict::busy) {
    }
    Trial shown;
    shown.missions = {stored};
    const size_t round = mission_tool::jumpThatGoesRound(set, items);
    if (verdict != LongestPass::Verdict::fine) {
        ++sums.refused;
        ASSERT_NE(verdict, LongestPass::Verdict::too_long) << readable(shown);
        ASSERT_EQ(items[board.item()].kind, mission::Class::jump) << readable(shown);
        const bool loops = verdict == LongestPass::Verdict::goes_round;
        ASSERT_TRUE(round != 0 || counted || !loops) << readable(shown);
        return;
    }
    ++sums.taken;
    const auto isNav = [&](size_t i) { return items[i].kind == mission::Class::nav; };
    size_t first_nav = 1;
    while (!isNav(first_nav)) ++first_nav;
    // one of the 1.0 set may never be come to
    ASSERT_TRUE(round == 0 || apm1) << readable(shown);
    const mission_tool::PassCost cost = {LongestPass::kLook,
                                         LongestPass::kRun - LongestPass::kLook};
    const double longest = mission_tool::longestPass(set, items, true, cost).cost;
    ASSERT_GE(board.longest(), flown * LongestPass::kLook) << readable(shown);
    if (counted)  // passes.cpp lets such a jump be both taken and passed over
        ASSERT_LE(board.longest(), longest) << readable(shown);
    else if (apm1 && first_nav != 1)  // a CONDITION before it counts as one that is come to
        ASSERT_GE(board.longest(), longest) << readable(shown);
    else
        ASSERT_EQ(board.longest(), longest) << readable(shown);
    sums.exact += flown == mission_tool::longestPass(set, items, true, {1, 0}).cost;
}

// What may happen after AUTO was entered at an item: all there is, three times.
struct Flights {
    long flown = 0;
    std::string different;
    int most = 0;

    void fly(const Trial& trial) {
        ++flown;
        const std::string parted = oracle::fly(trial, nullptr, nullptr, &most);
        if (!parted.empty() && different.empty()) different = readable(trial) + parted;
    }
    void all(const Stored& stored, bool trailing) {
        const int count = static_cast<int>(stored.mission.size());
        for (int first = 0; first < count; ++first)
            for (int happens = 0; happens < 8; ++happens) {
                Trial trial;
                trial.missions = {stored};
                trial.steps = {{Happens::trailing, trailing, {}}};
                if (first != 0) trial.steps.push_back({Happens::set_current, first, {}});
                trial.steps.push_back({Happens::enter, 0, {}});
                for (int bit = 0; bit < 3; ++bit) {
                    Step step;
                    step.how.nav = (happens >> bit & 1) != 0;
                    step.how.condition = !step.how.nav;
                    trial.steps.push_back(step);
                }
                fly(trial);
            }
    }
};

void flyAll(CommandSet set, int length, bool trailing) {
    const std::vector<Bytes> words = alphabet(set, length);
    Sums sums;
    size_t number = 1;
    for (int i = 0; i < length; ++i) number *= words.size();
    for (size_t n = 0; n < number; ++n) {
        Stored stored{set, {make(set, 0x10, 0, 0, 7, 7)}};
        size_t digits = n;
        for (int i = 1; i <= length; ++i, digits /= words.size()) {
            Bytes bytes = words[digits % words.size()];
            const bool jump = bytes[0] == 0xB1 || bytes[0] == 0x75 || bytes[0] == 0x31;
            if (!jump) bytes[set == CommandSet::apm1 ? 2 : 3] = static_cast<uint8_t>(i);
            stored.mission.push_back(bytes);
        }
        if (!holdsNav(set, stored.mission)) continue;
        Flights flights;
        flights.all(stored, trailing);
        ++sums.missions;
        sums.flown += flights.flown;
        ASSERT_EQ(flights.different, "");
        bool counted = false, jumps = false;
        const auto items = itemsOf(stored, counted, jumps);
        const auto engine_set = set == CommandSet::apm1 ? mission::Set::apm1 : mission::Set::apm2;
        const double most = mission_tool::longestPass(engine_set, items, trailing, {1, 0}).cost;
        Trial shown;
        shown.missions = {stored};
        if (counted)
            ASSERT_LE(flights.most, most) << readable(shown);
        else
            ASSERT_EQ(flights.most, most) << readable(shown) << trailing;
        if (trailing || set == CommandSet::apm1)
            compareWithBoard(stored, items, flights.most, sums);
        if (testing::Test::HasFatalFailure()) return;
    }
    printf(
        "APM %s, %d commands, MIS_TRAILING %d: %ld missions, %ld flights; a board takes %ld and "
        "refuses %ld; the longest pass was flown in %ld\n",
        set == CommandSet::apm1 ? "1.0" : "2.0", length, trailing, sums.missions, sums.flown,
        sums.taken, sums.refused, sums.exact);
    fflush(stdout);
}

TEST(AllMissions, of_up_to_three_commands_are_flown_as_the_oracle_says_and_no_pass_is_longer) {
    const char* wanted = std::getenv("ORACLE_LENGTH");
    const int longest = wanted != nullptr ? std::atoi(wanted) : 3;
    for (int length = 1; length <= longest; ++length)
        for (const bool trailing : {false, true}) {
            flyAll(CommandSet::apm2, length, trailing);
            if (!trailing) flyAll(CommandSet::apm1, length, trailing);
        }
}

}  // namespace
