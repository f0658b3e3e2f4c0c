// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/gcs/targets.hpp"

#include <math.h>
#include <stddef.h>

#include "core/file_state.hpp"
#include "firmware/gcs/link.hpp"
#include "firmware/modes/guided.hpp"
#include "firmware/notify/status_text.hpp"
#include "firmware/state/vehicle.hpp"
#include "hal/clock.hpp"

namespace firmware {
namespace gcs {

using namespace notify;
using namespace state;
using namespace mission;
using namespace modes;

namespace {

using mavlink::MavFrame;
using Target = mavlink::SetPositionTargetGlobalInt;
static_assert(offsetof(Target, alt) == offsetof(mavlink::SetPositionTargetLocalNed, z) &&
                  offsetof(Target, type_mask) ==
                      offsetof(mavlink::SetPositionTargetLocalNed, type_mask) &&
                  sizeof(Target) == sizeof(mavlink::SetPositionTargetLocalNed),
              "one is read as the other");

// POSITION_TARGET_TYPEMASK: what the target does not say.
constexpr uint16_t kNoPlace = 3, kNoHeight = 4;

struct Refusal {
    uint8_t at;  // 4.096 s
};
core::FileState<Refusal> refusal{};

// QGroundControl's change of altitude: from the height that is flown, down. The place stays.
bool fromOffset(Target& target) {
    if (target.coordinate_frame != MavFrame::local_offset_ned || target.lat_int != 0 ||
        target.lon_int != 0)
        return false;
    target.coordinate_frame = MavFrame::global_relative_alt;
    target.type_mask = kNoPlace;
    target.alt = vehicle.demand.height_m - target.alt;
    return true;
}

MissionResult flyTo(const Target& target) {
    const bool stays = (target.type_mask & kNoPlace) != 0;
    const bool level = (target.type_mask & kNoHeight) != 0;
    if (stays && level) return MissionResult::unsupported;
    MissionItem item = {};
    item.command = mavlink::MavCmd::nav_waypoint;
    item.frame = target.coordinate_frame;
    item.x = target.lat_int;
    item.y = target.lon_int;
    item.z = level ? NAN : target.alt;
    return stays ? guideToHeight(item) : guideTo(item);
}

}  // namespace

bool onPositionTarget(Link& link, const mavlink::Frame& frame) {
    auto target = frame.read<Target>();
    const bool local = frame.id == mavlink::Wire<mavlink::SetPositionTargetLocalNed>::id;
    const bool obeyed = vehicle.mode == Mode::guided && (!local || fromOffset(target)) &&
                        flyTo(target) == MissionResult::accepted;
    return obeyed || refuseTarget(link, frame);
}

bool refuseTarget(Link&, const mavlink::Frame& frame) {
    const uint8_t now = static_cast<uint8_t>(1 + (hal::now_ms() >> 12));
    if (now != refusal.at)
        sendStatusText(Severity::warning, STATUS_TEXT("Message # refused"), frame.id);
    refusal.at = now;
    return true;
}

}  // namespace gcs
}  // namespace firmware
