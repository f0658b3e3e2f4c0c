// SPDX-License-Identifier: GPL-3.0-or-later
// RTL: home, and circles there at ALT_HOLD_RTL above it (negative: at the height it has); or to a
// rally point at its own height. With RTL_AUTOLAND it gives way to the landing of the mission.
#include <math.h>

#include "core/convert.hpp"
#include "core/file_state.hpp"
#include "firmware/mission/mission.hpp"
#include "firmware/mission/rally.hpp"
#include "firmware/modes/circling.hpp"
#include "firmware/modes/modes_table.hpp"
#include "firmware/modes/sticks.hpp"
#include "firmware/notify/status_text.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace modes {

using namespace notify;
using namespace state;
using namespace mission;

namespace {

struct WayHome {
    bool lands;  // sooner or later
};
core::FileState<WayHome> way_home{};

bool there() {
    constexpr float kNear_m = 10;
    const auto& demand = vehicle.demand;
    return !demand.new_path && vehicle.progress.captured &&
           fabsf(demand.height_m - vehicle.estimate.height_m) < kNear_m;
}

void land() {
    constexpr int8_t kAtOnce = 2;
    if (parameters.rtl_landing != kAtOnce && !there()) return;
    way_home.lands = false;
    if (!missionLand())
        sendStatusText(Severity::warning, STATUS_TEXT("RTL: the mission has no DO_LAND_START"));
}

}  // namespace

EntryResult startRtl() {
    if (!vehicle.home.set) {
        sendStatusText(Severity::warning, STATUS_TEXT("RTL needs a home"));
        return EntryResult::refused;
    }
    const float height_m = parameters.rtl_height_cm < 0
                               ? vehicle.estimate.height_m
                               : core::hundredths(parameters.rtl_height_cm);
    demandCircle(vehicle.home.position, height_m);
    rallyBegin();
    way_home.lands = parameters.rtl_landing != 0;
    return EntryResult::entered;
}

void runRtl() {
    rallyLook(demandCircle);
    mixSticks();
    if (way_home.lands && vehicle.estimate.flying) land();
}

}  // namespace modes
}  // namespace firmware
