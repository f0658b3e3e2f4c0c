// SPDX-License-Identifier: GPL-3.0-or-later
// RTL: home, and circles there at ALT_HOLD_RTL above it (negative: at the height it has); or to a
// rally point at its own height.
#include "firmware/modes/circling.hpp"
#include "firmware/modes/modes_table.hpp"
#include "firmware/modes/sticks.hpp"
#include "firmware/parameters.hpp"
#include "firmware/rally.hpp"
#include "firmware/telemetry/text.hpp"
#include "firmware/vehicle.hpp"

namespace firmware {

Entry startRtl() {
    if (!vehicle.home.set) {
        tell(Severity::warning, ROM_TEXT("RTL needs a home"));
        return Entry::refused;
    }
    const float height_m =
        parameters.rtl_height_cm < 0 ? vehicle.estimate.height_m : parameters.rtl_height_cm * 0.01f;
    demandCircle(vehicle.home.position, height_m);
    rallyBegin();
    return Entry::entered;
}

void runRtl() {
    rallyLook(demandCircle);
    mixSticks();
}

}  // namespace firmware
