// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the one binary message of MediaTek receivers with the DIYDrones firmware 1.6 or 1.9, which
// has everything but a vertical velocity.
#pragma once
#include "drivers/gps_epoch.hpp"

namespace drivers {

// A whole frame with a right checksum. True: epoch.fix is new and whole.
bool readMtk16(const uint8_t* frame, GpsEpoch& epoch);
bool readMtk19(const uint8_t* frame, GpsEpoch& epoch);

}  // namespace drivers
