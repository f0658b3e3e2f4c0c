// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivers/gps.hpp"

#include "core/based.hpp"
#include "core/file_state.hpp"
#include "firmware/notify/status_text.hpp"
#include "firmware/sensors/devices.hpp"
#include "firmware/sensors/sensors.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware/state/published.hpp"
#include "hal/clock.hpp"
#include "hal/serial.hpp"

namespace firmware {

namespace state {
template <>
struct Publisher<GpsState> : Writable<GpsState> {
    using Writable::state;
};
}  // namespace state

namespace sensors {

using namespace notify;
using namespace state;

namespace {

constexpr GpsState& published = Publisher<GpsState>::state();

struct Reception {
    drivers::Gps receiver;
    drivers::GpsProtocol reported;
};
core::FileState<Reception> reception{};

constexpr TextField<11> kFound[] ROM = {
    "GPS: u-blox at #",
    "GPS: MTK 1.6 at #",
    "GPS: MTK 1.9 at #",
    "GPS: NMEA at #",
};

void reportWhatWasFound() {
    reception.reported = reception.receiver.protocol();
    if (reception.reported == drivers::GpsProtocol::none) return;
    sendStatusText(Severity::info, kFound[static_cast<uint8_t>(reception.reported) - 1],
                   static_cast<int32_t>(reception.receiver.baud()));
}

void take(const drivers::GpsFix& fix) {
    auto& state = core::based(published);
    constexpr float kMetre = 0.01f;
    state.fix = static_cast<GpsFix>(fix.type);
    state.satellites = fix.satellites;
    state.hdop_c = fix.hdop_c;
    state.received_ms = hal::now_ms();
    state.age_ms = fix.age_ms;
    if (fix.type == drivers::GpsFixType::none) return;
    state.position = {fix.latitude_e7, fix.longitude_e7};
    state.altitude_cm = fix.altitude_cm;
    // what the receiver does not report of climbing and sinking the barometer does
    state.velocity_mps = {
        core::hundredths(fix.north_cms), core::hundredths(fix.east_cms),
        fix.has_down ? core::hundredths(fix.down_cms) : -vehicle.estimate.climb_mps};
    state.measures_climb = fix.has_down;
    state.ground_speed_mps = fix.speed_cms * kMetre;
    state.course_cd = fix.course_cd;
    ++state.fixes;
}

}  // namespace

const drivers::GpsFix& gpsFix() { return reception.receiver.fix(); }

void startGps() { reception.receiver.start(static_cast<uint8_t>(parameters.gps_type)); }

void runGps() {
    const bool arrived = reception.receiver.step(hal::frame_ms());
    if (reception.receiver.protocol() != reception.reported) reportWhatWasFound();
    published.healthy = reception.receiver.healthy();
    if (!published.healthy) published.fix = GpsFix::no_gps;
    if (published.healthy && published.fix == GpsFix::no_gps) published.fix = GpsFix::none;
    if (arrived) take(core::based(reception.receiver).fix());
}

bool gpsWaits() {
    constexpr uint8_t kMuch = 32;
    return hal::serialAvailable(hal::Port::gps) >= kMuch;
}

}  // namespace sensors
}  // namespace firmware
