// SPDX-License-Identifier: GPL-3.0-or-later
// The sensors of the board: each run function steps its driver and fills its section of vehicle.
// None of them waits for its device.
#pragma once
#include <stdint.h>

#include "core/maths.hpp"
#include "drivers/gps_fix.hpp"
#include "estimation/motion.hpp"
#include "firmware/state/restart_record.hpp"
#include "geo/position.hpp"

namespace firmware {
namespace sensors {

// First of all: which board this is. Where it is another than the one this firmware is made for the
// pins lead elsewhere, a servo's to a motor: nothing may be put out.
void findBoard();
bool wrongBoard();

void startSensors();

void saveHangTurn(state::HangDeltaAngle& to);
core::Vector3 hangTurn_rad(const state::HangDeltaAngle& turn);

// The gyros' zero, in a sample period; and how to go on with one from before a restart, without
// bringing up a sensor that is up already.
void saveGyroZero(estimation::SavedDeltaAngle (&to_rad)[3]);
void resumeInertial(const estimation::SavedDeltaAngle (&gyro_zero_rad)[3]);
// After a restart in the air: the zero that was measured before it.
void resumeBarometer(float ground_pressure_pa, float ground_temperature_c);
void resumeAirspeed(float offset_v);
float airspeedOffset_v();  // of the sensor with no wind on it

void runInertial();          // every frame, first
void runInertialSettings();  // 5 Hz: scales, offsets and trim, when a parameter has changed
void runBarometer();         // every frame
void runCompass();
void runCompassLearning();  // 10 Hz, behind runCompass: a pair takes a quarter of a millisecond
void runDeclination();      // 1 Hz
// The table's for that place into COMPASS_DEC, while COMPASS_AUTODEC is 1.
void setDeclination(const geo::Position& place);
void runGps();
bool gpsWaits();  // so much that runGps should not be kept waiting for the next frame
void runAirspeed();
// Brings vehicle.airspeed.speed_mps up to the pressure taken last: before each use, since the
// square root would take 0.1 % of the processor at the sensor's own 50 Hz.
void workOutAirspeed();
// ARSPD_RATIO, while ARSPD_AUTOCAL is 1 and it lies within 20 % of a usual sensor's. `missing`: the
// share of the speed that the sensor shows too little, for `dt_s`. Stored when disarmed.
void learnAirspeedRatio(float missing, float dt_s);
void saveAirspeedRatio();
float airspeedPressure_pa();  // low-passed, zero removed
void runBattery();

const drivers::GpsFix& gpsFix();  // the newest as it came: its time and week

constexpr uint8_t kSamplesPerFrame = 2;
uint8_t inertialSamplesWaiting();
uint16_t inertialErrors();
// What the accelerometers measure beside the flight, as ArduPilot's: within 6 % of the root of the
// mean square of 0.1 s.
uint16_t vibration_cmss(uint8_t axis);
uint8_t accelerometerClips();  // samples at the end of their range, of those looked at

// Begins the zeroing of gyros, or of barometer and airspeed, again; the airplane must stand still.
void calibrateGyros();
void calibratePressures();
// What the accelerometers read while the gyros' zero was found, nothing taken off.
core::Vector3 restForce_mss();

}  // namespace sensors
}  // namespace firmware
