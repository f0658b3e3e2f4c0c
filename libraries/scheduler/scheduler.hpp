// SPDX-License-Identifier: GPL-3.0-or-later
// A cyclic executive. Time is cut in equal frames; each task runs every `period` frames, in frame
// `phase` of that period, for at most `budget_us`. The table is the schedule, and the functions
// here prove at compile time that no frame of it overflows. What runs over its budget all the
// same costs only the lower tier: its tasks wait for a later frame, the one that waits longest
// goes first. Tasks are timed in the clock's ticks, which distinguish what ends within 32 ms.
#pragma once
#include <stdint.h>

#include "core/rom.hpp"
#include "hal/clock.hpp"
#include "hal/mark.hpp"

namespace scheduler {

using TaskFunction = void (*)();

struct Task {
    TaskFunction run;
    uint8_t period;  // frames; 1 is the fast tier, never put off
    uint8_t phase;   // 0 .. period - 1
    uint16_t budget_us;
};

// The tiers, a bit each.
enum Tier : uint8_t { kFast = 1, kMedium = 2, kSlow = 4 };
constexpr uint8_t kLongestMediumPeriod = 10;
constexpr uint8_t tierOf(uint8_t period) {
    return period == 1 ? kFast : (period <= kLongestMediumPeriod ? kMedium : kSlow);
}

constexpr uint8_t kLongestPeriod = 100;  // countdown and lateness share a signed byte
constexpr int8_t kPatience = 10;  // frames a task waits before it runs whether it fits or not

template <size_t N>
constexpr bool phasesFit(const Task (&tasks)[N]) {
    for (size_t i = 0; i < N; ++i)
        if (tasks[i].period == 0 || tasks[i].period > kLongestPeriod ||
            tasks[i].phase >= tasks[i].period)
            return false;
    return true;
}

// The fast tier stands first in the table and takes part in every frame.
template <size_t N>
constexpr bool fastTierFirst(const Task (&tasks)[N]) {
    for (size_t i = 1; i < N; ++i)
        if (tasks[i].period == 1 && tasks[i - 1].period != 1) return false;
    return true;
}

template <size_t N>
constexpr uint32_t fastTier_us(const Task (&tasks)[N]) {
    uint32_t sum = 0;
    for (size_t i = 0; i < N; ++i)
        if (tasks[i].period == 1) sum += tasks[i].budget_us;
    return sum;
}

// The fullest of the first `frames` frames; pass the hyper-period.
template <size_t N>
constexpr uint32_t worstFrame_us(const Task (&tasks)[N], uint16_t frames) {
    uint32_t worst = 0;
    for (uint16_t frame = 0; frame < frames; ++frame) {
        uint32_t load = 0;
        for (size_t i = 0; i < N; ++i)
            if (frame % tasks[i].period == tasks[i].phase) load += tasks[i].budget_us;
        if (load > worst) worst = load;
    }
    return worst;
}

// A put-off task that goes first in a frame fits beside the fast tier, so each frame serves at
// least one: no task waits longer than there are tasks.
template <size_t N>
constexpr bool everyTaskFits(const Task (&tasks)[N], uint32_t frame_us) {
    const uint32_t fast_us = fastTier_us(tasks);
    for (size_t i = 0; i < N; ++i)
        if (tasks[i].period != 1 && fast_us + tasks[i].budget_us > frame_us) return false;
    return fast_us <= frame_us;
}

template <uint8_t N>
class Scheduler {
public:
    constexpr Scheduler(const Task (&tasks)[N], uint16_t frame_us)
        : tasks_(tasks), frame_us_(frame_us) {}

    void start() {
        fast_ = 0;
        for (uint8_t i = 0; i < N; ++i) {
            wait_[i] = core::romRead(tasks_[i].phase) + 1;
            if (core::romRead(tasks_[i].period) == 1) ++fast_;
        }
    }

    // Runs the frame that was due at `due_us`; what is left of it is reckoned from there.
    void runFrame(uint32_t due_us) {
        hal::mark(hal::kMarkFrameBegin);
        const uint32_t began_us = hal::now_us();
        const uint32_t late_us = began_us - due_us;
        began_ = now_ = hal::ticks();
        room_ = late_us < frame_us_ ? ticks(frame_us_ - static_cast<uint16_t>(late_us)) : 0;
        for (uint8_t i = 0; i < fast_; ++i) runTimed(i, tasks_[i], kFast);
        // those that have waited longest first; a frame in which none was put off is one round
        for (int8_t late = countDown(); late <= 0; ++late)
            for (uint8_t i = dueFrom(fast_, late); i < N; i = dueFrom(i + 1, late)) serve(i);
        const uint32_t ended_us = hal::now_us();
        busy_us_ += ended_us - began_us;
        judge(ended_us - due_us);
        hal::mark(hal::kMarkFrameEnd);
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

    // The smallest wait of what is not of the fast tier, 1 when nothing is due.
    int8_t countDown() {
        int8_t latest = 1;
        int8_t* next = wait_ + fast_;
        for (uint8_t i = fast_; i < N; ++i) {
            int8_t wait = *next;
            if (wait > -kPatience) --wait;
            *next++ = wait;
            if (wait < latest) latest = wait;
        }
        return latest;
    }

    // The first from `i` on that waits as long as `late` says; N when none does.
    uint8_t dueFrom(uint8_t i, int8_t late) const {
        for (const int8_t* wait = wait_ + i; i < N && *wait != late; ++wait) ++i;
        return i;
    }

    static constexpr uint16_t ticks(uint16_t us) { return us * hal::kTicksPerUs; }

    void judge(uint32_t frame_us) {
        if (frame_us > longest_frame_us_)
            longest_frame_us_ = frame_us > 0xFFFF ? 0xFFFF : static_cast<uint16_t>(frame_us);
        if (frame_us > frame_us_) countUp(late_frames_);
    }

    void serve(uint8_t i) {
        const Task& task = tasks_[i];
        const uint16_t budget_us = core::romRead(task.budget_us);
        const uint16_t spent = now_ - began_;
        const bool fits = spent <= room_ && ticks(budget_us) <= room_ - spent;
        if (!fits && wait_[i] > -kPatience) return;
        const uint8_t period = core::romRead(task.period);
        do wait_[i] += period;  // from when it was due, not from now: the phase is kept
        while (wait_[i] <= 0);
        runTimed(i, task, tierOf(period));
    }

    void runTimed(uint8_t i, const Task& task, uint8_t tier) {
        hal::mark(i + 1);
        core::romRead(task.run)();
        served_ |= tier;
        hal::mark(hal::kMarkTaskEnd);
        const uint16_t ended = hal::ticks();
        const uint16_t taken = ended - now_;
        now_ = ended;
        if (taken > longest_[i]) longest_[i] = taken;
    }

    const Task (&tasks_)[N];
    const uint16_t frame_us_;
    uint8_t served_ = 0;
    uint8_t fast_ = 0;          // tasks of the fast tier: they stand first
    int8_t wait_[N] = {};       // frames until due; 0 due, below 0 late by as many; not of the fast
    uint16_t longest_[N] = {};  // in ticks, as the next three
    uint16_t began_ = 0, now_ = 0;
    uint16_t room_ = 0;  // that the frame had when it began
    uint16_t late_frames_ = 0;
    uint16_t longest_frame_us_ = 0;
    uint32_t busy_us_ = 0;
};

}  // namespace scheduler
