// SPDX-License-Identifier: GPL-3.0-or-later
// From the demanded bank and pitch to the surfaces.
#pragma once
#include "core/fixed.hpp"

namespace firmware {
namespace control {

struct Surfaces {  // -1..1: right wing down, nose up, nose right
    core::Ratio aileron, elevator, rudder;
    core::Ratio throttle;  // 0..1
};
extern Surfaces surfaces;

void runAttitudeControl();  // 100 Hz, after the mode and before runOutputs

}  // namespace control
}  // namespace firmware
