// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/live/flight_clock.hpp"

namespace simulator::live {

using std::chrono::duration;
using std::chrono::duration_cast;

constexpr std::chrono::milliseconds kTooLate{1000}, kMeasured{500};

void FlightClock::begin(Clock::time_point now, uint64_t time_us) {
    begun_ = true;
    start_ = measured_at_ = now;
    start_us_ = measured_us_ = time_us;
}

void FlightClock::setSpeed(double times, Clock::time_point now, uint64_t time_us) {
    times_ = times;
    measured_ = times;  // until it is known better
    begin(now, time_us);
}

void FlightClock::pause(bool paused, Clock::time_point now, uint64_t time_us) {
    paused_ = paused;
    begin(now, time_us);
}

std::optional<FlightClock::Clock::duration> FlightClock::wait(Clock::time_point now,
                                                              uint64_t until_us) {
    if (paused_) return std::nullopt;
    if (!begun_) setSpeed(times_, now, until_us);
    if (times_ == 0) return Clock::duration::zero();
    const duration<double, std::micro> needed(static_cast<double>(until_us - start_us_) / times_);
    const auto due = start_ + duration_cast<Clock::duration>(needed);
    if (due > now) return due - now;
    if (now - due > kTooLate) start_ += now - due;
    return Clock::duration::zero();
}

double FlightClock::measured(Clock::time_point now, uint64_t time_us) {
    const auto passed = now - measured_at_;
    if (passed < kMeasured || paused_) return measured_;
    const double passed_us = duration<double, std::micro>(passed).count();
    measured_ = static_cast<double>(time_us - measured_us_) / passed_us;
    measured_at_ = now;
    measured_us_ = time_us;
    return measured_;
}

}  // namespace simulator::live
