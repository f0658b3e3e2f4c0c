// SPDX-License-Identifier: GPL-3.0-or-later
// Zero of the gyros, at start-up: the mean of a second in which the airplane was not moved. Moved,
// it begins again, for as long as it takes.
#pragma once
#include <stdint.h>

#include "core/maths.hpp"

namespace estimation {

class Still {
public:
    void start() { *this = Still(); }
    // Every frame. True once, when the zero is known.
    bool update(const core::Vector3& rate_rads, const core::Vector3& force_mss, float dt_s);

    void forgo() { done_ = true; }  // the zero is known already

    bool done() const { return done_; }
    const core::Vector3& zero_rads() const { return zero_; }
    const core::Vector3& force_mss() const { return force_; }  // the mean of the same time

private:
    bool usePart();

    core::Vector3 zero_ = {0, 0, 0};  // mean of the still parts
    core::Vector3 force_ = {0, 0, 0};
    core::Vector3 rate_sum_ = {0, 0, 0}, force_sum_ = {0, 0, 0};
    float part_s_ = 0;  // summed up
    float time_s_ = 0;  // still for this long
    bool done_ = false;
};

}  // namespace estimation
