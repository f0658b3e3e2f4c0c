// SPDX-License-Identifier: GPL-3.0-or-later
// After a loss of power nobody knows how long it lasted: an airplane that fell, whose battery is
// plugged in again beside a hand at the propeller, has the same records as one that flies on. Only
// a sensor that measures anew can say which: docs/restart.md.
#pragma once
#include <stdint.h>

namespace firmware {
namespace safety {

// By the barometer's own reading since the start, of which `field_height_m` is that of where it was
// armed: more than 30 m above or below that, where nobody can be beside it within the seconds that
// memory survives. By the airspeed sensor where there is one: a speed to fly with; else more than
// 10 m above or below.
bool measuredInTheAir(float field_height_m);

// 50 Hz, while it is waited for: 2 s after the start, and one after the first reading of either
// sensor, for which it waits 30 s. Later a gust into the tube is no evidence.
bool sensorsHadTheirTime();

// As fast over the ground as one flies, in the receiver's sixth fix or later, while the estimator
// accepts its fixes. It starts more slowly than the board does: six fixes are its time, or 30 s.
bool receiverSeesItMove();
bool receiverRefused();  // by the estimator, since its second fix: no evidence any more
bool receiverHadItsTime();

}  // namespace safety
}  // namespace firmware
