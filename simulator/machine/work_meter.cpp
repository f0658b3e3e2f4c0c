// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/machine/work_meter.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "hal/trace.hpp"
#include "simulator/machine/registers.hpp"

namespace simulator {

constexpr uint64_t kFrame = 10000 * kCyclesPer_us;  // 100 Hz

static uint32_t us(uint64_t cycles) {
    return static_cast<uint32_t>((cycles + kCyclesPer_us / 2) / kCyclesPer_us);
}

void WorkMeter::reset() {
    frame_.reset();
    task_.reset();
}

void WorkMeter::trace(uint8_t value, const Counters& now) {
    if (value == hal::kTraceFrameBegin) {
        beginFrame(now);
    } else if (value == hal::kTraceFrameEnd) {
        endFrame(now);
    } else if (value == hal::kTraceTaskEnd) {
        endTask(now);
    } else if (value > 0 && value <= tasks_.size()) {
        if (value == 1) used_ = std::exchange(ready_, 0);
        task_number_ = value - 1u;
        task_ = now;
    }
}

// Begins come with the sensor's samples, hence the half period of tolerance.
void WorkMeter::beginFrame(const Counters& now) {
    if (frame_) {
        const uint64_t period = now.cycle - frame_->cycle;
        busy_.push_back(static_cast<uint32_t>(period - (now.asleep - frame_->asleep)));
        if (!late_ && period > kFrame * 3 / 2) overruns_++;
    }
    frame_ = now;
    late_ = false;
    frames_++;
}

void WorkMeter::measureLatency() {
    if (!frame_ || used_ == 0 || written_ < frame_->cycle) return;
    const uint64_t latency = written_ - used_;
    used_ = 0;
    latencies_++;
    latency_ += latency;
    longest_latency_ = std::max(longest_latency_, static_cast<uint32_t>(latency));
}

void WorkMeter::endFrame(const Counters& now) {
    measureLatency();
    if (!frame_ || now.cycle - frame_->cycle <= kFrame) return;
    late_ = true;
    overruns_++;
}

void WorkMeter::endTask(const Counters& now) {
    if (!task_) return;
    const uint64_t cycles = now.cycle - task_->cycle - (now.interrupts - task_->interrupts) -
                            (now.asleep - task_->asleep);
    Task& task = tasks_[task_number_];
    task.runs++;
    task.cycles += cycles;
    task.max_cycles = std::max(task.max_cycles, static_cast<uint32_t>(cycles));
    task_.reset();
}

std::optional<uint32_t> WorkMeter::lastFrame_us() const {
    if (busy_.empty()) return std::nullopt;
    return us(busy_.back());
}

void WorkMeter::report(BoardFigures& figures) const {
    if (frames_ == 0) return;
    figures.frames = frames_;
    figures.frame_overruns = overruns_;
    if (!busy_.empty()) {
        std::vector<uint32_t> sorted = busy_;
        std::sort(sorted.begin(), sorted.end());
        const uint64_t sum = std::accumulate(sorted.begin(), sorted.end(), uint64_t{0});
        figures.frame_mean_us = us(sum / sorted.size());
        figures.frame_p99_us = us(sorted[(sorted.size() - 1) * 99 / 100]);
        figures.frame_max_us = us(sorted.back());
    }
    if (latencies_ > 0) {
        figures.latency_mean_us = us(latency_ / latencies_);
        figures.latency_max_us = us(longest_latency_);
    }
    for (size_t i = 0; i < tasks_.size(); i++) {
        const Task& task = tasks_[i];
        if (task.runs == 0) continue;
        figures.tasks.push_back({static_cast<int>(i), task.runs, task.max_cycles,
                                 static_cast<double>(task.cycles) / task.runs});
    }
}

}  // namespace simulator
