// SPDX-License-Identifier: GPL-3.0-or-later
#include "rig.hpp"

#include <string.h>

#include <algorithm>
#include <stdexcept>

namespace oracle {
namespace {

using mission::Class;
using mission::Progress;
using mission::Record;

struct {
    const Mission* stored;
    mission::Sequencer* engine;
    std::string trace;
    std::string broken;
    bool nav_done, condition_done;
    uint32_t chance = 1;
    uint32_t busy;  // the seed; 0: never
    int asked, read, here, begun;
    const mission::Memory* memory;
    mission::Memory at_read;  // as it was when a record was read last
} world;

void say(const std::string& word) { world.trace += (world.trace.empty() ? "" : " ") + word; }
int indexOf(const Record& record) { return record.p2 & 0xFF; }
std::string name(const Record& record) { return std::to_string(indexOf(record)); }
std::string tuple(const Record& r) {
    return "(" + std::to_string(r.p1) + "," + std::to_string(r.p2) + "," + std::to_string(r.p3) +
           "," + std::to_string(r.p4) + ")";
}

// ---- the commands
uint8_t inRange(const Record& record, mission::ItemPosition) {
    return record.p1 == kOutOfRange ? 5 : 0;
}
void begin(const Record& record, mission::LegStart entry) {
    const char* how = entry.resumed ? "~" : entry.from_here ? "!" : "";
    say("W" + name(record) + how + tuple(record));
    world.begun = indexOf(record);
}
Progress consume(bool& done) {
    const Progress progress = done ? Progress::done : Progress::running;
    done = false;
    return progress;
}
Progress navDone(const Record&) {
    if (world.nav_done) world.condition_done = false;  // cancelled
    return consume(world.nav_done);
}
Progress waited(const Record&) {
    if (world.condition_done) world.nav_done = false;  // of one pass
    return consume(world.condition_done);
}
void wait(const Record& record) { say("c" + name(record) + tuple(record)); }
void act(const Record& record) {
    say("a" + name(record) + tuple(record));
    if (record.p1 == kLeavesAuto) world.engine->leave();
}
uint8_t jumpInRange(const Record& record, mission::ItemPosition position) {
    const bool times = record.p3 == -1 || (record.p3 >= 1 && record.p3 <= 32767);
    const bool target = record.p1 != 0 && record.p1 < position.count && record.p1 != position.index;
    return times && target ? 0 : 5;
}
mission::Jump jumpOf(const Record& record) { return {record.p1, static_cast<int16_t>(record.p3)}; }
uint8_t always(const Record&, mission::ItemPosition) { return 0; }
mission::Jump toFirst(const Record&) { return {1, mission::kForEver}; }
int32_t indexTarget(const Record& record) { return record.p2 != 0 ? record.p2 : record.p1; }
uint8_t indexInRange(const Record& record, mission::ItemPosition position) {
    return indexTarget(record) >= 1 && indexTarget(record) < position.count ? 0 : 5;
}
mission::Jump toIndex(const Record& record) {
    return {static_cast<uint8_t>(indexTarget(record)), mission::kForEver};
}

std::vector<mission::Row> makeRows() {
    constexpr uint8_t kNone = mission::kNoId;
    std::vector<mission::Row> rows;
    const auto range = [&](int first, int last, auto add) {
        for (int id = first; id <= last; ++id) add(static_cast<uint8_t>(id));
    };
    const auto addNav = [&](uint8_t id) {
        const uint8_t traits = id == 0x1E   ? mission::kEndsNowhere
                               : id == 0x15 ? mission::kPlaced | mission::kEndsFlight
                               : id == 0x16 ? mission::kEndsNowhere | mission::kBeginsFlight
                               : id == 0x14 ? 0
                                            : mission::kPlaced;
        rows.push_back(
            mission::nav(id >= 0x17 ? kNone : id, id, 0, inRange, begin, navDone, traits));
    };
    range(0x10, 0x17, addNav);
    range(0x1E, 0x1F, addNav);
    const auto condition1 = [&](uint8_t id) {
        rows.push_back(mission::condition(id, kNone, 0, inRange, wait, waited));
    };
    const auto condition2 = [&](uint8_t id) {
        rows.push_back(mission::condition(kNone, id, 0, inRange, wait, waited));
    };
    const auto action1 = [&](uint8_t id) {
        rows.push_back(mission::action(id, kNone, 0, inRange, act));
    };
    const auto action2 = [&](uint8_t id) {
        rows.push_back(mission::action(kNone, id, 0, inRange, act));
    };
    range(0x20, 0x21, condition1);
    range(0x70, 0x73, condition2);
    for (const auto& ids : {std::pair<int, int>{0x30, 0x30},
                            {0x32, 0x34},
                            {0x40, 0x42},
                            {0x60, 0x64},
                            {0x70, 0x73},
                            {0x80, 0x82}})
        range(ids.first, ids.second, action1);
    range(0xB2, 0xB8, action2);
    for (const uint8_t id : {0x5D, 0xBD, 0xBF, 0xC3, 0xC5, 0xC9, 0xCB, 0xCD, 0xCE, 0xCF, 0xD2, 0xD4,
                             0xF0, 0xF1, 0xF2, 0xD6, 0xF3, 0xF4, 0xF5})
        action2(id);
    rows.push_back(mission::jump(kNone, 0xB1, 0, jumpInRange, jumpOf));
    rows.push_back(mission::jump(0x31, kNone, 0, always, toFirst));
    rows.push_back(mission::jump(0x75, kNone, 0, indexInRange, toIndex));
    return rows;
}
const std::vector<mission::Row> kRows = makeRows();
const mission::Table kTable = {kRows.data(), static_cast<uint8_t>(kRows.size())};

// ---- the surroundings
core::Status readStored(uint8_t index, uint8_t* to) {
    ++world.asked;
    if (world.busy != 0) {
        world.busy = world.busy * 1664525u + 1013904223u;
        if ((world.busy >> 16) % 3 == 0) return core::Status::busy;
    }
    if (index >= world.stored->size()) {
        world.broken = "read beyond the last";
        return core::Status::busy;
    }
    ++world.read;
    world.at_read = *world.memory;
    const Bytes& bytes = (*world.stored)[index];
    std::copy(bytes.begin(), bytes.end(), to);
    return core::Status::ok;
}
uint8_t countStored() { return static_cast<uint8_t>(world.stored->size()); }
void reportEvent(mission::Event event, uint8_t index) {
    const std::string i = std::to_string(index);
    switch (event) {
        case mission::Event::started:
            if (index != world.begun) world.broken = "started without begin";
            break;
        case mission::Event::reached:
            say("+" + i);
            break;
        case mission::Event::skipped:
            say("?" + i);
            break;
        case mission::Event::looped:
            say("loop" + i);
            break;
        case mission::Event::hold:
            say("hold");
            break;
        case mission::Event::complete:  // the mode becomes RTL
            say("RTL");
            world.engine->leave();
            break;
        case mission::Event::landed:
            say("landed");
            break;
        case mission::Event::reset:
            say("reset");
            break;
        case mission::Event::lost:
            say("lost" + i);
            break;
        default:
            break;
    }
}
void whereItIs(Record& record) { record.p3 = world.here; }
// Where a pass is divided must not be seen.
bool nowAndThen() {
    world.chance = world.chance * 1664525u + 1013904223u;
    return (world.chance >> 16) % 5 == 0;
}
constexpr mission::Host kHost = {readStored, countStored, reportEvent, whereItIs, nowAndThen};

mission::Set engineSet(CommandSet set) {
    return set == CommandSet::apm1 ? mission::Set::apm1 : mission::Set::apm2;
}
// A NAV by the engine's own table; one that it would skip is none.
bool isNav(CommandSet set, const Mission& mission, size_t i) {
    const uint8_t* bytes = mission[i].data();
    const uint8_t row = kTable.find(engineSet(set), bytes[0]);
    if (row == mission::kNoRow || kTable.kind(row) != Class::nav) return false;
    const mission::ItemPosition position = {static_cast<uint8_t>(i),
                                            static_cast<uint8_t>(mission.size())};
    return kTable.valid(row, mission::unpack(engineSet(set), bytes), position) == 0;
}

}  // namespace

Rig::Rig(CommandSet set, const Mission& mission)
    : set_(set), mission_(mission), engine_(kTable, kHost, memory_) {
    world = {};
    world.stored = &mission_;
    world.engine = &engine_;
    boot(false, 0);
}

void Rig::boot(bool survived, uint8_t index) {
    engine_.boot(engineSet(set_), generation_, survived, index);
}
void Rig::watchdog() {
    engine_.leave();
    boot(true, 0);
}
void Rig::loseMemory(int index) {
    engine_.leave();
    boot(false, static_cast<uint8_t>(index));
}
void Rig::airplaneAt(int place) { world.here = place; }
void Rig::enterAuto(bool restart) { engine_.enter(restart); }

Rig::Passed Rig::pass(const Pass& how) {
    world.nav_done = how.nav;
    world.condition_done = how.condition;
    world.busy = how.busy;
    world.read = 0;
    world.memory = &memory_;
    Passed passed;
    int late = 0;
    for (int polls = 0; polls <= 5000; ++polls) {
        const mission::Memory before = memory_;
        world.asked = 0;
        const int read_before = world.read;
        engine_.poll(mis_trailing_);
        if (world.asked > mission::kRecordsPerPoll) world.broken = "too many records in a poll";
        if (polls == 5000) world.broken = "a pass without end";
        if (late == 0) world.nav_done = world.condition_done = false;
        const bool starved = engine_.active() && engine_.starved();
        // what there was no room for in this poll will be read again
        const bool unused =
            world.read != read_before && !starved &&
            memcmp(&world.at_read, &memory_, offsetof(mission::Memory, checksum)) == 0;
        if (unused) --world.read;
        if (!starved && memcmp(&before, &memory_, sizeof before) == 0) break;
        if (!starved) continue;
        if (++late == how.cut) {
            passed.records = world.read;
            break;
        }
        if (late > 1 || how.cut != 0) continue;
        passed.late_nav = world.nav_done = how.late_nav;
        passed.late_condition = world.condition_done = how.late_condition;
    }
    world.nav_done = world.condition_done = false;
    world.busy = 0;
    return passed;
}

// As whoever commits a mission finds out: record by record over the runs the engine names.
bool Rig::sameInFlight(CommandSet set, const Mission& before, const Mission& now) const {
    mission::Sequencer::InFlight items;
    if (!engine_.active() || set != set_ || !engine_.inFlight(items)) return false;
    const auto at = [](const Mission& mission, size_t i) {
        return i < mission.size() ? &mission[i] : nullptr;
    };
    const auto equal = [&](size_t i) {
        const Bytes *one = at(before, i), *other = at(now, i);
        return one != nullptr && other != nullptr && *one == *other;
    };
    if (items.nav != 0 && !equal(items.nav)) return false;
    const auto sameRun = [&](size_t i, size_t last) {
        for (;; ++i) {
            const bool ends = i >= now.size() || (set == CommandSet::apm1 && isNav(set, now, i));
            const bool ended =
                i >= before.size() || (set == CommandSet::apm1 && isNav(set, before, i));
            if (ends || ended) return ends && ended;
            if (!equal(i)) return false;
            if (set == CommandSet::apm2 && i == last) return true;
        }
    };
    bool same = sameRun(items.first, items.last);
    for (uint8_t run = 0; same && (run = engine_.nextRun(run)) != 0;)
        same = sameRun(run, items.nav);
    return same;
}

void Rig::commit(CommandSet set, const Mission& mission) {
    const bool same = sameInFlight(set, mission_, mission);
    set_ = set;
    mission_ = mission;
    bool empty = true;
    for (size_t i = 1; i < mission_.size(); ++i)
        if (isNav(set, mission_, i)) empty = false;
    engine_.changed(engineSet(set), ++generation_, same, empty);
}

std::string Rig::trace() {
    std::string said;
    said.swap(world.trace);
    return said;
}

std::map<int, int> Rig::jumpsLeft() const {
    std::map<int, int> left;
    if (set_ == CommandSet::apm1) return left;
    const auto& counters = memory_.counters;
    for (int i = 0; i < mission::kMaxCounters; ++i)
        if (counters.index[i] != 0) left[counters.index[i]] = counters.left[i];
    for (auto counter = left.begin(); counter != left.end();) {  // none of it taken: looked at
        const Bytes& jump = mission_[static_cast<size_t>(counter->first)];
        const bool whole = counter->second == jump[6] + (jump[7] << 8);
        counter = whole ? left.erase(counter) : std::next(counter);
    }
    return left;
}

int Rig::reads() const { return world.read; }
std::string Rig::broken() const { return world.broken; }

}  // namespace oracle
