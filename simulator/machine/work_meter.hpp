// SPDX-License-Identifier: GPL-3.0-or-later
// What the firmware traces (hal/trace.hpp) of its frames and tasks, in cycles. A frame is
// counted from its begin to the next one's: its tasks, the interrupts in it and what is done in
// the rest of it, all that is not sleep. Tasks are counted without interrupts. The latency of a
// frame is from the newest inertial sample that it uses to the last compare value it writes
// for outputs 1 to 4.
#pragma once
#include <array>
#include <optional>
#include <vector>

#include "simulator/board.hpp"

namespace simulator {

class WorkMeter {
public:
    struct Counters {
        uint64_t cycle, asleep, interrupts;
    };

    void trace(uint8_t value, const Counters& now);
    void sampleReady(uint64_t cycle) { ready_ = cycle; }
    void servoWritten(uint64_t cycle) { written_ = cycle; }
    void reset();  // the firmware starts again: what was under way never ends

    void report(BoardFigures& figures) const;
    std::optional<uint32_t> lastFrame_us() const;

private:
    struct Task {
        uint32_t runs = 0, max_cycles = 0;
        uint64_t cycles = 0;
    };

    void beginFrame(const Counters& now);
    void endFrame(const Counters& now);
    void measureLatency();
    void endTask(const Counters& now);

    std::optional<Counters> frame_, task_;  // at the beginning of the one under way
    size_t task_number_ = 0;
    bool late_ = false;  // the frame under way is already counted as overrun
    std::vector<uint32_t> busy_;
    // The newest sample when the first task takes it, and the last servo written.
    uint64_t ready_ = 0, used_ = 0, written_ = 0, latency_ = 0;
    uint32_t latencies_ = 0, longest_latency_ = 0;
    uint32_t frames_ = 0, overruns_ = 0;
    std::array<Task, 0x7F> tasks_ = {};
};

}  // namespace simulator
