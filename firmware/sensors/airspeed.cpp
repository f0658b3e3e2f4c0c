// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivers/airspeed.hpp"

#include "firmware/parameters.hpp"
#include "firmware/sensors/devices.hpp"
#include "firmware/sensors/sensors.hpp"
#include "firmware/vehicle.hpp"
#include "hal/analog.hpp"
#include "hal/clock.hpp"

namespace firmware {
namespace {

drivers::Airspeed pitot;
uint32_t updated_us;

}  // namespace

void zeroAirspeed() { pitot.startCalibration(); }
void resumeAirspeed(float offset_v) { pitot.resume(offset_v); }

void runAirspeed() {
    const hal::AnalogSum reading = hal::analogTake(hal::Analog::airspeed);
    hal::analogScan();
    const uint32_t now_us = hal::now_us();
    drivers::AirspeedSettings settings;
    settings.ratio = parameters.airspeed_ratio;
    pitot.update(reading.sum, reading.count, (now_us - updated_us) * 1e-6f, settings);
    updated_us = now_us;
    vehicle.airspeed.pressure_pa = pitot.pressure_pa();
    vehicle.airspeed.speed_mps = pitot.speed_mps();
    vehicle.airspeed.offset_v = pitot.offset_v();
    vehicle.airspeed.healthy =
        parameters.airspeed_enable != 0 && parameters.airspeed_use != 0 && pitot.healthy();
}

}  // namespace firmware
