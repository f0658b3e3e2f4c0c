// SPDX-License-Identifier: GPL-3.0-or-later
// A second-order Butterworth low-pass, by the bilinear transform with its -3 dB point kept.
#pragma once

namespace simulator {

class LowPass {
public:
    void tune(double bandwidth_hz, double rate_hz);
    void settle(double value);  // as after a long time at `value`
    double step(double value);

private:
    double b0_ = 1, b1_ = 0, b2_ = 0, a1_ = 0, a2_ = 0;
    double s1_ = 0, s2_ = 0;  // transposed direct form II
};

}  // namespace simulator
