// SPDX-License-Identifier: GPL-3.0-or-later
// The one interrupt that runs firmware code: the inertial sensor has a sample ready.
#pragma once

namespace hal {

// Defined by the firmware, called with interrupts off; at most 40 us. True: work waits.
bool imuDataReady();

}  // namespace hal
