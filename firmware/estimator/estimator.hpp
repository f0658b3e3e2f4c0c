// SPDX-License-Identifier: GPL-3.0-or-later
// Joins the sensors to what is flown by: attitude, place, height, speed, wind.
#pragma once
#include "core/maths.hpp"
#include "firmware/state/restart_record.hpp"

namespace firmware {
namespace estimator {

// Rows of the schedule. They do nothing until the gyros' zero is known.
void runAttitude();           // 100 Hz, after the inertial sensor: roll, pitch and rates
void alignAttitude();         // 10 Hz: the first matrix
void rotateDcm();             // 50 Hz: all angles
void orthonormalizeMatrix();  // 10 Hz
void pointYaw();              // 10 Hz
void gatherPressure();        // 100 Hz, after the barometer
void propagateMotion();       // 25 Hz: acceleration over ground carries place, speed and height on
void fusePressure();          // 20 Hz: the barometer's mean to the height
void publishSpeeds();         // 20 Hz: ground speed, course, airspeed
void reckonPosition();        // 10 Hz: without fixes the nose and the wind show where it goes
void checkEstimate();         // 10 Hz: height and velocity are numbers, or begin again
// 10 Hz. Flying: armed, and fast enough for half a second; standing for three seconds: slow over
// the ground, and slow through the air or near the height of home without a motion.
void updateFlying();
void fuseFixAttitude();  // 20 Hz, as the next three: the newest fix to the attitude
void fuseFixPosition();
void fuseFixWind();
void fuseFixHeight();
void learnGpsDelay();  // 20 Hz, after the attitude: by how much fixes are older than GPS_TYPE says
void fuseCompass();    // 5 Hz
void fuseAirspeed();   // 5 Hz: holds the attitude while there are no fixes

core::Vector3 gyroDrift_rads();  // learnt in flight, on top of the calibration

// How far what was measured last is off the estimate, as a share of the limit beyond which it is
// refused. 0 where nothing is compared.
struct TestRatios {
    float position;  // of a fix
    float height;    // of the barometer, or of the receiver in its place
    float compass;
    float airspeed;
};
TestRatios testRatios();

// For flying on after a restart: what is known, and the same again `lost_s` later, when the
// airplane has turned on.
void saveEstimate(state::SlowRecord& to);
void saveEstimate(state::FastRecord& to);
void resumeEstimate(const state::SlowRecord& slow, const state::FastRecord& fast,
                    const core::Vector3& turned_rad, float lost_s);

// From which an airplane is taken for flying: 75 % of ARSPD_FBW_MIN, but 10 m/s at most, so that no
// parameter makes one in the air count as standing.
float flyingAirspeed_mps();
// The slower of the estimate and the last fix, m/s: accelerometers gone mad move the estimate
// alone, a fix that hops moves it little. Not while the position is reckoned.
float measuredGroundSpeed_mps();
bool slowThroughTheAir();  // slower than that, by the sensor or the known wind; false: not known

// It has not jumped lately, neither against its own last readings nor by more than 20 m against the
// receiver's height.
bool barometerSteady();
void zeroHeight();             // the airplane stands at height 0 now
float aboveField_m();          // over where it was armed; home may be set in the air
bool mayRoll();                // on its wheels: at that height it neither climbs nor sinks
void shiftHeight(float by_m);  // added to every height from now on

}  // namespace estimator
}  // namespace firmware
