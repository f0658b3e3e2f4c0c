// SPDX-License-Identifier: GPL-3.0-or-later
// Zero of the gyros, at start-up: the mean of a second in which the airplane was not moved. Moved,
// it begins again, for as long as it takes. An airplane that gusts rock on its wheels ends that
// second turned by a little, which a longer mean makes up for: it goes on for up to half a minute.
#pragma once
#include <stdint.h>

#include "core/maths.hpp"

namespace estimation {

class Still {
public:
    void start() { *this = Still(); }
    // Every frame. True when the zero is known, and when it is known better.
    bool update(const core::Vector3& rate_rads, const core::Vector3& force_mss, float dt_s);

    // The zero is known already.
    void forgo() {
        done_ = true;
        parts_ = kMost;
    }

    bool done() const { return done_; }                        // good enough to fly
    bool settled() const { return done_ && parts_ == kMost; }  // as good as it gets
    const core::Vector3& zero_rads() const { return zero_; }
    const core::Vector3& force_mss() const { return force_; }  // the mean of the first second

private:
    bool usePart();
    bool isStill(const core::Vector3& rate_rads, const core::Vector3& force_mss) const;
    bool useMean();

    core::Vector3 zero_ = {0, 0, 0};
    core::Vector3 mean_ = {0, 0, 0};  // of the still parts
    core::Vector3 force_ = {0, 0, 0};
    core::Vector3 rate_sum_ = {0, 0, 0}, force_sum_ = {0, 0, 0};
    float part_s_ = 0;   // summed up
    uint8_t parts_ = 0;  // it has been still for
    bool done_ = false;

    static constexpr uint8_t kSecond = 10, kMost = 25 * kSecond;  // parts
};

}  // namespace estimation
