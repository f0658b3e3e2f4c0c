// SPDX-License-Identifier: GPL-3.0-or-later
// GUIDED: flies to the place the ground has given and circles it; until one is given, the place
// where it was entered.
#include "firmware/modes/guided.hpp"

#include <math.h>

#include "core/maths.hpp"
#include "firmware/control/attitude_demand.hpp"
#include "firmware/guidance/demand.hpp"
#include "firmware/mission/item.hpp"
#include "firmware/mission/speed.hpp"
#include "firmware/modes/circling.hpp"
#include "firmware/modes/modes.hpp"
#include "firmware/modes/modes_table.hpp"
#include "firmware/modes/sticks.hpp"
#include "mavlink/messages.hpp"

namespace firmware {
namespace modes {

using namespace state;
using namespace guidance;
using namespace control;
using namespace mission;

namespace {

constexpr MissionResult kRadiusWrong =
    static_cast<MissionResult>(static_cast<uint8_t>(MissionResult::invalid_param1) + 2);

// What is left out stays as it is: as demanded, where that is what is flown. 0, 0 is where we are.
void complete(MissionItem& item) {
    const bool same_place = item.x == INT32_MAX && item.y == INT32_MAX;
    if (same_place || (item.x == 0 && item.y == 0)) {
        const bool stays = same_place && vehicle.mode == Mode::guided;
        const geo::Position& place = stays ? vehicle.demand.to : vehicle.estimate.position;
        item.x = place.latitude_e7;
        item.y = place.longitude_e7;
    }
    if (!isnan(item.z)) return;
    item.z = guidesItself() ? vehicle.demand.height_m : vehicle.estimate.height_m;
    item.frame = mavlink::MavFrame::global_relative_alt;
}

// By the rules of a mission's waypoint: its frames and ranges. z becomes the height above home.
MissionResult understand(MissionItem& item) {
    if (item.command != mavlink::MavCmd::nav_waypoint) return MissionResult::unsupported;
    if (!vehicle.home.set) return MissionResult::error;
    complete(item);
    item.param2 = 0;  // how near is near enough: it circles
    ::mission::Record record;
    EncodeWarnings warnings;
    const MissionResult result = encodeItem(::mission::Set::apm2, {1, 2}, item, record, warnings);
    if (result != MissionResult::accepted) return result;
    const bool relative = (record.options & ::mission::kRelativeAltitude) != 0;
    item.z = core::hundredths(record.p2 - (relative ? 0 : vehicle.home.altitude_cm));
    return result;
}

}  // namespace

EntryResult startGuided() {
    const EntryResult entry = startLoiter();
    if (entry == EntryResult::entered) demandSpeed();
    return entry;
}

void runGuided() {
    runLoiter();
    if (vehicle.fence_throttle) demandThrottle(stickThrottle());
}

MissionResult guideTo(MissionItem& item) {
    const float radius_m = isnan(item.param3) ? 0 : item.param3;
    if (!(radius_m >= 0 && radius_m <= INT16_MAX)) return kRadiusWrong;
    const MissionResult result = understand(item);
    if (result != MissionResult::accepted) return result;
    if (!requestMode(Mode::guided, ModeReason::ground)) return MissionResult::error;
    demandCircle({item.x, item.y}, item.z);
    demandSpeed();
    if (core::isZero(radius_m)) return result;
    PathDemand& demand = changePath();
    demand.radius_m = radius_m;
    demand.counter_clockwise = item.param4 == 1;
    return result;
}

// To a place so far away that it is not reached by mistake.
bool guideAlong(float course_rad) {
    constexpr float kFar_m = 30000;
    if (vehicle.mode != Mode::guided || !vehicle.estimate.known) return false;
    PathDemand& demand = beginPath();
    demand.path = Path::leg;
    demand.from = vehicle.estimate.position;
    demand.to = geo::moved(demand.from, {kFar_m * cosf(course_rad), kFar_m * sinf(course_rad)});
    demand.sloped = false;
    return true;
}

MissionResult aboveHome(MissionItem& item) {
    item.x = item.y = 0;
    return understand(item);
}

MissionResult guideToHeight(MissionItem& item) {
    const MissionResult result = aboveHome(item);
    if (result != MissionResult::accepted) return result;
    if (!guidesItself() || stickSetsSpeed() || vehicle.mode == Mode::automatic)
        return MissionResult::error;
    PathDemand& demand = changePath();
    demand.height_m = item.z;
    demand.sloped = false;
    demand.climb_rate_mps = 0;
    return result;
}

}  // namespace modes
}  // namespace firmware
