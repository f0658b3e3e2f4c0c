// SPDX-License-Identifier: GPL-3.0-or-later
// What a pilot sets about guidance, each value in the unit of its parameter.
#pragma once
#include <stdint.h>

namespace navigation {

struct LateralSettings {  // NAVL1
    float period_s;       // _PERIOD
    float damping;        // _DAMPING
};

}  // namespace navigation
