// SPDX-License-Identifier: GPL-3.0-or-later
// Upside down: where a mission orders it, until the mode changes, or while the pilot's switch says
// so (INVERTEDFLT_CH). Only in the air, in modes that hold an attitude, never in a take-off or a
// landing; vehicle.inverted is what is flown.
#pragma once

namespace firmware {
namespace control {

void requestInverted(bool on);
void runInverted();  // 10 Hz

}  // namespace control
}  // namespace firmware
