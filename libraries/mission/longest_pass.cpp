// SPDX-License-Identifier: GPL-3.0-or-later
#include "mission/longest_pass.hpp"

namespace mission {

void LongestPass::begin(Set set) {
    *this = LongestPass();
    set_ = set;
}

void LongestPass::add(uint8_t index, Class kind, Jump jump) {
    const uint8_t bits = static_cast<uint8_t>(static_cast<uint8_t>(kind) << (index % 4 * 2));
    kinds_[index / 4] = static_cast<uint8_t>(kinds_[index / 4] | bits);
    if (kind != Class::jump || jump_count_ > kMaxJumps) return;
    if (jump_count_ == kMaxJumps) {
        item_ = index;
    } else {
        jumps_[jump_count_] = {index, jump.target};
        if (set_ == Set::apm2 && jump.times != kForEver) counted_ |= uint32_t{1} << jump_count_;
    }
    ++jump_count_;
}

// A pass from a record between two such is the last part of one from the first of them.
bool LongestPass::passBegins() const {
    if (begin_ == 1) return true;
    const Class before = kind(static_cast<uint8_t>(begin_ - 1));
    return before != Class::action && (before != Class::jump || set_ == Set::apm2);
}

uint8_t LongestPass::nav(uint8_t from) const {
    while (from < count_ && kind(from) != Class::nav) ++from;
    return from;
}

void LongestPass::look(uint8_t records) {
    looks_ = static_cast<uint16_t>(looks_ + records);
    if (cost_ <= kLimit) cost_ = static_cast<uint16_t>(cost_ + records * kLook);
    steps_ = static_cast<uint16_t>(steps_ + records / 4);
}

// To the next NAV; without one to the end, and then where the first jump with count left leads.
void LongestPass::seek(uint8_t from) {
    at_ = from;
    end_ = nav(from);
    look(static_cast<uint8_t>(end_ - from + (end_ < count_)));
    loop_ = 0;
    if (set_ == Set::apm1 || end_ < count_) return;
    for (uint8_t i = 0; loop_ == 0 && i < jump_count_; ++i)
        if (jumps_[i].index >= from && isTaken(i)) loopAt(jumps_[i].index, jumps_[i].target);
}

void LongestPass::loopAt(uint8_t jump, uint8_t target) {
    loop_ = jump;
    loop_end_ = nav(target);
    look(static_cast<uint8_t>(loop_end_ - target + (loop_end_ < count_)));
}

void LongestPass::beginWalk() {
    walks_ = true;
    looks_ = cost_ = 0;
    too_many_ = false;
    come_to_ = choices_ = 0;
    const bool seeks = set_ == Set::apm2 || begin_ == 1 ||
                       kind(static_cast<uint8_t>(begin_ - 1)) != Class::condition;
    at_ = begin_;
    if (seeks) seek(begin_);
    if (set_ == Set::apm2) return;
    if (seeks) at_ = static_cast<uint8_t>(end_ + 1);
    end_ = count_;
}

// One record of the chain. fine: the pass is over.
LongestPass::Verdict LongestPass::walk() {
    if (at_ >= end_) return Verdict::fine;
    const Class is = kind(at_);
    if (is == Class::jump) return walkJump();
    look(1);
    if (is != Class::action) return Verdict::fine;
    if (cost_ <= kLimit) cost_ = static_cast<uint16_t>(cost_ + kRun - kLook);
    ++at_;
    return Verdict::busy;
}

LongestPass::Verdict LongestPass::walkJump() {
    item_ = at_;
    if (++come_to_ > jump_count_) return Verdict::goes_round;
    uint8_t jump = 0;
    while (jumps_[jump].index != at_) ++jump;
    const uint8_t target = jumps_[jump].target;
    const bool apm2 = set_ == Set::apm2, behind_last = apm2 && end_ == count_;
    const bool taken = behind_last ? at_ == loop_ : isTaken(jump);
    const bool to_nav = taken && behind_last && loop_end_ < count_;
    if (looks_ >= 2u * count_ && !to_nav) too_many_ = true;  // the engine would pass it over
    look(1);
    ++at_;
    if (to_nav) end_ = loop_end_;
    if (taken && apm2 && !to_nav) seek(target);
    if (taken) at_ = target;
    return Verdict::busy;
}

// In this walk; of a jump with a count it is chosen.
bool LongestPass::isTaken(uint8_t jump) {
    if ((counted_ >> jump & 1) == 0 || choices_ == kMaxCounters) return true;
    const bool taken = (choice_ >> (kMaxCounters - choices_) & 1) == 0;
    ++choices_;
    return taken;
}

// Another one in place of the last choice that was not yet made both ways.
bool LongestPass::nextChoice() {
    const uint8_t unused = static_cast<uint8_t>(kMaxCounters + 1 - choices_);
    const uint16_t next = choices_ == 0 ? 0 : static_cast<uint16_t>((choice_ >> unused) + 1);
    choice_ = static_cast<uint16_t>(next << unused);
    return choice_ != 0;
}

LongestPass::Verdict LongestPass::step(uint8_t count) {
    if (jump_count_ > kMaxJumps) return Verdict::too_many;
    if (begin_ >= count) return Verdict::fine;
    count_ = count;
    for (uint8_t left = kStepsPerCall; left > 0; --left) {
        if (!walks_) {
            do ++begin_;
            while (begin_ < count && !passBegins());
            if (begin_ >= count) return Verdict::fine;
            beginWalk();
        }
        const Verdict verdict = walk();
        if (verdict == Verdict::goes_round) return verdict;
        item_ = begin_;
        if (++steps_ > kSteps) return Verdict::too_many;
        if (verdict == Verdict::busy) continue;
        if (cost_ > longest_) longest_ = cost_;
        if (too_many_) return Verdict::too_many;
        if (longest_ > kLimit) return Verdict::too_long;
        walks_ = nextChoice();
        if (walks_) beginWalk();
    }
    return Verdict::busy;
}

}  // namespace mission
