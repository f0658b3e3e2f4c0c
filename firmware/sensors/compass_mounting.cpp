// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/sensors/compass_mounting.hpp"

#include <math.h>

#include "board.hpp"
#include "core/file_state.hpp"
#include "core/fixed.hpp"
#include "core/maths.hpp"
#include "firmware/notify/status_text.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace sensors {

using namespace notify;
using namespace state;

namespace {

constexpr float kLeast_mps = 6;                  // four times walking speed
constexpr core::Ratio kLevel(0.17f);             // sine of 10 degrees
constexpr int16_t kClearly = 42 * 65536L / 360;  // beside a quarter of a turn
constexpr uint8_t kFlat = 16, kUpsideDown = 8;   // of ArduPilot's numbers: 8 and on are rolled over
constexpr uint8_t kQuarters = 3, kThere = 1 << 2, kBack = 1 << 5, kAllLooks = 7;
constexpr uint8_t kDecided = 3;  // turns without a vote: no look leaves it so

// Of courses north and south, east and west: in the lower two bits the quarter turns that are
// missing, then how many looks in a row have found it so, there and back. When it is decided:
// kDecided and the orientation.
struct Mounting {
    uint8_t votes[2];
};
core::FileState<Mounting> mounting{};

bool decided() { return mounting.votes[0] == kDecided; }

bool fastAndLevel() {
    const int16_t roll = vehicle.attitude.sin_roll.raw;
    return vehicle.gps.ground_speed_mps > kLeast_mps && roll < kLevel.raw && roll > -kLevel.raw;
}

void decide(uint8_t quarters) {
    const uint8_t set = compassMounting();
    if (set >= kFlat) return;
    const uint8_t yaw = static_cast<uint8_t>(set + 2 * quarters) % kUpsideDown;
    mounting.votes[1] = static_cast<uint8_t>((set & kUpsideDown) | yaw);
    mounting.votes[0] = kDecided;
    sendStatusText(Severity::critical, STATUS_TEXT("Compass turned: COMPASS_ORIENT should be #"),
                   mounting.votes[1]);
}

// True, a whole turn being 65536. The wings are level: of the tilt there is the pitch alone.
uint16_t heading() {
    const core::Vector3& field_mg = vehicle.compass.field_mg;
    const float forward_mg = field_mg.x + field_mg.z * vehicle.attitude.sin_pitch.toFloat();
    const float heading_rad = atan2f(-field_mg.y, forward_mg) + parameters.compass_declination_rad;
    return static_cast<uint16_t>(core::Angle(heading_rad).raw);
}

uint16_t course() {
    constexpr uint8_t kPer128_cd = 233;  // 65536 to 36000
    return static_cast<uint16_t>(uint32_t{vehicle.gps.course_cd} * kPer128_cd >> 7);
}

}  // namespace

uint8_t compassMounting() {
    if (parameters.compass_external == 0) return board::kCompassUpsideDown ? kUpsideDown : 0;
    return static_cast<uint8_t>(parameters.compass_orientation);
}

void watchCompassMounting() {
    if (decided() || !fastAndLevel()) return;
    constexpr uint16_t kHalfQuarter = 0x2000;
    const uint16_t over = course(), beside = heading() - over + kHalfQuarter;
    const int16_t off = static_cast<int16_t>((beside & 0x3FFF) - kHalfQuarter);
    if (off > kClearly || off < -kClearly) return;
    const uint8_t upper = static_cast<uint8_t>((over + kHalfQuarter) >> 8);
    const uint8_t quarters = static_cast<uint8_t>(beside >> 8) / 64;
    const uint8_t one = (upper & 0x80) != 0 ? kBack : kThere;
    const uint8_t most = static_cast<uint8_t>(kAllLooks * one);
    uint8_t& votes = mounting.votes[(upper & 0x40) != 0];
    uint8_t now = votes;
    if ((now & kQuarters) != quarters) now = quarters;
    if ((now & most) != most) now = static_cast<uint8_t>(now + one);
    votes = now;
    if (quarters != 0 && (now | kQuarters) == 0xFF) decide(quarters);
}

bool compassTurned() {
    return decided() && parameters.compass_use != 0 && compassMounting() != compassOrientation();
}

uint8_t compassOrientation() { return mounting.votes[1]; }

}  // namespace sensors
}  // namespace firmware
