// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivers/airspeed.hpp"

#include "firmware/failsafe/health.hpp"
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

// Of a count: so fine that a sensor that lives never says the same for long.
int16_t eighths(const hal::AnalogSum& reading) {
    if (reading.count == 4) return static_cast<int16_t>(reading.sum * 2);  // a scan's
    const uint16_t whole = reading.sum / reading.count, rest = reading.sum % reading.count;
    return static_cast<int16_t>(whole * 8 + rest * 8 / reading.count);
}

}  // namespace

void zeroAirspeed() { pitot.startCalibration(); }
void resumeAirspeed(float offset_v) { pitot.resume(offset_v); }

void runAirspeed() {
    const hal::AnalogSum reading = hal::analogTake(hal::Analog::airspeed);
    hal::analogScan();
    vehicle.airspeed.healthy = parameters.airspeed_enable != 0 && parameters.airspeed_use != 0 &&
                               pitot.healthy() && !ails(Sensor::airspeed);
    if (reading.count == 0 || !believe(Sensor::airspeed, eighths(reading), true)) return;
    const uint32_t now_us = hal::now_us();
    drivers::AirspeedSettings settings;
    settings.ratio = parameters.airspeed_ratio;
    pitot.update(reading.sum, reading.count, (now_us - updated_us) * 1e-6f, settings);
    updated_us = now_us;
    vehicle.airspeed.pressure_pa = pitot.pressure_pa();
    vehicle.airspeed.speed_mps = pitot.speed_mps();
    vehicle.airspeed.offset_v = pitot.offset_v();
}

}  // namespace firmware
