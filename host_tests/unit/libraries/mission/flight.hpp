// SPDX-License-Identifier: GPL-3.0-or-later
// A mission of made-up commands flown by the engine, and what happened as a line of words:
//   W5 starts WAYPOINT 5 (from the last place; W5! from the airplane; W5~ resumed)   +5 reached
//   a5 action 5 run    c5 CONDITION 5 started    ?5 skipped    loop5    hold5    RTL    landed
#pragma once
#include <gtest/gtest.h>

#include <string.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "mission/sequencer.hpp"

namespace flight {

using namespace mission;

// Every record carries its own index in p4, so that a handler can say who it is; a waypoint
// without a place in p2.
inline Record waypoint() { return {16, 0, 0, 100, 1, 0}; }
inline Record waypointHere() { return {16, 0, 0, 0, 0, 0}; }
inline Record land() { return {21, 0, 0, 0, 1, 0}; }
inline Record takeoff() { return {22, 0, 0, 0, 0, 0}; }
inline Record condition1() { return {0x20, 0, 0, 0, 0, 0}; }
inline Record condition2() { return {112, 0, 0, 0, 0, 0}; }
inline Record action1() { return {0x81, 0, 0, 0, 0, 0}; }
inline Record action2() { return {181, 0, 0, 0, 0, 0}; }
inline Record jump2(uint8_t target, int16_t times) { return {177, 0, target, 0, times, 0}; }
inline Record toOne() { return {0x31, 0, 0, 0, 0, 0}; }
inline Record jump1(uint8_t target) { return {0x75, 0, 0, target, 0, 0}; }
inline Record unknown() { return {0xEE, 0, 0, 0, 0, 0}; }
inline Record outOfRange(Record record) {
    record.p1 = 99;
    return record;
}
inline Record leavesAuto(Record record) {
    record.p1 = 98;
    return record;
}

struct World {
    std::vector<std::vector<uint8_t>> stored;
    std::string trace;
    bool nav_done = false, condition_done = false;
    std::set<int> busy;  // records the store does not have yet
    std::set<int> lost;  // and those it will not have again
    int reads = 0, max_reads = 0, all_reads = 0;
    int here = 500;  // where the airplane is
    Sequencer* engine = nullptr;
};
static World world;

inline void say(const std::string& word) { world.trace += (world.trace.empty() ? "" : " ") + word; }
inline std::string number(const Record& record) {
    return std::to_string(record.p4 != 0 ? record.p4 : record.p2);
}

inline uint8_t inRange(const Record& record, ItemPosition) { return record.p1 == 99 ? 5 : 0; }
inline void begin(const Record& record, LegStart start) {
    say("W" + number(record) +
        (start.resumed     ? "~"
         : start.from_here ? "!"
                           : "") +
        (record.p3 >= 500 ? "@" + std::to_string(record.p3) : ""));
}
inline Progress navDone(const Record&) {
    return world.nav_done ? Progress::done : Progress::running;
}
inline void wait(const Record& record) { say("c" + number(record)); }
inline Progress waited(const Record&) {
    return world.condition_done ? Progress::done : Progress::running;
}
inline void doIt(const Record& record) {
    say("a" + number(record));
    if (record.p1 == 98) world.engine->leave();
}
inline uint8_t jumpInRange(const Record& record, ItemPosition position) {
    return record.p1 == 0 || record.p1 >= position.count || record.p1 == position.index ? 6 : 0;
}
inline Jump counted(const Record& record) { return {record.p1, static_cast<int16_t>(record.p3)}; }
inline Jump first(const Record&) { return {1, kForEver}; }
inline Jump anywhere(const Record& record) { return {static_cast<uint8_t>(record.p2), kForEver}; }

constexpr Row kRows[] ROM = {
    nav(0x10, 16, 0, inRange, begin, navDone, kPlaced),
    nav(0x15, 21, 0, inRange, begin, navDone, kPlaced | kEndsFlight),
    nav(0x16, 22, 0, inRange, begin, navDone, kEndsNowhere | kBeginsFlight),
    condition(0x20, kNoId, 0, inRange, wait, waited),
    condition(kNoId, 112, 0, inRange, wait, waited),
    action(0x81, kNoId, 0, inRange, doIt),
    action(kNoId, 181, 0, inRange, doIt),
    jump(kNoId, 177, 0, jumpInRange, counted),
    jump(0x31, kNoId, 0, inRange, first),
    jump(0x75, kNoId, 0, inRange, anywhere),
};
static_assert(idsAreUnique(kRows), "");
static_assert(traitsMakeSense(kRows), "");
static_assert(idsIn(kRows, Set::apm1, 0) == 7 && idsIn(kRows, Set::apm2, 0) == 6, "");
const Table table = {kRows, static_cast<uint8_t>(core::count(kRows))};

inline core::Status readStored(uint8_t index, uint8_t* to) {
    ++world.reads;
    ++world.all_reads;
    if (world.busy.count(index) != 0) return core::Status::busy;
    if (world.lost.count(index) != 0) return core::Status::unsupported;
    std::copy(world.stored[index].begin(), world.stored[index].end(), to);
    return core::Status::ok;
}
inline uint8_t countStored() { return static_cast<uint8_t>(world.stored.size()); }
inline void reportEvent(Event event, uint8_t index) {
    const std::string i = std::to_string(index);
    switch (event) {
        case Event::started:
            break;
        case Event::reached:
            say("+" + i);
            break;
        case Event::skipped:
            say("?" + i);
            break;
        case Event::looped:
            say("loop" + i);
            break;
        case Event::hold:
            say("hold" + i);
            break;
        case Event::lost:
            say("lost" + i);
            break;
        case Event::complete:
            say("RTL");
            break;
        case Event::landed:
            say("landed");
            break;
        case Event::reset:
            break;
        default:
            break;
    }
}
inline void whereItIs(Record& record) { record.p3 = world.here; }
inline bool never() { return false; }
constexpr Host kHost ROM = {readStored, countStored, reportEvent, whereItIs, never};

// One flight: AUTO is entered, passes are made, NAVs and CONDITIONs finish on request.
class Flight {
public:
    explicit Flight(Set of, std::vector<Record> items, bool trailing = false)
        : trailing_(trailing) {
        world = World();
        world.engine = &engine;
        store(of, items);
        engine.boot(of, 1, false, 0);
    }
    void store(Set of, std::vector<Record> items) {
        items.insert(items.begin(), Record{16, 0, 0, 0, 7, 7});  // home
        world.stored.clear();
        for (size_t i = 0; i < items.size(); ++i) {
            const bool here = items[i].id == 16 && items[i].p3 == 0;
            (here ? items[i].p2 : items[i].p4) = static_cast<int32_t>(i);
            world.stored.emplace_back(kRecordSize);
            pack(of, items[i], world.stored.back().data());
        }
    }

    Flight& enter(bool restart = false) {
        engine.enter(restart);
        return pass();
    }
    // One pass to its end, however many polls the engine makes of it.
    Flight& pass() {
        Memory before;
        do {
            memcpy(&before, &memory, sizeof memory);
            world.reads = 0;
            engine.poll(trailing_);
            world.max_reads = std::max(world.max_reads, world.reads);
            world.nav_done = world.condition_done = false;
        } while (memcmp(&before, &memory, sizeof memory) != 0);
        return *this;
    }
    Flight& reach() {
        world.nav_done = true;
        return pass();
    }
    Flight& over() {
        world.condition_done = true;
        return pass();
    }
    std::string trace() {
        std::string said;
        said.swap(world.trace);
        return said;
    }

    Memory memory = {};
    Sequencer engine{table, kHost, memory};

private:
    bool trailing_;
};

}  // namespace flight
