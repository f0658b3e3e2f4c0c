// SPDX-License-Identifier: GPL-3.0-or-later
// What the flights along a path have in common: how the airplane moves, the leg, and what is told
// of it in vehicle.progress.
#pragma once
#include "navigation/l1.hpp"

namespace firmware {

navigation::Motion motion();

// Flies demand.from to demand.to but for the bank; `learning`: the bank's trim, too.
navigation::Lateral followDemandedLeg(const navigation::Motion& now, bool learning);
float along_mps(const navigation::Lateral& lateral, const navigation::Motion& now);

void tellLateral(const navigation::Lateral& lateral);
void tellBearings();  // 10 Hz

}  // namespace firmware
