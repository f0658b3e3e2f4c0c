// SPDX-License-Identifier: GPL-3.0-or-later
// TAKEOFF: takes off the way it points when it is armed, as a mission does, and circles the place
// where it has reached TKOFF_ALT. In the air it circles at once, at that height or a greater one.
#include "firmware/modes/takeoff.hpp"

#include <math.h>

#include "core/file_state.hpp"
#include "core/maths.hpp"
#include "firmware/guidance/demand.hpp"
#include "firmware/modes/circling.hpp"
#include "firmware/modes/guided.hpp"
#include "firmware/modes/modes.hpp"
#include "firmware/modes/modes_table.hpp"
#include "firmware/modes/sticks.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware/state/vehicle.hpp"
#include "mavlink/messages.hpp"

namespace firmware {
namespace modes {

using namespace state;
using namespace guidance;
using namespace mission;

namespace {

struct Departure {
    bool waits;  // to be armed
};
core::FileState<Departure> departure{};

PathDemand& begin() {
    PathDemand& demand = beginPath();
    if (!vehicle.estimate.flying) demand.path = Path::takeoff;
    return demand;
}

void climbTo(float height_m, float pitch_deg) {
    PathDemand& demand = begin();
    const float now_m = vehicle.estimate.height_m;
    demand.height_m = height_m > now_m ? height_m : now_m;
    demand.takeoff_pitch_rad = core::radians(pitch_deg);
}

bool isHigh() {
    constexpr float kNear_m = 1;  // the demanded height is approached ever more slowly
    return vehicle.estimate.height_m >= vehicle.demand.height_m - kNear_m;
}

}  // namespace

EntryResult startTakeoff() {
    const EntryResult entry = startLoiter();
    if (entry == EntryResult::entered)
        climbTo(core::real(parameters.takeoff_height_m),
                core::real(parameters.takeoff_level_pitch_deg));
    departure.waits = !vehicle.armed;
    return entry;
}

void runTakeoff() { mixSticks(); }

// Since the mode was chosen it may have been turned, or have landed and been disarmed.
void demandTakeoff() {
    if (!vehicle.armed) {
        departure.waits = true;
    } else if (departure.waits) {
        departure.waits = false;
        begin();
    } else if (vehicle.demand.path == Path::takeoff && isHigh()) {
        demandCircle(vehicle.estimate.position, vehicle.demand.height_m);
    }
}

MissionResult takeOff(MissionItem& item) {
    constexpr float kSteepest_deg = 60;
    float pitch_deg = core::real(parameters.takeoff_level_pitch_deg);
    if (item.param1 > 0) pitch_deg = item.param1;
    if (pitch_deg > kSteepest_deg) return MissionResult::invalid_param1;
    const bool given = !isnan(item.z) && item.z != 0;
    item.command = mavlink::MavCmd::nav_waypoint;
    const MissionResult result = given ? aboveHome(item) : MissionResult::accepted;
    if (result != MissionResult::accepted) return result;
    if (!requestMode(Mode::takeoff, ModeReason::ground)) return MissionResult::error;
    climbTo(given ? item.z : core::real(parameters.takeoff_height_m), pitch_deg);
    return result;
}

}  // namespace modes
}  // namespace firmware
