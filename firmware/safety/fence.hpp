// SPDX-License-Identifier: GPL-3.0-or-later
// The fence: a polygon the airplane must not leave, limits of its height, and what happens when it
// does (FENCE_ACTION). docs/fence.md says it for pilots.
#pragma once
#include <stdint.h>

#include "mavlink/messages.hpp"

namespace firmware {
namespace safety {

using Breach = mavlink::FenceBreach;

void fenceStart();
void runFence();  // 5 Hz

bool fenceTurnsBack();  // FENCE_ACTION asks for it
bool fenceTurnBack();   // what the failsafes do when it is broken; false: not yet

// As DO_FENCE_ENABLE gives it: 0 off, 1 on, 2 the floor off. False: not one of them, or there is no
// fence to switch on.
bool fenceEnable(uint16_t how);

bool fenceThere();  // one is stored
bool fenceOn();     // and is watched
bool fenceBad();    // it ought to be watched, and is not fit for it

struct FenceReport {
    uint32_t breach_ms;  // the last one
    uint8_t breaches;
    uint8_t breach;  // Breach: as it is now
};
FenceReport fenceReport();

}  // namespace safety
}  // namespace firmware
