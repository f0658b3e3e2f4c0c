// SPDX-License-Identifier: GPL-3.0-or-later
// How long a mission can hold up its next NAV: the longest pass of sequencer.hpp, computed without
// running it. A part each call, in a table of two bits an item: a board does this at every upload.
//
// Why it ends and is exact. The commands of a pass are a walk: from a record to the next, from a
// jump that is taken to its target; a NAV or a CONDITION ends it. Where no jump can be come to
// twice without one of these between, a walk goes through each jump once at most, so it is no
// longer than the mission, and whether a jump with a count is taken or passed over depends on no
// other jump: all walks are those with each of these chosen both ways. Any other mission has jumps
// that go round, and is refused.
#pragma once
#include <stdint.h>

#include "mission/command_table.hpp"
#include "mission/sequencer.hpp"

namespace mission {

class LongestPass {
public:
    // Of a poll, of which there are twenty in a second: 16 records can be looked at in one, or
    // seven actions run that are quickly done, such as a relay's (on_board.costs).
    static constexpr uint8_t kPoll = 112, kLook = kPoll / kRecordsPerPoll, kRun = kPoll / 7;
    static constexpr uint16_t kLimit = 30 * kPoll;  // 1.5 s
    static constexpr uint8_t kMaxJumps = 32;

    enum class Verdict : uint8_t {
        busy,
        fine,
        goes_round,  // item(): a jump that is come to again with neither NAV nor CONDITION between
        too_long,    // item(): where the pass begins
        too_many,    // item(): a jump more than kMaxJumps, or where a pass begins that needs more
                     // steps than the engine takes, or more ways through jumps than are tried
    };

    void begin(Set set);
    void add(uint8_t index, Class kind, Jump jump);  // from item 1 on; jump: where it is one
    // Some records each call. After busy: the items 1 to count - 1 have been added.
    Verdict step(uint8_t count);
    uint8_t item() const { return item_; }
    uint16_t longest() const { return longest_; }  // so far, of a poll; `fine`: of all

private:
    static constexpr uint8_t kStepsPerCall = 48;
    static constexpr uint16_t kSteps = 8000;  // more, and it is given up

    Class kind(uint8_t index) const {
        return static_cast<Class>(kinds_[index / 4] >> (index % 4 * 2) & 3);
    }
    bool passBegins() const;
    uint8_t nav(uint8_t from) const;
    void look(uint8_t records);
    void seek(uint8_t from);
    void beginWalk();
    Verdict walk();
    Verdict walkJump();
    void loopAt(uint8_t jump, uint8_t target);
    bool isTaken(uint8_t jump);
    bool nextChoice();

    Set set_;
    uint8_t kinds_[kMaxItems / 4];
    struct {
        uint8_t index, target;
    } jumps_[kMaxJumps];
    uint32_t counted_;  // of the jumps, a bit each
    uint8_t jump_count_, count_;
    uint8_t item_;
    uint8_t begin_;            // of the passes that are looked at now
    uint8_t at_, end_;         // of the walk
    uint8_t loop_, loop_end_;  // the jump that leads on from behind the last NAV, and its NAV
    uint8_t come_to_;          // jumps, in this walk
    uint8_t choices_;          // jumps with a count among them
    uint16_t choice_;  // which of those are passed over: a bit each, the first one the highest
    uint16_t looks_;   // records of the pass, as the engine counts its steps
    uint16_t cost_, longest_;
    uint16_t steps_;  // taken here
    bool walks_;
    bool too_many_;  // jumps in this walk
};

}  // namespace mission
