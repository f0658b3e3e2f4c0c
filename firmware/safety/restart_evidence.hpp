// SPDX-License-Identifier: GPL-3.0-or-later
// After a loss of power nobody knows how long it lasted: an airplane that fell, whose battery is
// plugged in again beside a hand at the propeller, has the same records as one that flies on. Only
// a sensor that measures anew can say which: docs/restart.md.
#pragma once
#include <stdint.h>

namespace firmware {
namespace safety {

// By the airspeed sensor where there is one: a speed to fly with. Else by the barometer's own
// reading since the start: more than 10 m above home, whose height above the barometer's zero is
// `home_height_m`.
bool measuredInTheAir(float home_height_m);

constexpr uint16_t kEvidenceComesWithin_ms = 2000;  // since the start; after that it stays disarmed

}  // namespace safety
}  // namespace firmware
