// SPDX-License-Identifier: GPL-3.0-or-later
// The one interrupt that runs firmware code: the inertial sensor has a sample ready.
#pragma once

namespace hal {

void imuDataReady();  // defined by the firmware, called with interrupts off; at most 40 us

}  // namespace hal
