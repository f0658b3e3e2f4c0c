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
    uint32_t worst = 0;
    for (uint16_t frame = 0; frame < hyperPeriod(tasks); ++frame) {
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

// Who waits after a frame in which only the fast tier has run, each row taking its budget.
template <size_t N>
class LostFrame {
public:
    constexpr LostFrame(const Task (&tasks)[N], uint32_t frame_us)
        : tasks_(tasks), frame_us_(frame_us) {}

    // Frames that a row of the tier waits at most when frame `lost` is lost.
    constexpr uint8_t longestWait(Tier tier, uint16_t lost) {
        longest_ = 0;
        collect(lost);
        for (uint16_t frame = lost + 1; waiting_ > 0 && frame < lost + kLongestPeriod; ++frame) {
            collect(frame);
            left_us_ = frame_us_ - fastTier_us(tasks_);
            serve(Tier::medium, tier);
            serve(Tier::slow, tier);
        }
        return waiting_ == 0 ? longest_ : kLongestPeriod;
    }

private:
    // Those that wait are a frame later, those that are due now begin to wait.
    constexpr void collect(uint16_t frame) {
        for (size_t i = 0; i < N; ++i) {
            if (wait_[i] != 0) {
                ++wait_[i];
            } else if (tasks_[i].tier != Tier::fast &&
                       frame % tasks_[i].period == tasks_[i].phase) {
                wait_[i] = 1;
                ++waiting_;
            }
            if (wait_[i] > latest_) latest_ = wait_[i];
        }
    }

    constexpr void serve(Tier tier, Tier asked) {
        for (uint8_t wait = latest_; wait > 0; --wait)
            for (size_t i = 0; i < N; ++i) {
                if (tasks_[i].tier != tier || wait_[i] != wait) continue;
                if (tasks_[i].budget_us > left_us_) continue;
                left_us_ -= tasks_[i].budget_us;
                if (tier == asked && wait - 1 > longest_) longest_ = wait - 1;
                wait_[i] = 0;
                --waiting_;
            }
    }

    const Task (&tasks_)[N];
    uint32_t frame_us_, left_us_ = 0;
    uint8_t wait_[N] = {};  // 0: does not wait; 1: due now; 2: for one frame
    uint8_t waiting_ = 0, latest_ = 0, longest_ = 0;
};

// Over all frames that may be lost.
template <size_t N>
constexpr uint8_t waitAfterLostFrame(const Task (&tasks)[N], Tier tier, uint32_t frame_us) {
    uint8_t longest = 0;
    for (uint16_t lost = 0; lost < hyperPeriod(tasks); ++lost) {
        LostFrame<N> simulated(tasks, frame_us);
        const uint8_t wait = simulated.longestWait(tier, lost);
        if (wait > longest) longest = wait;
    }
    return longest;
}

}  // namespace scheduler
