// SPDX-License-Identifier: GPL-3.0-or-later
// Where modes and NAV commands put in what guidance has to fly. Each takes a copy of
// vehicle.demand, changes it and hands it in.
#pragma once
#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace guidance {

// Another path: guidance begins it in its next run, what it reports until then is of the old one.
void demandPath(const state::PathDemand& demand);
// The same path, at another height, speed or place: guidance goes on with it.
void changeDemand(const state::PathDemand& demand);

}  // namespace guidance
}  // namespace firmware
