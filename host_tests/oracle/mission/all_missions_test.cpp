// SPDX-License-Identifier: GPL-3.0-or-later
// Every mission of up to three commands of every class, in both sets: engine and oracle agree on
// every flight of it, and its longest pass is as long as the mission tool says.
// ORACLE_LENGTH=4 flies those of up to four.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "toolchain/mission_tool/passes.hpp"
#include "trial.hpp"

namespace {

using namespace oracle;

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
    for (int target = 1; target <= length; ++target) {
        if (apm1) all.push_back(make(set, 0x75, 0, target, 0, 0));
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
            item.target = static_cast<size_t>(c.id == 0x31 ? 1 : c.id == 0x75 ? c.p2 : c.p1);
            item.counted = c.id == 0xB1 && c.p3 > 0;
            counted = counted || item.counted;
            jumps = true;
        }
        items.push_back(item);
    }
    return items;
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
    long missions = 0, flown = 0;
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
        ++missions;
        flown += flights.flown;
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
    }
    printf("APM %s, %d commands, MIS_TRAILING %d: %ld missions, %ld flights\n",
           set == CommandSet::apm1 ? "1.0" : "2.0", length, trailing, missions, flown);
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
