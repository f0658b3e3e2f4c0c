// SPDX-License-Identifier: GPL-3.0-or-later
// Walks a mission by the rules of docs/mission.md: one NAV at a time, beside it its chain of
// CONDITIONs and actions. Knows the order of execution of both sets and none of the commands.
// Never waits: a record that is not there yet is asked for again at the next poll.
#pragma once
#include <stdint.h>

#include "core/status.hpp"
#include "mission/command_table.hpp"

namespace mission {

constexpr uint8_t kMaxItems = 176;
constexpr uint8_t kMaxCounters = 15;
constexpr uint8_t kRecordsPerPoll = 16;
constexpr uint8_t kRecordsBesideNav = 4;  // more in a poll, and the next one starts the NAV

enum class Event : uint8_t {
    started,   // index: the NAV that is flown from now on
    resumed,   // index: the NAV that is flown on
    reached,   // index: the NAV that finished
    waits,     // index: the CONDITION that begins
    waited,    // index: the CONDITION that ended
    runs,      // index: the action that is done now
    skipped,   // index: an unknown or impossible record was passed over
    looped,    // index: the jump at which a pass had taken all the steps it may
    hold,      // commands are left after the last NAV: circle its place meanwhile
    complete,  // no NAV is left
    landed,    // as complete, and the airplane stands on the ground
    reset,     // from the first: everything a mission changed in flight goes back
    lost,      // index: the record that cannot be read, for which the mission ends
};

// What the engine asks of its surroundings; lies in flash.
struct Host {
    core::Status (*read)(uint8_t index, uint8_t* to);  // 14 bytes; busy: ask again; else an error
    uint8_t (*count)();
    void (*event)(Event, uint8_t index);
    void (*here)(Record&);  // fills in the airplane's place
    bool (*enough)();       // true: the rest of the pass waits for the next poll
};

// Everything the engine remembers, in one struct with one reset. Plain bytes: it may lie in
// memory that a watchdog reset leaves alone, and the checksum shows whether it did.
struct Memory {
    // What is used most stands within the 64 bytes that an instruction of the chip reaches.
    uint16_t generation;
    uint16_t steps;  // taken in this pass
    int16_t loop_times;
    uint8_t loop, loop_to;  // APM 2.0: the jump that leads from the last NAVs to the NAV; 0: none
    uint8_t set;
    uint8_t phase;
    uint8_t flags;
    uint8_t nav;  // index of the NAV loaded; 0: none
    uint8_t nav_row;
    uint8_t condition;  // index of the CONDITION that runs; 0: none
    uint8_t condition_row;
    uint8_t cursor;  // where a NAV is sought
    uint8_t next;    // the next command of the chain
    uint8_t chain_first;
    Record nav_record, condition_record;
    union {
        struct {                          // APM 2.0
            uint16_t left[kMaxCounters];  // times
            uint8_t index[kMaxCounters];  // of the jump; 0: free
        } counters;
        struct {                                 // APM 1.0, a bit an item
            uint8_t visited[kMaxItems / 8];      // jumps taken in this pass
            struct {                             // since the NAV loaded
                uint8_t blocked[kMaxItems / 8];  // passed over until the next one loads
                uint8_t targets[kMaxItems / 8];  // jumped to
            } chain;
        } jumps;
    };
    uint16_t checksum;
};

class Sequencer {
public:
    constexpr Sequencer(const Table& table, const Host& host, Memory& memory)
        : table_(table), host_(host), memory_(memory) {}

    // After a reset. survived: memory may still hold what it held; it counts when its checksum and
    // the generation are right. Otherwise the mission begins at `index`, without the chain of that
    // NAV (0: at its beginning).
    void boot(Set set, uint16_t generation, bool survived, uint8_t index);

    void enter(bool restart);  // AUTO; resumes, or begins when there is nothing to resume
    void leave();
    // One pass, or the next part of one; trailing: MIS_TRAILING. Returns how many records it took.
    uint8_t poll(bool trailing);
    bool midPass() const { return memory_.phase == kSeeking || memory_.phase == kWalking; }
    bool active() const { return active_; }
    bool chosen() const { return has(kChosen); }  // the ground said where AUTO begins
    bool starved() const { return starved_; }     // the last poll ended at a record not there yet

    bool setCurrent(uint8_t index);  // 0: from the first; false: no such item
    uint8_t current() const;         // the NAV flown; before there is one, where AUTO will begin
    uint8_t next() const {           // the record it will probably ask for
        return memory_.phase == kSeeking ? memory_.cursor : memory_.next;
    }
    bool conditionRuns() const { return memory_.condition != 0; }
    bool ended() const;

    // Another mission has been committed; empty: it holds no NAV. same: what
    // inFlight() names has not changed.
    void changed(Set set, uint16_t generation, bool same, bool empty);

    // The records that must be equal in the old and the new mission for what is in flight to go
    // on: `nav`, the run from `first`, and those that nextRun() names. In the 1.0 set a run ends
    // before a NAV or behind the last record, in the 2.0 set the first one with the record `last`
    // (kToEnd: the last of all), another with `nav`.
    struct InFlight {
        uint8_t nav, first, last;
    };
    static constexpr uint8_t kToEnd = 0xFF;
    bool inFlight(InFlight& items) const;   // false: nothing is
    uint8_t nextRun(uint8_t behind) const;  // where one begins that a jump led to; 0: none

private:
    enum Phase : uint8_t { kFresh, kSeeking, kWalking, kFlying, kEnded };
    enum Flag : uint8_t {
        kStarted = 1,   // the NAV's begin() has been called
        kFromHere = 2,  // the next leg begins at the airplane
        kLanded = 4,
        kTrailing = 8,  // the chain has no NAV
        kChosen = 16,   // the ground said where AUTO begins
        kDropped = 32,  // the chain is not run
        kLoopReported = 64,
        kLoops = 128,  // the chain goes on at loop_to when it comes to `loop`
    };
    struct Item {
        Record record;
        uint8_t row;  // kNoRow: unknown or out of range
    };

    Set set() const { return static_cast<Set>(memory_.set); }
    static bool bit(const uint8_t* bits, uint8_t index) {
        return (bits[index / 8] >> (index % 8)) & 1;
    }
    bool has(Flag flag) const { return (memory_.flags & flag) != 0; }
    void put(uint8_t flags, bool on) { on ? mark(flags) : clear(flags); }
    void mark(uint8_t flags) { memory_.flags = static_cast<uint8_t>(memory_.flags | flags); }
    void clear(uint8_t flags) { memory_.flags = static_cast<uint8_t>(memory_.flags & ~flags); }
    uint8_t count() const { return core::romRead(host_.count)(); }
    void reportEvent(Event event, uint8_t index) { core::romRead(host_.event)(event, index); }
    bool read(uint8_t index, bool seeks, Item& item);
    bool wentRound() const { return memory_.steps >= 2u * count(); }

    void reset(uint8_t phase);
    void beginAt(uint8_t index);
    void seekFrom(uint8_t chain_first, uint8_t cursor);
    void beginPass();
    void resume();
    bool lookAround();
    void finishNav();
    bool seek();
    void noticeJump(uint8_t index, const Item& item);
    void load(uint8_t index, const Item& item);
    void noNavLeft();
    bool walk();
    bool roomForNav() const;
    void endOfChain();
    void startNav();
    void startCondition(const Item& item);
    void wait();
    void act(const Item& item);
    void takeJump(const Item& item);
    bool jumpApm1(uint8_t index, const Jump& jump);
    bool jumpApm2(uint8_t index, const Jump& jump);
    bool countDown(uint8_t index, int16_t times, uint8_t by);
    void abandon(uint8_t target);
    void complete();
    void refill();
    void updateChecksum();
    uint16_t sum() const;

    const Table& table_;
    const Host& host_;
    Memory& memory_;
    bool active_ = false;
    bool resuming_ = false;
    bool trailing_ = false;
    bool starved_ = false;
    uint8_t polled_ = 0;  // records of this poll
};

}  // namespace mission
