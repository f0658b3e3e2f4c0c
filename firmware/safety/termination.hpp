// SPDX-License-Identifier: GPL-3.0-or-later
// Ends a flight for good, as ArduPlane's AFS_TERM_ACTION 42: motor off, elevator, ailerons and
// rudder at their ends, so that the airplane comes down steeply where it is. Neither the pilot nor
// the ground takes it back: no mode is entered and nothing arms until the board is restarted.
#pragma once

namespace firmware {
namespace safety {

// False: AFS_TERM_ACTION does not allow it; reported. Works on the ground too.
bool terminateFlight();

}  // namespace safety
}  // namespace firmware
