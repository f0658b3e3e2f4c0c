// SPDX-License-Identifier: GPL-3.0-or-later
// AUTO: flies the mission; when none is left, gives way to RTL, or stands after a landing.
#include "firmware/mission/mission.hpp"
#include "firmware/modes/modes_table.hpp"
#include "firmware/modes/sticks.hpp"
#include "firmware/notify/status_text.hpp"
#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace modes {

using namespace notify;
using namespace state;
using namespace mission;

EntryResult startAuto() {
    StatusText why_not;
    if (missionEnter(why_not)) return EntryResult::entered;
    sendStatusText(Severity::warning, why_not);
    // in the air an empty mission means home; on the ground nothing changes
    return vehicle.armed && vehicle.estimate.flying ? EntryResult::home_instead
                                                    : EntryResult::refused;
}

void runAuto() { mixSticks(); }

void stopAuto() { missionLeave(); }

}  // namespace modes
}  // namespace firmware
