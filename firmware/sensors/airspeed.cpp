// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivers/airspeed.hpp"

#include "core/file_state.hpp"
#include "firmware/sensors/devices.hpp"
#include "firmware/sensors/health.hpp"
#include "firmware/sensors/sensors.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware/state/published.hpp"
#include "hal/analog.hpp"
#include "hal/clock.hpp"

namespace firmware {

namespace state {
template <>
struct Publisher<AirspeedState> : Writable<AirspeedState> {
    using Writable::state;
};
}  // namespace state

namespace sensors {

using namespace state;

namespace {

constexpr AirspeedState& published = Publisher<AirspeedState>::state();

core::FileState<drivers::Airspeed> pitot{};

struct Update {
    uint32_t us;
    bool waits;  // since the speed was last worked out
};
core::FileState<Update> update{};

}  // namespace

void zeroAirspeed() { pitot.startCalibration(); }
void resumeAirspeed(float offset_v) { pitot.resume(offset_v); }
float airspeedOffset_v() { return pitot.offset_v(); }
float airspeedPressure_pa() { return pitot.pressure_pa(); }

void runAirspeed() {
    const hal::AnalogSum reading = hal::analogTake(hal::Analog::airspeed);
    hal::analogScan();
    published.healthy = parameters.airspeed_enable != 0 && parameters.airspeed_use != 0 &&
                        pitot.healthy() && !isFaulty(Sensor::airspeed);
    if (reading.count == 0) return;
    // Eighths of a count: so fine that a sensor that lives never says the same for long.
    const uint16_t share = drivers::Airspeed::share(reading.sum, reading.count);
    if (!acceptReading(Sensor::airspeed, static_cast<int16_t>(share / 8), true)) return;
    const uint32_t now_us = hal::now_us();
    drivers::AirspeedSettings settings;
    settings.ratio = parameters.airspeed_ratio;
    pitot.update(share, now_us - update.us, settings);
    update.us = now_us;
    update.waits = true;
}

void workOutAirspeed() {
    if (!update.waits) return;
    update.waits = false;
    published.speed_mps = pitot.speed_mps();
}

}  // namespace sensors
}  // namespace firmware
