// SPDX-License-Identifier: GPL-3.0-or-later
// A cyclic executive. Time is cut in equal frames; each row of the table runs every `period`
// frames, in frame `phase` of that period, for at most `budget_us`. libraries/scheduler/proofs.hpp
// proves at compile time that no frame of a table overflows.
//
// A frame runs
//   1. all fast rows, in the table's order: they are never put off;
//   2. the medium rows that are due, those that have waited longest first;
//   3. the slow rows that are due, likewise.
// A medium or slow row runs when its budget fits into what is left of the frame, else it waits for
// the next one. A row that has waited kMediumPatience or kSlowPatience frames runs whether it fits
// or not: no medium row waits longer than 5 frames and no slow row longer than 25, whatever the
// others take.
// Rows are timed in the clock's ticks, which distinguish what ends within 32 ms. A frame that is
// over is known as such for 16 ms.
#pragma once
#include <stdint.h>

#include "core/rom.hpp"
#include "hal/clock.hpp"
#include "hal/trace.hpp"

namespace scheduler {

using TaskFunction = void (*)();

enum class Tier : uint8_t { fast, medium, slow };

struct Task {
    Tier tier;
    TaskFunction run;
    uint8_t period;  // frames; 1 in the fast tier
    uint8_t phase;   // 0 .. period - 1
    uint16_t budget_us;
};

// The bit of a tier in what takeServed() answers.
constexpr uint8_t bitOf(Tier tier) { return static_cast<uint8_t>(1 << static_cast<uint8_t>(tier)); }

constexpr uint8_t kLongestPeriod = 100;  // frames: what is left of it and a wait share signed bytes
// Frames that a row waits at most.
constexpr int8_t kMediumPatience = 5;
constexpr int8_t kSlowPatience = 25;
constexpr int8_t patience(Tier tier) {
    return tier == Tier::fast ? 0 : tier == Tier::medium ? kMediumPatience : kSlowPatience;
}

template <size_t N>
constexpr uint8_t rowsOf(const Task (&tasks)[N], Tier tier) {
    uint8_t rows = 0;
    for (size_t i = 0; i < N; ++i)
        if (tasks[i].tier == tier) ++rows;
    return rows;
}

// The table stands in the order of the tiers (proofs.hpp: tiersInOrder). It is a part of the type:
// its place is then a constant, as this runs eighteen times a frame.
template <uint8_t kRows, const Task (&kTable)[kRows], uint16_t kFrame_us>
class Scheduler {
public:
    void start() {
        for (uint8_t i = 0; i < kRows; ++i) wait_[i] = core::romRead(kTable[i].phase) + 1;
    }

    // Runs the frame that was due at `due_us`; what is left of it is reckoned from there.
    void runFrame(uint32_t due_us) {
        hal::trace(hal::kTraceFrameBegin);
        const uint32_t began_us = hal::now_us();
        const uint32_t late_us = began_us - due_us;
        now_ = hal::ticks();
        end_ = now_ + (late_us < kFrame_us ? ticks(kFrame_us - static_cast<uint16_t>(late_us)) : 0);
        for (uint8_t i = 0; i < kMedium; ++i) runTimed(i, kTable[i]);
        served_ |= bitOf(Tier::fast);
        serveTier<kMedium, kSlow>(Tier::medium);
        serveTier<kSlow, kRows>(Tier::slow);
        const uint32_t ended_us = hal::now_us();
        busy_us_ += ended_us - began_us;
        noteFrame(ended_us - due_us);
        hal::trace(hal::kTraceFrameEnd);
    }

    // The tiers that have run something since this was asked last.
    uint8_t takeServed() {
        const uint8_t served = served_;
        served_ = 0;
        return served;
    }

    uint16_t longest_us(uint8_t task) const { return longest_[task] / hal::kTicksPerUs; }
    uint16_t longestFrame_us() const { return longest_frame_us_; }  // since it was due
    uint16_t lateFrames() const { return late_frames_; }  // a frame ended after the next was due
    uint32_t busy_us() const { return busy_us_; }         // in frames since start, wraps

private:
    static void countUp(uint16_t& count) {
        if (count != 0xFFFF) ++count;
    }

    static constexpr uint16_t ticks(uint16_t us) { return us * hal::kTicksPerUs; }

    void noteFrame(uint32_t frame_us) {
        if (frame_us > longest_frame_us_)
            longest_frame_us_ = frame_us > 0xFFFF ? 0xFFFF : static_cast<uint16_t>(frame_us);
        if (frame_us > kFrame_us) countUp(late_frames_);
    }

    // Counts down to the rows kFrom up to kEnd, then serves those that are due. A frame in which
    // none was put off is one round.
    template <uint8_t kFrom, uint8_t kEnd>
    void serveTier(Tier tier) {
        uint8_t* end = due_;
        int8_t latest = 0;
        int8_t* of_row = wait_ + kFrom;
        for (uint8_t i = kFrom; i != kEnd; ++i) {
            const int8_t wait = static_cast<int8_t>(*of_row - 1);
            *of_row++ = wait;
            if (wait > 0) continue;
            *end++ = i;
            if (wait < latest) latest = wait;
        }
        for (int8_t late = latest; late <= 0; ++late)
            for (const uint8_t* row = due_; row != end; ++row)
                if (wait_[*row] == late) serve(*row, tier);
    }

    void serve(uint8_t i, Tier tier) {
        const Task& task = kTable[i];
        int8_t wait = wait_[i];
        const int16_t left = static_cast<int16_t>(end_ - now_);  // below 0: the frame is over
        const bool fits = static_cast<int16_t>(ticks(core::romRead(task.budget_us))) <= left;
        if (!fits && wait > -patience(tier)) return;
        const uint8_t period = core::romRead(task.period);
        do wait += period;  // from when it was due, not from now: the phase is kept
        while (wait <= 0);
        wait_[i] = wait;
        served_ |= bitOf(tier);
        runTimed(i, task);
    }

    // Not inlined three times into main(), where toolchain/image/stack_bound.mjs would lose its
    // track. Flat it takes 0.1 % of the processor less.
    __attribute__((noinline, flatten)) void runTimed(uint8_t i, const Task& task) {
        hal::trace(i + 1);
        core::romRead(task.run)();
        hal::trace(hal::kTraceTaskEnd);
        const uint16_t ended = hal::ticks();
        const uint16_t taken = ended - now_;
        now_ = ended;
        if (taken > longest_[i]) longest_[i] = taken;
    }

    // Where these tiers begin.
    static constexpr uint8_t kMedium = rowsOf(kTable, Tier::fast);
    static constexpr uint8_t kSlow = kRows - rowsOf(kTable, Tier::slow);
    static constexpr uint8_t kLargerTier =
        kSlow - kMedium > kRows - kSlow ? kSlow - kMedium : kRows - kSlow;

    int8_t wait_[kRows] = {};  // frames until due; 0 due, below 0 late by as many; not of the fast
    uint8_t due_[kLargerTier > 0 ? kLargerTier : 1] = {};  // rows of the tier that is being served
    uint16_t longest_[kRows] = {};                         // in ticks, as the next two
    uint16_t now_ = 0;
    uint16_t end_ = 0;  // when the frame is over
    uint8_t served_ = 0;
    uint16_t late_frames_ = 0;
    uint16_t longest_frame_us_ = 0;
    uint32_t busy_us_ = 0;
};

}  // namespace scheduler
