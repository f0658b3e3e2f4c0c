// SPDX-License-Identifier: GPL-3.0-or-later
// What happens when the pilot's radio or the ground station is lost: a table of transitions
// between four states.
#pragma once

namespace firmware {

void runFailsafe();  // 10 Hz

}  // namespace firmware
