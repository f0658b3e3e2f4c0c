// SPDX-License-Identifier: GPL-3.0-or-later
// When the next step of a live flight is due: at real time, a multiple of it, as fast as the
// computer goes, or not at all.
#pragma once
#include <chrono>
#include <cstdint>
#include <optional>

namespace simulator::live {

class FlightClock {
public:
    using Clock = std::chrono::steady_clock;

    // `times`: real time, 0: as fast as it goes. Both from `now` on.
    void setSpeed(double times, Clock::time_point now, uint64_t time_us);
    void pause(bool paused, Clock::time_point now, uint64_t time_us);

    bool paused() const { return paused_; }
    double times() const { return times_; }

    // How long until the step to `until_us` is due: zero when it is, empty while paused. Time that
    // was lost by more than a second, by a slow or busy computer, is not caught up.
    std::optional<Clock::duration> wait(Clock::time_point now, uint64_t until_us);

    // What the speed has been lately, times real time. To be called with each step.
    double measured(Clock::time_point now, uint64_t time_us);

private:
    void begin(Clock::time_point now, uint64_t time_us);

    bool paused_ = false, begun_ = false;
    double times_ = 1;
    Clock::time_point start_{}, measured_at_{};
    uint64_t start_us_ = 0, measured_us_ = 0;
    double measured_ = 0;
};

}  // namespace simulator::live
