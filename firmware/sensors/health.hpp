// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a sensor can be trusted in flight: silent (no reading for too long), stuck (none that
// differs), noisy (a value too far from the one before) or nonsense (outside what there is, or
// against what the others say). One row of limits a sensor in health.cpp; on the ground no sensor
// is checked here.
#pragma once
#include <stdint.h>

namespace firmware {
namespace sensors {

enum class Sensor : uint8_t { inertial, barometer, airspeed, compass, gps };
constexpr uint8_t kSensors = 5;

void startHealth();

// A reading has come, in any unit that changes when the sensor lives. False: do not use it.
bool acceptReading(Sensor sensor, int16_t reading, bool possible);
// Another of its values has changed, by which it is seen to work.
void reportChange(Sensor sensor);
// Another sensor contradicts it.
void reportInconsistency(Sensor sensor);
bool isFaulty(Sensor sensor);

// The airplane does, about any axis, by more than 0.1 rad/s.
bool turns();

void watchHealth();  // 10 Hz

}  // namespace sensors
}  // namespace firmware
