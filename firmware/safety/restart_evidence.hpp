// SPDX-License-Identifier: GPL-3.0-or-later
// After a loss of power nobody knows how long it lasted: an airplane that fell, whose battery is
// plugged in again beside a hand at the propeller, has the same records as one that flies on. Only
// a sensor that measures anew can say which: docs/restart.md.
#pragma once
#include <stdint.h>

namespace firmware {
namespace safety {

// By the barometer's own reading since the start, of which `home_height_m` is home's: more than 30
// m above or below home, where nobody can be beside it within the seconds that memory survives. By
// the airspeed sensor where there is one: a speed to fly with; else more than 10 m above or below.
bool measuredInTheAir(float home_height_m);

// 50 Hz, while it is waited for: none has come, and it stays disarmed. 2 s after the start, and one
// after the first reading of either sensor, for which it waits 30 s.
bool evidenceIsOver();

}  // namespace safety
}  // namespace firmware
