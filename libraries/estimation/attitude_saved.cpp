// SPDX-License-Identifier: GPL-3.0-or-later
// The attitude over a restart of the program.
#include "estimation/attitude.hpp"

namespace estimation {

constexpr int32_t kRowSteps = Fine::kOne / core::Ratio::kOne;
constexpr float kHalfSettled = 0.9f;  // a restart leaves an error of degrees, not of tens

void Attitude::save(SavedAttitude& pose) const {
    for (uint8_t i = 0; i < 3; ++i) {
        pose.north[i].raw = core::upper(north_.of[i]);
        pose.down[i].raw = core::upper(down_.of[i]);
    }
}

void Attitude::save(SavedBiases& learnt) const {
    for (uint8_t i = 0; i < 3; ++i)
        learnt.bias_rad[i] = SavedDeltaAngle::fromRaw(bias_.of[i] / kSavedDeltaAngleSteps);
    field_.save(learnt.field);
}

void Attitude::resume(const SavedAttitude& pose, const SavedBiases& learnt,
                      const core::Vector3& turned_rad) {
    start();
    for (uint8_t i = 0; i < 3; ++i) {
        north_.of[i] = pose.north[i].raw * kRowSteps;
        down_.of[i] = pose.down[i].raw * kRowSteps;
        bias_.of[i] = learnt.bias_rad[i].raw * kSavedDeltaAngleSteps;
    }
    learnRates({0, 0, 0});
    field_.resume(learnt.field);
    settling_ = kHalfSettled;
    phase_ = Phase::resumed;
    // in parts, each small enough for its axis to stay where it is
    constexpr uint8_t kParts = 8;
    for (uint8_t part = 0; part < kParts; ++part) {
        turnBy(turned_rad * (1.0f / kParts));
        rotateDcm();
        orthonormalize();
    }
}

}  // namespace estimation
