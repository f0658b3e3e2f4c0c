// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/gcs/gps_time.hpp"

#include "core/seldom.hpp"
#include "firmware/sensors/sensors.hpp"
#include "firmware/state/vehicle.hpp"
#include "hal/clock.hpp"

namespace firmware {
namespace gcs {

using state::vehicle;

UtcTime utcTime() {
    const drivers::GpsFix& fix = sensors::gpsFix();
    if (!vehicle.home.set) return {0, 0};
    return {weekBegan_utc_s(fix.week),
            hal::frame_ms() - vehicle.gps.received_ms + fix.age_ms + fix.time_ms};
}

SELDOM uint64_t micros(uint32_t time_ms) { return uint64_t{1000} * time_ms; }

}  // namespace gcs
}  // namespace firmware
