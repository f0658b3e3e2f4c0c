// SPDX-License-Identifier: GPL-3.0-or-later
// One pass of the engine: what has finished, what comes next. sequencer.cpp has the rest.
#include <string.h>

#include "mission/sequencer.hpp"
#include "storage/bytes.hpp"

namespace mission {
namespace {

using core::Status;

void setBit(uint8_t* bits, uint8_t index) {
    bits[index / 8] = static_cast<uint8_t>(bits[index / 8] | (1u << (index % 8)));
}

}  // namespace

uint8_t Sequencer::poll(bool trailing) {
    if (!active_) return 0;
    trailing_ = trailing;
    starved_ = false;
    clear(kChosen);
    if (resuming_) {
        resume();
        if (memory_.phase == kFlying) return 0;
    } else if (memory_.phase == kFlying && !lookAround()) {
        return 0;
    }
    polled_ = 0;
    while (polled_ < kRecordsPerPoll && active_ && midPass()) {
        ++polled_;
        if (!(memory_.phase == kSeeking ? seek() : walk())) break;
        if (core::romRead(host_.enough)()) break;
    }
    updateChecksum();
    return polled_;
}

// The NAV first, then the CONDITION beside it. True when one of them has finished.
bool Sequencer::lookAround() {
    if (!has(kTrailing) && table_.check(memory_.nav_row)(memory_.nav_record) == Progress::done) {
        finishNav();
        return true;
    }
    if (memory_.condition == 0) return false;
    if (table_.check(memory_.condition_row)(memory_.condition_record) != Progress::done)
        return false;
    reportEvent(Event::waited, memory_.condition);
    memory_.condition = 0;
    beginPass();
    memory_.phase = kWalking;
    return true;
}

void Sequencer::finishNav() {
    static_assert(
        uint8_t{kFromHere} == uint8_t{kEndsNowhere} && uint8_t{kLanded} == uint8_t{kEndsFlight},
        "what the NAV leaves behind is a flag of its own");
    clear(kFromHere | kLanded | kDropped | kStarted);
    mark(table_.traits(memory_.nav_row) & (kEndsNowhere | kEndsFlight));
    const uint8_t behind = static_cast<uint8_t>(memory_.nav + 1);
    seekFrom(behind, set() == Set::apm1 ? memory_.next : behind);
    beginPass();
    reportEvent(Event::reached, memory_.nav);
}

// False: not there yet, or never again. An action that is not run is not looked into: a range may
// be a parameter's, which must be sought.
bool Sequencer::read(uint8_t index, bool seeks, Item& item) {
    uint8_t bytes[kRecordSize];
    const Status status = core::romRead(host_.read)(index, bytes);
    starved_ = status == Status::busy;
    if (starved_) return false;
    if (status != Status::ok) {
        reportEvent(Event::lost, index);
        complete();
        return false;
    }
    item.record = unpack(set(), bytes);
    item.row = table_.find(set(), item.record.id);
    if (item.row == kNoRow) return true;
    const Class kind = table_.kind(item.row);
    const bool used = !seeks || kind == Class::nav || kind == Class::jump;
    if (used && table_.valid(item.row, item.record, {index, count()}) != 0) item.row = kNoRow;
    return true;
}

// One record towards the next NAV. False: not now.
bool Sequencer::seek() {
    if (memory_.cursor >= count()) {
        noNavLeft();
        return true;
    }
    Item item;
    if (!read(memory_.cursor, true, item)) return false;
    const uint8_t index = memory_.cursor++;
    ++memory_.steps;
    if (item.row == kNoRow) return true;
    const Class kind = table_.kind(item.row);
    if (kind == Class::nav) load(index, item);
    if (kind == Class::jump) noticeJump(index, item);
    return true;
}

// Where no NAV follows, the first jump with count left leads on to one, if there is one.
void Sequencer::noticeJump(uint8_t index, const Item& item) {
    if (set() == Set::apm1 || memory_.loop != 0) return;
    const Jump jump = table_.target(item.row)(item.record);
    if (!countDown(index, jump.times, 0)) return;
    memory_.loop = index;
    memory_.loop_to = jump.target;
    memory_.loop_times = jump.times;
}

void Sequencer::load(uint8_t index, const Item& item) {
    const uint8_t traits = table_.traits(item.row);
    if (has(kLanded) && (traits & kBeginsFlight) == 0) return complete();
    if (has(kLoops))
        (void)countDown(memory_.loop, memory_.loop_times, 1);
    else
        memory_.loop = 0;
    memory_.nav = index;
    memory_.nav_row = item.row;
    memory_.nav_record = item.record;
    if ((traits & kPlaced) != 0 && item.record.p3 == 0 && item.record.p4 == 0)
        core::romRead(host_.here)(memory_.nav_record);
    const bool apm1 = set() == Set::apm1;
    if (apm1) {
        memory_.chain_first = static_cast<uint8_t>(index + 1);
        memset(&memory_.jumps.chain, 0, sizeof memory_.jumps.chain);
    }
    memory_.next = memory_.chain_first;
    memory_.phase = kWalking;
    if (apm1) startNav();  // no jump of this set abandons it
}

void Sequencer::noNavLeft() {
    if (memory_.loop != 0 && !has(kLoops)) {
        mark(kLoops);
        memory_.cursor = memory_.loop_to;
        return;
    }
    clear(kLoops);
    memory_.loop = 0;
    const bool commands_left = set() == Set::apm2 && memory_.chain_first < count();
    if (!trailing_ || !commands_left || has(kLanded)) return complete();
    mark(kTrailing);
    memory_.next = memory_.chain_first;
    memory_.phase = kWalking;
    reportEvent(Event::hold, memory_.nav);
}

void Sequencer::complete() {
    const Event event = has(kLanded) ? Event::landed : Event::complete;
    const uint8_t last = memory_.nav;
    reset(kEnded);
    put(kLanded, event == Event::landed);
    updateChecksum();
    reportEvent(event, last);
}

// One command of the chain. False: not now, or the pass is over.
bool Sequencer::walk() {
    const bool to_nav = set() == Set::apm2 && !has(kTrailing) && !has(kLoops);
    const uint8_t end = to_nav ? memory_.nav : count();
    if (has(kDropped) || memory_.next >= end) {
        if (roomForNav()) endOfChain();
        return false;
    }
    Item item;
    if (!read(memory_.next, false, item)) return false;
    const bool known = item.row != kNoRow;
    const Class kind = known ? table_.kind(item.row) : Class::action;
    if (kind == Class::nav) {  // APM 1.0: it waits for the one being flown
        endOfChain();
        return false;
    }
    if (kind == Class::jump) {
        takeJump(item);
    } else if (kind == Class::condition) {
        if (!roomForNav()) return false;
        startCondition(item);
    } else {
        act(item);
    }
    return memory_.phase != kFlying;
}

// Starting a NAV takes as long as many records: behind those it waits for the next poll.
bool Sequencer::roomForNav() const { return has(kStarted) || polled_ <= kRecordsBesideNav; }

void Sequencer::endOfChain() {
    if (has(kTrailing)) return complete();
    startNav();
    memory_.phase = kFlying;
}

// APM 2.0: only when it is certain that no jump abandons the NAV in the pass that loaded it.
void Sequencer::startNav() {
    if (has(kStarted) || has(kTrailing)) return;
    mark(kStarted);
    clear(kLanded);
    table_.begin(memory_.nav_row)(memory_.nav_record, {false, has(kFromHere)});
    reportEvent(Event::started, memory_.nav);
}

void Sequencer::startCondition(const Item& item) {
    startNav();
    memory_.condition = memory_.next++;
    memory_.condition_row = item.row;
    memory_.condition_record = item.record;
    memory_.phase = kFlying;
    wait();
}

void Sequencer::wait() {
    reportEvent(Event::waits, memory_.condition);
    table_.act(memory_.condition_row)(memory_.condition_record);
}

// The step counts as taken before the handler runs: a handler may change the mode and so stop
// the engine in the middle of its pass.
void Sequencer::act(const Item& item) {
    const uint8_t index = memory_.next++;
    ++memory_.steps;
    if (item.row == kNoRow) return reportEvent(Event::skipped, index);
    reportEvent(Event::runs, index);
    table_.act(item.row)(item.record);
}

void Sequencer::takeJump(const Item& item) {
    const uint8_t index = memory_.next;
    if (has(kLoops) && index == memory_.loop) {
        clear(kLoops);
        memory_.next = memory_.loop_to;
        return;
    }
    if (wentRound()) {
        if (!has(kLoopReported)) reportEvent(Event::looped, index);
        mark(kLoopReported);
        ++memory_.next;
        return;
    }
    ++memory_.steps;
    const Jump jump = table_.target(item.row)(item.record);
    const bool taken = set() == Set::apm1 ? jumpApm1(index, jump) : jumpApm2(index, jump);
    if (!taken) ++memory_.next;
}

// The NAV being flown goes on; only the place from where commands are taken changes.
bool Sequencer::jumpApm1(uint8_t index, const Jump& jump) {
    if (index >= kMaxItems || bit(memory_.jumps.chain.blocked, index)) return false;
    if (bit(memory_.jumps.visited, index)) {
        setBit(memory_.jumps.chain.blocked, index);
        return false;
    }
    setBit(memory_.jumps.visited, index);
    setBit(memory_.jumps.chain.targets, jump.target);
    memory_.next = memory_.chain_first = jump.target;
    return true;
}

bool Sequencer::jumpApm2(uint8_t index, const Jump& jump) {
    if (!countDown(index, jump.times, 1)) return false;
    abandon(jump.target);
    return true;
}

// False: nothing is left of its count. by: 0 to look, 1 to take it.
bool Sequencer::countDown(uint8_t index, int16_t times, uint8_t by) {
    if (times == kForEver) return true;
    auto& counters = memory_.counters;
    for (uint8_t i = 0; i < kMaxCounters; ++i) {
        if (counters.index[i] == 0) {
            counters.index[i] = index;
            counters.left[i] = static_cast<uint16_t>(times);
        }
        if (counters.index[i] != index) continue;
        if (counters.left[i] == 0) return false;
        counters.left[i] = static_cast<uint16_t>(counters.left[i] - by);
        return true;
    }
    reportEvent(Event::skipped,
                index);  // more counted jumps than an upload would have let through
    return false;
}

void Sequencer::abandon(uint8_t target) {
    if (has(kStarted)) mark(kFromHere);
    clear(kStarted | kTrailing);
    seekFrom(target, target);
}

}  // namespace mission
