// SPDX-License-Identifier: GPL-3.0-or-later
// What can be proved of a table of tasks at compile time: that it is well formed, how full its
// fullest frame is, and how long a row waits. For static_assert.
#pragma once
#include "scheduler/scheduler.hpp"

namespace scheduler {

template <size_t N>
constexpr bool phasesFit(const Task (&tasks)[N]) {
    for (size_t i = 0; i < N; ++i)
        if (tasks[i].period == 0 || tasks[i].period > kLongestPeriod ||
            tasks[i].phase >= tasks[i].period)
            return false;
    return true;
}

// Fast rows stand first, slow ones last, and a fast row takes part in every frame.
template <size_t N>
constexpr bool tiersInOrder(const Task (&tasks)[N]) {
    for (size_t i = 0; i < N; ++i) {
        if (i > 0 && tasks[i].tier < tasks[i - 1].tier) return false;
        if (tasks[i].tier == Tier::fast && tasks[i].period != 1) return false;
    }
    return true;
}

// Frames after which the table is where it began.
template <size_t N>
constexpr uint16_t hyperPeriod(const Task (&tasks)[N]) {
    uint16_t all = 1;
    for (size_t i = 0; i < N; ++i) {
        uint16_t a = all, b = tasks[i].period;
        while (b != 0) {
            const uint16_t rest = a % b;
            a = b;
            b = rest;
        }
        all = all / a * tasks[i].period;
    }
    return all;
}

template <size_t N>
constexpr uint32_t fastTier_us(const Task (&tasks)[N]) {
    uint32_t sum = 0;
    for (size_t i = 0; i < N; ++i)
        if (tasks[i].tier == Tier::fast) sum += tasks[i].budget_us;
    return sum;
}

// The budgets of the fullest frame.
template <size_t N>
constexpr uint32_t worstFrame_us(const Task (&tasks)[N]) {
    const uint16_t frames = hyperPeriod(tasks);
    uint32_t worst = 0;
    for (uint16_t frame = 0; frame < frames; ++frame) {
        uint32_t load = 0;
        for (size_t i = 0; i < N; ++i)
            if (frame % tasks[i].period == tasks[i].phase) load += tasks[i].budget_us;
        if (load > worst) worst = load;
    }
    return worst;
}

// Each medium and slow row fits into a frame beside the fast tier.
template <size_t N>
constexpr bool everyTaskFits(const Task (&tasks)[N], uint32_t frame_us) {
    const uint32_t fast_us = fastTier_us(tasks);
    for (size_t i = 0; i < N; ++i)
        if (tasks[i].tier != Tier::fast && fast_us + tasks[i].budget_us > frame_us) return false;
    return fast_us <= frame_us;
}

// Frames in which a tier runs nothing at most, whatever the rows take: its shortest period, and
// what that row may wait.
template <size_t N>
constexpr uint8_t longestSilence(const Task (&tasks)[N], Tier tier) {
    uint8_t shortest = kLongestPeriod;
    for (size_t i = 0; i < N; ++i)
        if (tasks[i].tier == tier && tasks[i].period < shortest) shortest = tasks[i].period;
    return static_cast<uint8_t>(shortest + patience(tier));
}

// Frames that a row of each tier waits at most.
struct LongestWait {
    uint8_t medium = 0, slow = 0;

    constexpr void add(const LongestWait& other) {
        if (other.medium > medium) medium = other.medium;
        if (other.slow > slow) slow = other.slow;
    }
};

// Who waits after a frame in which only the fast tier has run, each row taking its budget. Those
// that wait stand in a queue, those that wait longest first: the compilers count their steps.
template <size_t N>
class LostFrame {
public:
    // `room_us`: of a frame, for other tiers than the fast one.
    constexpr LostFrame(const Task (&tasks)[N], uint32_t room_us)
        : tasks_(tasks), room_us_(room_us) {}

    // When frame `lost` is lost.
    constexpr LongestWait longestWait(uint16_t lost) {
        longest_ = {};
        collect(lost);
        for (uint16_t frame = lost + 1; waiting_ > 0 && frame < lost + kLongestPeriod; ++frame) {
            collect(frame);
            left_us_ = room_us_;
            serve(Tier::medium, frame, longest_.medium);
            serve(Tier::slow, frame, longest_.slow);
        }
        if (waiting_ > 0) longest_.medium = longest_.slow = kLongestPeriod;
        return longest_;
    }

private:
    // Those that are due now begin to wait, unless they do already.
    constexpr void collect(uint16_t frame) {
        for (size_t i = 0; i < N; ++i) {
            const Task& task = tasks_[i];
            if (task.tier == Tier::fast || waits_[i] || frame % task.period != task.phase) continue;
            waits_[i] = true;
            row_[waiting_] = static_cast<uint8_t>(i);
            since_[waiting_++] = frame;
        }
    }

    constexpr void serve(Tier tier, uint16_t frame, uint8_t& longest) {
        uint8_t kept = 0;
        for (uint8_t i = 0; i < waiting_; ++i) {
            const Task& task = tasks_[row_[i]];
            const uint16_t wait = frame - since_[i];
            if (task.tier == tier && task.budget_us <= left_us_) {
                left_us_ -= task.budget_us;
                waits_[row_[i]] = false;
                if (wait > longest) longest = static_cast<uint8_t>(wait);
                continue;
            }
            row_[kept] = row_[i];
            since_[kept++] = since_[i];
        }
        waiting_ = kept;
    }

    const Task (&tasks_)[N];
    const uint32_t room_us_;
    uint32_t left_us_ = 0;
    bool waits_[N] = {};
    uint8_t row_[N] = {};  // the queue: who waits, and since which frame
    uint16_t since_[N] = {};
    uint8_t waiting_ = 0;
    LongestWait longest_{};
};

// Over all frames that may be lost.
template <size_t N>
constexpr LongestWait waitAfterLostFrame(const Task (&tasks)[N], uint32_t frame_us) {
    const uint16_t frames = hyperPeriod(tasks);
    const uint32_t room_us = frame_us - fastTier_us(tasks);
    LongestWait longest;
    for (uint16_t lost = 0; lost < frames; ++lost)
        longest.add(LostFrame<N>(tasks, room_us).longestWait(lost));
    return longest;
}

}  // namespace scheduler
