// SPDX-License-Identifier: GPL-3.0-or-later
// Between the files of this folder only: what the rows of the tables ask, and do.
#pragma once
#include "firmware/safety/failsafe_table.hpp"

namespace firmware {
namespace safety {

void watchCauses();  // 10 Hz, before any is asked

bool inertialLost();
bool fenceBroken();
bool batteryLow();
bool blownBack();
bool radioLostLong();
bool groundLostLong();
bool radioLost();
bool positionLost();
bool heightLost();
bool gpsLost();
bool gpsJumps();
bool barometerLost();
bool airspeedLost();
bool compassLost();

}  // namespace safety
}  // namespace firmware
