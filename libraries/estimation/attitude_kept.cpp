// SPDX-License-Identifier: GPL-3.0-or-later
// The attitude over a restart of the program.
#include "estimation/attitude.hpp"

namespace estimation {

constexpr int32_t kRowStep = 65536, kBiasStep = 64;
constexpr float kHalfSettled = 0.9f;  // a restart leaves an error of degrees, not of tens

void Attitude::keep(Pose& pose) const {
    for (uint8_t i = 0; i < 3; ++i) {
        pose.north[i] = core::upper(north_.of[i]);
        pose.down[i] = core::upper(down_.of[i]);
    }
}

void Attitude::keep(Learnt& learnt) const {
    for (uint8_t i = 0; i < 3; ++i) learnt.bias[i] = core::narrowed(bias_.of[i] / kBiasStep);
    field_.keep(learnt.field);
}

void Attitude::resume(const Pose& pose, const Learnt& learnt, const core::Vector3& turned_rad) {
    start();
    for (uint8_t i = 0; i < 3; ++i) {
        north_.of[i] = pose.north[i] * kRowStep;
        down_.of[i] = pose.down[i] * kRowStep;
        bias_.of[i] = learnt.bias[i] * kBiasStep;
    }
    learnRates({0, 0, 0});
    field_.resume(learnt.field);
    settling_ = kHalfSettled;
    phase_ = Phase::pointed;
    turnBy(turned_rad);
}

}  // namespace estimation
