// SPDX-License-Identifier: GPL-3.0-or-later
// From the demanded bank and pitch to the surfaces.
#pragma once

namespace firmware {

struct Surfaces {  // -1..1: right wing down, nose up, nose right
    float aileron, elevator, rudder;
    float throttle;  // 0..1
};
extern Surfaces surfaces;

void runAttitudeControl();  // 100 Hz, after the mode and before runOutputs

}  // namespace firmware
