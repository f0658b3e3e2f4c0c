// SPDX-License-Identifier: GPL-3.0-or-later
#include "mission/sequencer.hpp"

#include <string.h>

#include "core/crc.hpp"

namespace mission {

uint8_t Sequencer::current() const {
    const bool ahead = memory_.phase == kSeeking && (has(kChosen) || memory_.nav == 0);
    return ahead ? memory_.cursor : memory_.nav;
}

bool Sequencer::ended() const { return memory_.phase == kEnded; }

uint16_t Sequencer::sum() const {
    // the host pads the struct; memset at every reset keeps the padding still
    return core::crc16(core::kCrcStart, &memory_, offsetof(Memory, checksum));
}
void Sequencer::updateChecksum() { memory_.checksum = sum(); }

void Sequencer::boot(Set set, uint16_t generation, bool survived, uint8_t index) {
    active_ = resuming_ = false;
    if (survived && memory_.checksum == sum() && memory_.generation == generation &&
        memory_.set == static_cast<uint8_t>(set))
        return;
    memset(&memory_, 0, sizeof memory_);
    memory_.set = static_cast<uint8_t>(set);
    memory_.generation = generation;
    reset(kFresh);
    if (index != 0) {
        beginAt(index);
        mark(kDropped);
    }
    updateChecksum();
}

void Sequencer::reset(uint8_t phase) {
    const uint8_t set = memory_.set;
    const uint16_t generation = memory_.generation;
    memset(&memory_, 0, sizeof memory_);
    memory_.set = set;
    memory_.generation = generation;
    memory_.phase = phase;
    memory_.flags = kFromHere;  // nothing has finished yet
}

// After a reset, as a jump of the APM 2.0 set would go: the first NAV at or after `index`.
void Sequencer::beginAt(uint8_t index) {
    memory_.nav = 0;
    seekFrom(index, index);
}

void Sequencer::seekFrom(uint8_t chain_first, uint8_t cursor) {
    memory_.condition = memory_.loop = 0;
    clear(kLoops);
    memory_.chain_first = chain_first;
    memory_.cursor = cursor;
    memory_.phase = kSeeking;
}

void Sequencer::beginPass() {
    memory_.steps = 0;
    clear(kLoopReported);
    if (set() == Set::apm1) memset(memory_.jumps.visited, 0, sizeof memory_.jumps.visited);
}

void Sequencer::enter(bool restart) {
    if (active_) return;
    active_ = true;
    const bool nothing_to_resume = memory_.phase == kFresh || memory_.phase == kEnded;
    if (nothing_to_resume || (restart && !has(kChosen))) {
        reset(kFresh);
        reportEvent(Event::reset, 0);
        beginAt(1);
    } else {
        if (restart) {
            refill();
            reportEvent(Event::reset, 0);
        }
        mark(kFromHere);
        beginPass();
        resuming_ = true;
    }
    updateChecksum();
}

void Sequencer::leave() { active_ = false; }

void Sequencer::resume() {
    resuming_ = false;
    if (has(kTrailing)) {
        reportEvent(Event::hold, memory_.nav);
    } else if (has(kStarted)) {
        reportEvent(Event::resumed, memory_.nav);
        table_.begin(memory_.nav_row)(memory_.nav_record, {true, true});
    }
    if (memory_.condition != 0) wait();
}

bool Sequencer::setCurrent(uint8_t index) {
    if (index >= count()) return false;
    if (index == 0) {
        reset(kFresh);
        reportEvent(Event::reset, 0);
        if (active_) beginAt(1);
    } else {
        if (memory_.phase == kEnded) reset(kFresh);
        clear(kLanded | kDropped);
        put(kChosen, !active_);
        abandon(index);
        beginPass();
    }
    resuming_ = false;
    updateChecksum();
    return true;
}

void Sequencer::changed(Set set, uint16_t generation, bool same, bool empty) {
    memory_.generation = generation;
    if (same && !empty) {
        refill();
        return updateChecksum();
    }
    memory_.set = static_cast<uint8_t>(set);
    const uint8_t flags = memory_.flags;
    reset(kFresh);
    resuming_ = false;
    reportEvent(Event::reset, 0);
    if (active_ && empty) {
        put(kLanded, (flags & kLanded) != 0);
        return complete();
    }
    if (active_) beginAt(1);
    updateChecksum();
}

void Sequencer::refill() {
    if (set() == Set::apm2) memset(&memory_.counters, 0, sizeof memory_.counters);
}

bool Sequencer::inFlight(InFlight& items) const {
    if (memory_.phase != kWalking && memory_.phase != kFlying) return false;
    items.nav = memory_.nav;
    items.first = set() == Set::apm1 ? static_cast<uint8_t>(memory_.nav + 1) : memory_.chain_first;
    items.last = has(kTrailing) ? kToEnd : memory_.loop != 0 ? memory_.loop : memory_.nav;
    return true;
}

uint8_t Sequencer::nextRun(uint8_t behind) const {
    if (set() == Set::apm2) return memory_.loop != 0 && behind == 0 ? memory_.loop_to : 0;
    while (++behind < kMaxItems)
        if (bit(memory_.jumps.chain.targets, behind)) return behind;
    return 0;
}

}  // namespace mission
