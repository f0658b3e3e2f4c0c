// SPDX-License-Identifier: GPL-3.0-or-later
// One calibration at a time: what each keeps stands in the same place.
#pragma once
#include "firmware/calibration/accelerometers.hpp"
#include "firmware/calibration/compass.hpp"

namespace firmware {

union CalibrationScratch {
    SideForces sides;
    CompassTurns turns;
};
extern CalibrationScratch scratch;

}  // namespace firmware
