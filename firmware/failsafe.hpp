// SPDX-License-Identifier: GPL-3.0-or-later
// What happens when the pilot's radio is lost: a table of transitions between three states.
#pragma once

namespace firmware {

void runFailsafe();  // 10 Hz

}  // namespace firmware
