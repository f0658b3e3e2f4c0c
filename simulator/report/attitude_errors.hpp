// SPDX-License-Identifier: GPL-3.0-or-later
// How well the autopilot knows its attitude, off the ground: what it reports against the truth
// at the time in the message, so that the delay of the link does not count.
#pragma once
#include <deque>

#include "mavlink/messages.hpp"
#include "simulator/report/metrics.hpp"

namespace simulator {

class AttitudeErrors {
public:
    void watch(const Truth& truth);  // as often as there is one, in order
    // Again and again: counted once. `begun_us`: when the autopilot's clock began, by the
    // simulator's.
    void take(const mavlink::Attitude& sent, uint64_t begun_us);

    Spread roll_deg, pitch_deg, yaw_deg;

private:
    std::deque<Truth> past_;  // of the last second
    uint32_t taken_ms_ = 0;
};

}  // namespace simulator
