// SPDX-License-Identifier: GPL-3.0-or-later
// Which of ArduPlane's modes leave what to the pilot.
#pragma once
#include <cstdint>

namespace simulator::invariants {

enum Mode : uint32_t {
    kManual = 0,
    kStabilize = 2,
    kTraining = 3,
    kAcro = 4,
    kFbwa = 5,
    kAutotune = 8,
    kAuto = 10,
    kTakeoff = 13,
    kGuided = 15,
    kInitialising = 16
};

inline bool pilotHasTheThrottle(uint32_t mode) {
    return mode == kManual || mode == kStabilize || mode == kTraining || mode == kAcro ||
           mode == kFbwa || mode == kAutotune;
}
// The sticks move surfaces, or demand rates, without limits of attitude.
inline bool pilotHasTheSurfaces(uint32_t mode) {
    return mode == kManual || mode == kTraining || mode == kAcro;
}
inline bool takesOffWhenOrdered(uint32_t mode) {
    return mode == kAuto || mode == kTakeoff || mode == kGuided;
}

}  // namespace simulator::invariants
