// SPDX-License-Identifier: GPL-3.0-or-later
#include "board.hpp"
#include "core/based.hpp"
#include "core/file_state.hpp"
#include "core/fixed.hpp"
#include "core/maths.hpp"
#include "drivers/hmc5883l.hpp"
#include "drivers/orientation.hpp"
#include "firmware/sensors/compass_learning.hpp"
#include "firmware/sensors/compass_mounting.hpp"
#include "firmware/sensors/devices.hpp"
#include "firmware/sensors/health.hpp"
#include "firmware/sensors/sensors.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware/state/published.hpp"
#include "geo/declination.hpp"
#include "hal/clock.hpp"

namespace firmware {

namespace state {
template <>
struct Publisher<CompassState> : Writable<CompassState> {
    using Writable::state;
};
}  // namespace state

namespace sensors {

using namespace state;

namespace {

constexpr CompassState& published = Publisher<CompassState>::state();

core::FileState<drivers::Hmc5883l> compass{};

struct Reading {
    int16_t unlearnt_mg[3];  // without the offsets
    bool unlearnt;           // it is there
};
core::FileState<Reading> reading{};

// Fifty times a second: a board's own mounting needs no table.
core::Vector3 alongTheAirplane(const core::Vector3& measured) {
    if (parameters.compass_external != 0) return drivers::fromMounting(measured, compassMounting());
    if (board::kCompassUpsideDown) return {measured.x, -measured.y, -measured.z};
    return measured;
}

// The earth's field is 220 to 670 mG; the airplane's own comes on top, or takes off.
bool plausible(const core::Vector3& field_mg) {
    constexpr int32_t kLeast_mg = 100, kMax_mg = 1000;
    int32_t squared = 0;
    for (const float* axis = &field_mg.x; axis <= &field_mg.z; ++axis) {
        const int16_t whole_mg = core::toFixed(*axis, 0);
        squared += core::product(whole_mg, whole_mg);
    }
    const bool possible = squared > kLeast_mg * kLeast_mg && squared < kMax_mg * kMax_mg;
    // as it was read: what the throttle adds and takes off would hide that it is stuck
    return acceptReading(Sensor::compass, compass.sum_mg(), possible);
}

}  // namespace

void startCompass() {
    compass.start();
    noteStoredOffsets();
}

void runCompass() {
    if (!core::based(compass).step(hal::frame_ms())) {
        published.healthy = compass.healthy() && !isFaulty(Sensor::compass);
        return;
    }
    core::Vector3 field_mg = alongTheAirplane(compass.field_mg());
    const float power = motorPower();
    for (uint8_t i = 0; i < 3; ++i) {
        float& axis_mg = (&field_mg.x)[i];
        axis_mg += parameters.compass.motor_mg[i] * power;
        reading.unlearnt_mg[i] = static_cast<int16_t>(core::rounded(axis_mg));
        axis_mg += parameters.compass.offset_mg[i];
    }
    reading.unlearnt = true;
    published.field_mg = field_mg;
    published.accepted = plausible(field_mg);
    ++published.readings;
    published.healthy = compass.healthy() && !isFaulty(Sensor::compass);
}

void runCompassLearning() {
    if (reading.unlearnt) learnCompass(reading.unlearnt_mg);
    reading.unlearnt = false;
    storeLearntCompass();
}

// Into the parameter, where the heading is worked out from; what is stored there stays. In flight,
// where it hardly changes, every second time the row looks how the compass is mounted.
void runDeclination() {
    constexpr uint16_t kEverySecond = 1024;
    if (vehicle.gps.fix != GpsFix::three_d) return;
    if (vehicle.estimate.flying && (hal::frame_ms() & kEverySecond) != 0)
        return watchCompassMounting();
    published.points_down = geo::fieldPointsDown(vehicle.gps.position);
    setDeclination(vehicle.gps.position);
}

void setDeclination(const geo::Position& place) {
    if (parameters.compass_auto_declination == 0) return;
    parameters.compass_declination_rad = core::fromCentidegrees(geo::declination_cd(place));
}

}  // namespace sensors
}  // namespace firmware
