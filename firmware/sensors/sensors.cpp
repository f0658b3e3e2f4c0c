// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/sensors/sensors.hpp"

#include "firmware/sensors/devices.hpp"
#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace sensors {

using namespace state;

void startSensors() {
    // the inertial sensor's select must be high before the barometer's is touched
    startInertial();
    startBarometer();
    startCompass();
    startGps();
    zeroAirspeed();
}

void calibratePressures() {
    if (vehicle.armed) return;
    zeroBarometer();
    zeroAirspeed();
}

}  // namespace sensors
}  // namespace firmware
