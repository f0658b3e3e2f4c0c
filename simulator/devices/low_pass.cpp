// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/devices/low_pass.hpp"

#include <cmath>

namespace simulator {

void LowPass::tune(double bandwidth_hz, double rate_hz) {
    const double k = std::tan(M_PI * bandwidth_hz / rate_hz);
    const double norm = 1 / (1 + M_SQRT2 * k + k * k);
    b0_ = k * k * norm;
    b1_ = 2 * b0_;
    b2_ = b0_;
    a1_ = 2 * (k * k - 1) * norm;
    a2_ = (1 - M_SQRT2 * k + k * k) * norm;
}

void LowPass::settle(double value) {
    s2_ = value * (b2_ - a2_);
    s1_ = value * (b1_ - a1_) + s2_;
}

double LowPass::step(double value) {
    const double out = b0_ * value + s1_;
    s1_ = b1_ * value - a1_ * out + s2_;
    s2_ = b2_ * value - a2_ * out;
    return out;
}

}  // namespace simulator
