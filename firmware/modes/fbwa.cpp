// SPDX-License-Identifier: GPL-3.0-or-later
// FBWA: the sticks demand bank and pitch within the limits; the throttle is the pilot's.
#include "core/maths.hpp"
#include "firmware/control/attitude_demand.hpp"
#include "firmware/modes/modes_table.hpp"
#include "firmware/modes/sticks.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace modes {

using namespace state;
using namespace control;

EntryResult startFbwa() { return EntryResult::entered; }

void runFbwa() {
    demandRoll(stickRoll_rad());
    demandPitch(stickPitch_rad());
    demandThrottle(stickThrottle());
    // nose down as the throttle closes, so that the speed stays (STAB_PITCH_DOWN)
    const int8_t cruise_pct = core::limit<int8_t>(parameters.cruise_throttle_pct, 1, 100);
    const int8_t closed_pct = cruise_pct - vehicle.radio.throttle_pct;
    if (closed_pct > 0) {
        const core::Angle down_rad(core::radians(parameters.pitch_down_deg) *
                                   core::real(closed_pct) / core::real(cruise_pct));
        demandPitch(core::between(down_rad, vehicle.pitch_demand_rad));
    }
    if (vehicle.failsafe_glides) {
        demandRoll(core::Angle::fromRaw(0));
        demandThrottle(core::Ratio::fromRaw(0));
    }
}

}  // namespace modes
}  // namespace firmware
