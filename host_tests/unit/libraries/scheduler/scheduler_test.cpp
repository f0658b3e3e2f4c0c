// SPDX-License-Identifier: GPL-3.0-or-later
#include "scheduler/scheduler.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "fakes/fakes.hpp"
#include "scheduler/proofs.hpp"

namespace {

constexpr uint16_t kFrame_us = 10000;

struct Fake {
    uint32_t spends_us = 0;
    std::vector<int> frames;  // in which it ran
};
Fake fast, medium, fifth, slow, twin;
int frame;

template <Fake& fake>
void run() {
    fake.frames.push_back(frame);
    fakes::advance_us(fake.spends_us);
}

using scheduler::Task;
using scheduler::Tier;

// clang-format off
constexpr Task kTasks[] ROM = {
    // tier           run          every in  budget us
    { Tier::fast,   run<fast>,     1,  0,  4000 },
    { Tier::medium, run<medium>,  10,  3,  2000 },
    { Tier::medium, run<fifth>,    5,  3,  3000 },
    { Tier::slow,   run<slow>,   100,  7,  5000 },
    { Tier::slow,   run<twin>,   100,  7,  5000 },
};
// clang-format on

static_assert(scheduler::phasesFit(kTasks), "");
static_assert(scheduler::tiersInOrder(kTasks), "");
static_assert(scheduler::hyperPeriod(kTasks) == 100, "");
static_assert(scheduler::fastTier_us(kTasks) == 4000, "");
static_assert(scheduler::worstFrame_us(kTasks) == 14000, "two slow tasks in frame 7");
static_assert(scheduler::everyTaskFits(kTasks, 9000), "");
static_assert(!scheduler::everyTaskFits(kTasks, 8999), "");
static_assert(scheduler::longestSilence(kTasks, Tier::medium) == 5 + 5, "");
static_assert(scheduler::longestSilence(kTasks, Tier::slow) == 100 + 25, "");
// frame 7 is lost: in frame 8 the fifth is due and no slow one fits beside it, 9 and 10 have one
// each
static_assert(scheduler::waitAfterLostFrame(kTasks, kFrame_us).medium == 1, "");
static_assert(scheduler::waitAfterLostFrame(kTasks, kFrame_us).slow == 3, "");

constexpr Task kPeriods[] = {{Tier::fast, run<fast>, 1, 0, 1},
                             {Tier::medium, run<medium>, 4, 0, 1},
                             {Tier::slow, run<slow>, 10, 0, 1},
                             {Tier::slow, run<slow>, 8, 0, 1}};
static_assert(scheduler::hyperPeriod(kPeriods) == 40, "");
constexpr Task kBadPhase[] = {{Tier::fast, run<fast>, 1, 0, 1}, {Tier::slow, run<slow>, 5, 5, 1}};
static_assert(!scheduler::phasesFit(kBadPhase), "");
constexpr Task kTooLong[] = {{Tier::slow, run<slow>, 101, 0, 1}};
static_assert(!scheduler::phasesFit(kTooLong), "");
constexpr Task kFastLast[] = {{Tier::medium, run<slow>, 5, 0, 1}, {Tier::fast, run<fast>, 1, 0, 1}};
static_assert(!scheduler::tiersInOrder(kFastLast), "");
constexpr Task kSlowFirst[] = {{Tier::slow, run<slow>, 5, 0, 1},
                               {Tier::medium, run<slow>, 5, 0, 1}};
static_assert(!scheduler::tiersInOrder(kSlowFirst), "");
constexpr Task kRareFast[] = {{Tier::fast, run<fast>, 2, 0, 1}};
static_assert(!scheduler::tiersInOrder(kRareFast), "");

class Schedule : public ::testing::Test {
protected:
    void SetUp() override {
        fakes::reset();
        for (Fake* fake : {&fast, &medium, &fifth, &slow, &twin}) *fake = Fake{};
        frame = 0;
        schedule.start();
    }

    // Frames begin when they are due, or at once when the one before ran into them.
    void runFrames(int count) {
        for (; count > 0; --count, ++frame) {
            const uint64_t due_us = uint64_t{kFrame_us} * frame;
            if (fakes::time_us() < due_us) fakes::setTime_us(due_us);
            schedule.runFrame(static_cast<uint32_t>(due_us));
        }
    }

    scheduler::Scheduler<5, kTasks, kFrame_us> schedule;
};

using Frames = std::vector<int>;

TEST_F(Schedule, tasks_run_at_their_period_in_their_phase) {
    runFrames(20);

    EXPECT_EQ(fast.frames.size(), 20u);
    EXPECT_EQ(medium.frames, (Frames{3, 13}));
    EXPECT_EQ(fifth.frames, (Frames{3, 8, 13, 18}));
    EXPECT_EQ(slow.frames, (Frames{7}));
}

TEST_F(Schedule, remembers_the_longest_time_of_a_task) {
    fifth.spends_us = 3001;
    runFrames(10);
    fifth.spends_us = 700;
    runFrames(5);

    EXPECT_EQ(schedule.longest_us(2), 3001);
    EXPECT_EQ(schedule.longest_us(0), 0);
}

TEST_F(Schedule, a_lower_task_that_does_not_fit_waits_for_a_later_frame) {
    fast.spends_us = 4000;
    slow.spends_us = 1001;  // leaves 4999 us: the twin's budget does not fit
    runFrames(8);
    EXPECT_EQ(slow.frames, (Frames{7}));
    EXPECT_TRUE(twin.frames.empty());

    runFrames(1);
    EXPECT_EQ(twin.frames, (Frames{8}));
    EXPECT_EQ(schedule.lateFrames(), 0);
}

TEST_F(Schedule, the_phase_survives_a_deferral) {
    fast.spends_us = 4000;
    slow.spends_us = 1001;
    runFrames(220);

    EXPECT_EQ(twin.frames, (Frames{8, 108, 208}));
}

TEST_F(Schedule, medium_tasks_go_before_slow_ones_that_have_waited_longer) {
    runFrames(7);
    fast.spends_us = 6000;  // no slow task fits
    runFrames(1);
    fast.spends_us = 2000;  // frame 8: fifth is due, and one more fits beside it
    fifth.spends_us = 3000;
    slow.spends_us = 5000;
    runFrames(1);

    EXPECT_EQ(fifth.frames, (Frames{3, 8}));
    EXPECT_EQ(slow.frames, (Frames{8}));
    EXPECT_TRUE(twin.frames.empty());
    fifth.spends_us = 3001;
    runFrames(99);
    EXPECT_EQ(slow.frames, (Frames{8, 107})) << "beside no medium task";
    runFrames(2);
    EXPECT_EQ(twin.frames, (Frames{9, 109})) << "the fifth was due in frame 108, and went first";
}

TEST_F(Schedule, of_a_tier_the_task_that_has_waited_longest_goes_first) {
    fast.spends_us = 8500;
    runFrames(5);  // medium and fifth wait since frame 3
    EXPECT_TRUE(medium.frames.empty());
    fast.spends_us = 6000;  // one of them fits
    medium.spends_us = 2000;
    runFrames(1);
    EXPECT_EQ(medium.frames, (Frames{5})) << "the first in the table of those that wait as long";
    EXPECT_TRUE(fifth.frames.empty());
}

TEST_F(Schedule, a_frame_that_begins_late_has_less_room) {
    runFrames(3);
    fakes::setTime_us(3 * kFrame_us + 8500);  // something else held the processor
    runFrames(1);

    EXPECT_TRUE(medium.frames.empty());
    EXPECT_EQ(fast.frames.size(), 4u);
}

TEST_F(Schedule,
       at_full_load_no_frame_is_late_and_every_task_runs_within_its_period_and_ten_frames) {
    fast.spends_us = 4000;
    medium.spends_us = 2000;
    fifth.spends_us = 3000;
    slow.spends_us = twin.spends_us = 5000;
    runFrames(1000);

    EXPECT_EQ(schedule.lateFrames(), 0);
    const struct {
        const Fake& fake;
        int period;
    } cases[] = {{medium, 10}, {fifth, 5}, {slow, 100}, {twin, 100}};
    for (const auto& task : cases) {
        int last = 0;
        for (int ran : task.fake.frames) {
            EXPECT_LE(ran - last, task.period + 10);
            last = ran;
        }
        EXPECT_LE(1000 - last, task.period + 10);
    }
}

TEST_F(Schedule, a_task_runs_at_last_even_when_the_fast_tier_leaves_no_room) {
    fast.spends_us = 9999;
    runFrames(40);

    EXPECT_EQ(medium.frames, (Frames{8, 18, 28, 38}));
    EXPECT_EQ(fifth.frames, (Frames{8, 13 + 5, 23 + 5, 33 + 5}));
    EXPECT_EQ(slow.frames, (Frames{7 + 25}));
}

// A task is due in its phase. It runs in that frame or in one of the next ones, and what it was
// put off over is not made up for.
int longestWait(const std::vector<int>& frames, int period, int phase, int last) {
    int longest = 0, due = phase;
    for (int ran : frames) {
        longest = std::max(longest, ran - due);
        while (due <= ran) due += period;
    }
    return std::max(longest, last - due);
}

TEST_F(Schedule, no_task_waits_longer_than_its_tier_may_whatever_the_others_take) {
    constexpr int kFrames = 100000;
    std::mt19937 random(1);
    std::exponential_distribution<> factor(0.5);
    for (int i = 0; i < kFrames; ++i) {
        const bool quiet = i / 1000 % 3 == 0;
        for (Fake* fake : {&fast, &medium, &fifth, &slow, &twin})
            fake->spends_us = static_cast<uint32_t>((quiet ? 500 : 4000) * factor(random));
        runFrames(1);
    }

    EXPECT_GT(schedule.lateFrames(), 1000) << "there was too much to do";
    EXPECT_EQ(fast.frames.size(), static_cast<size_t>(kFrames));
    EXPECT_EQ(longestWait(medium.frames, 10, 3, kFrames - 1), scheduler::kMediumPatience);
    EXPECT_EQ(longestWait(fifth.frames, 5, 3, kFrames - 1), scheduler::kMediumPatience);
    EXPECT_EQ(longestWait(slow.frames, 100, 7, kFrames - 1), scheduler::kSlowPatience);
    EXPECT_EQ(longestWait(twin.frames, 100, 7, kFrames - 1), scheduler::kSlowPatience);
}

// The proof is a second reading of what the scheduler does: both have to agree.
TEST_F(Schedule, after_a_lost_frame_tasks_wait_as_long_as_is_proved) {
    int medium_waits = 0, slow_waits = 0;
    for (int lost = 0; lost < 100; ++lost) {
        SetUp();
        for (int i = 0; i < 200 + 100; ++i) {
            fast.spends_us = i == 100 + lost ? 9999 : 4000;
            medium.spends_us = 2000;
            fifth.spends_us = 3000;
            slow.spends_us = twin.spends_us = 5000;
            runFrames(1);
        }
        medium_waits = std::max(medium_waits, longestWait(medium.frames, 10, 3, 299));
        medium_waits = std::max(medium_waits, longestWait(fifth.frames, 5, 3, 299));
        slow_waits = std::max(slow_waits, longestWait(slow.frames, 100, 7, 299));
        slow_waits = std::max(slow_waits, longestWait(twin.frames, 100, 7, 299));
    }
    EXPECT_EQ(medium_waits, scheduler::waitAfterLostFrame(kTasks, kFrame_us).medium);
    EXPECT_EQ(slow_waits, scheduler::waitAfterLostFrame(kTasks, kFrame_us).slow);
}

TEST_F(Schedule, a_frame_past_its_period_is_counted) {
    fast.spends_us = 10001;
    runFrames(1);

    EXPECT_EQ(schedule.lateFrames(), 1);
}

TEST_F(Schedule, busy_time_is_the_time_in_frames) {
    fast.spends_us = 1000;
    medium.spends_us = 500;
    runFrames(10);

    EXPECT_EQ(schedule.busy_us(), 10500u);
}

TEST_F(Schedule, frames_and_tasks_are_marked_for_who_measures_from_outside) {
    runFrames(3);
    fakes::marks().clear();
    runFrames(1);

    EXPECT_EQ(fakes::marks(), (std::vector<uint8_t>{0xF0, 1, 0x80, 2, 0x80, 3, 0x80, 0xF1}));
}

TEST_F(Schedule, time_may_wrap) {
    fakes::setTime_us(0xFFFFF000u);
    fast.spends_us = 4000;
    schedule.runFrame(0xFFFFF000u);
    fakes::setTime_us(0x100000000u - 4096 + kFrame_us);
    schedule.runFrame(0xFFFFF000u + kFrame_us);

    EXPECT_EQ(schedule.lateFrames(), 0);
    EXPECT_EQ(schedule.longest_us(0), 4000);
}

}  // namespace
