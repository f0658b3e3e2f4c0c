// SPDX-License-Identifier: GPL-3.0-or-later
// Where modes and NAV commands put in what guidance has to fly: they change it in place.
#pragma once
#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace guidance {

// To become another path: guidance begins it in its next run, what it reports until then is of the
// old one. What is not set stays as it was.
state::PathDemand& beginPath();
// To be the same path at another height, speed or place: guidance goes on with it.
state::PathDemand& changePath();

}  // namespace guidance
}  // namespace firmware
