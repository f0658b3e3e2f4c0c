// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the motor may turn.
#pragma once
#include <stdint.h>

#include "core/rom.hpp"
#include "firmware/notify/status_text.hpp"

namespace firmware {
namespace safety {

enum class ArmReason : uint8_t { pilot, ground, landed, failsafe };

// Arms after every check of ARMING_CHECK has passed (force: without them); false and the reason
// reported otherwise. Sets home.
bool arm(ArmReason reason, bool force);
// The flight before the restart was an armed one. Home and checks are of that flight.
void armAfterRestart();
// False in flight unless forced.
bool disarm(ArmReason reason, bool force);
// In flight too, and nothing arms until the board is restarted.
void disarmForGood();

// The first check that fails, as a text to the pilot; false: none does.
bool reportPrearmFailure(notify::Severity severity);

// 10 Hz: arming and disarming by rudder, reports why arming would fail, has home refined, disarms
// after landing
void runArming();

}  // namespace safety
}  // namespace firmware
