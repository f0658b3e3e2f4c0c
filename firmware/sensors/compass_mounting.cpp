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

constexpr float kLeast_mps = 6;                 // four times walking speed
constexpr core::Ratio kLevel(0.17f);            // sine of 10 degrees
constexpr uint8_t kFlat = 16, kUpsideDown = 8;  // of ArduPilot's numbers: 8 and on are rolled over
constexpr uint8_t kLooks = 7;                   // in either direction
constexpr float kLeast_mg = 50;  // half the horizontal field where it is weakest, 70 degrees north

// The field as it shows over the ground, were the nose where the course is: of looks there and
// back, between which neither a field of the airplane's own nor a wind across the way makes a
// difference.
struct Axis {
    int16_t north_mg, east_mg;  // sums
    uint8_t there, back;
};
struct Mounting {
    Axis axes[2];  // courses north and south, east and west
    bool found;
    uint8_t orientation;
};
core::FileState<Mounting> mounting{};

bool fastAndLevel() {
    const int16_t roll = vehicle.attitude.sin_roll.raw;
    return vehicle.gps.ground_speed_mps > kLeast_mps && roll < kLevel.raw && roll > -kLevel.raw;
}

// The wings are level: of the tilt there is the pitch alone.
void addLook(Axis& axis) {
    const core::Vector3& field_mg = vehicle.compass.field_mg;
    const float per_mps = core::inverse(vehicle.gps.ground_speed_mps);
    const float north = vehicle.gps.velocity_mps.x * per_mps;
    const float east = vehicle.gps.velocity_mps.y * per_mps;
    const float ahead_mg = field_mg.x + field_mg.z * vehicle.attitude.sin_pitch.toFloat();
    axis.north_mg += static_cast<int16_t>(ahead_mg * north - field_mg.y * east);
    axis.east_mg += static_cast<int16_t>(ahead_mg * east + field_mg.y * north);
}

bool complete(const Axis& axis) { return axis.there + axis.back == 2 * kLooks; }

// Quarter turns to the right by which the module is mounted beside what is set.
uint8_t missingQuarters(const Axis& axis) {
    constexpr float kSum_mg = kLeast_mg * 2 * kLooks;
    const float north_mg = core::real(axis.north_mg), east_mg = core::real(axis.east_mg);
    if (core::squaredLength(north_mg, east_mg) < kSum_mg * kSum_mg) return 0;
    const core::Angle turned(parameters.compass_declination_rad - atan2f(east_mg, north_mg));
    return static_cast<uint8_t>(static_cast<uint16_t>(turned.raw + 0x2000) >> 14);
}

void report(uint8_t quarters) {
    const uint8_t set = compassMounting();
    if (set >= kFlat) return;
    const uint8_t yaw = static_cast<uint8_t>(set + 2 * quarters) % kUpsideDown;
    mounting.orientation = static_cast<uint8_t>((set & kUpsideDown) | yaw);
    mounting.found = true;
    sendStatusText(Severity::critical, STATUS_TEXT("Compass turned: COMPASS_ORIENT should be #"),
                   mounting.orientation);
}

void evaluate(Axis& axis) {
    const uint8_t quarters = missingQuarters(axis);
    axis = {};
    if (quarters != 0) report(quarters);
}

}  // namespace

uint8_t compassMounting() {
    if (parameters.compass_external == 0) return board::kCompassUpsideDown ? kUpsideDown : 0;
    return static_cast<uint8_t>(parameters.compass_orientation);
}

// Not evaluated in the run that adds the last look: either takes its time. Readings that are not
// accepted would be too large for the sums.
void watchCompassMounting() {
    if (mounting.found || !vehicle.compass.accepted || !fastAndLevel()) return;
    for (Axis& axis : mounting.axes)
        if (complete(axis)) return evaluate(axis);
    constexpr uint16_t kQuarter_cd = 9000;
    const uint16_t beside_cd = vehicle.gps.course_cd + kQuarter_cd / 2;
    const uint8_t sector = static_cast<uint8_t>(beside_cd / kQuarter_cd);
    Axis& axis = mounting.axes[sector & 1];
    uint8_t& looks = (sector & 2) != 0 ? axis.back : axis.there;
    if (looks == kLooks) return;
    ++looks;
    addLook(axis);
}

bool compassTurned() {
    return mounting.found && parameters.compass_use != 0 &&
           compassMounting() != compassOrientation();
}

uint8_t compassOrientation() { return mounting.orientation; }

}  // namespace sensors
}  // namespace firmware
