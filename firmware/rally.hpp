// SPDX-License-Identifier: GPL-3.0-or-later
// Rally points: where RTL goes instead of home when one is nearer, or near enough (RALLY_LIMIT_KM).
#pragma once

namespace firmware {

void rallyFollow();  // 10 Hz: RALLY_TOTAL

void rallyBegin();  // home is demanded; the points are looked at from now on,
void rallyLook();   // one each call, and the best so far is demanded instead

}  // namespace firmware
