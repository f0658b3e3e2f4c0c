// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivers/airspeed.hpp"

#include "core/file_state.hpp"
#include "core/maths.hpp"
#include "firmware/sensors/devices.hpp"
#include "firmware/sensors/health.hpp"
#include "firmware/sensors/sensors.hpp"
#include "firmware/state/parameter_slots.hpp"
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
    bool ratio_learnt;
};
core::FileState<Update> update{};

}  // namespace

// Over 350 s, as gusts are taken for an error, too: over 100 s those of 1 m/s made an airspeed that
// was right 0.3 m/s wrong. A turn of 90 degrees shows an error for 15 s, a circle while it lasts.
// Bounded, so that a tube that is half blocked for a while does no harm: 10 % of speed.
void learnAirspeedRatio(float missing, float dt_s) {
    constexpr float kLearns_s = 350, kMin = 1.6f, kMax = 2.4f;
    float& ratio = parameters.airspeed_ratio;
    if (parameters.airspeed_autocal == 0 || ratio < kMin || ratio > kMax) return;
    ratio = core::limit(ratio + ratio * missing * dt_s * (2 / kLearns_s), kMin, kMax);
    update.ratio_learnt = true;
}

void saveAirspeedRatio() {
    if (!update.ratio_learnt) return;
    update.ratio_learnt = false;
    parameterSet(slot::arspd_ratio, parameters.airspeed_ratio);
}

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
