// SPDX-License-Identifier: GPL-3.0-or-later
// Zero of the gyros, at start-up: the mean of a second in which the airplane was not moved. Moved,
// it begins again, for as long as it takes. Gusts that rock it on its wheels turn it to and fro,
// not about: then the means of twice two seconds must agree. As a rocked airplane ends them turned
// by a little, the mean goes on for up to half a minute.
#pragma once
#include <stdint.h>

#include "core/maths.hpp"

namespace estimation {

class GyroBiasInit {
public:
    void start() { *this = GyroBiasInit(); }
    // Every frame. True when the zero is known, and when it is known better.
    bool update(const core::Vector3& rate_rads, const core::Vector3& force_mss, float dt_s);

    // The zero is known already.
    void forgo() { known_ = parts_ = kMax; }

    bool done() const { return known_ != 0; }                  // good enough to fly
    bool settled() const { return done() && parts_ == kMax; }  // as good as it gets
    const core::Vector3& zero_rads() const { return zero_; }
    const core::Vector3& force_mss() const { return force_; }  // the mean of the first seconds

private:
    bool usePart();
    bool isStill(const core::Vector3& rate_rads, const core::Vector3& force_mss) const;
    bool useFirst();
    bool useMean();

    core::Vector3 zero_ = {0, 0, 0};
    core::Vector3 mean_ = {0, 0, 0};  // of the still parts
    core::Vector3 force_ = {0, 0, 0};
    core::Vector3 rate_sum_ = {0, 0, 0}, force_sum_ = {0, 0, 0};
    uint16_t part_ms_ = 0;   // summed up
    uint8_t parts_ = 0;      // it has been still for
    uint8_t known_ = 0;      // parts whose mean the zero is
    bool rocked_ = false;    // in the first parts
    bool compared_ = false;  // the zero is known by one mean already

    static constexpr uint8_t kSecond = 10, kRocked = 20, kMax = 25 * kSecond;  // parts
};

}  // namespace estimation
