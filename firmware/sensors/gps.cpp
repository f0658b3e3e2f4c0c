// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivers/gps.hpp"

#include "firmware/notify/status_text.hpp"
#include "firmware/sensors/devices.hpp"
#include "firmware/sensors/sensors.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware/state/vehicle.hpp"
#include "hal/clock.hpp"
#include "hal/serial.hpp"

namespace firmware {
namespace sensors {

using namespace notify;
using namespace state;

namespace {

drivers::Gps receiver;
drivers::GpsProtocol reported;

constexpr char kFound[][18] ROM = {"GPS: u-blox at #", "GPS: MTK 1.6 at #", "GPS: MTK 1.9 at #",
                                   "GPS: NMEA at #"};

void reportWhatWasFound() {
    reported = receiver.protocol();
    if (reported == drivers::GpsProtocol::none) return;
    sendStatusText(Severity::info, kFound[static_cast<uint8_t>(reported) - 1],
                   static_cast<int32_t>(receiver.baud()));
}

void take(const drivers::GpsFix& fix) {
    constexpr float kMetre = 0.01f;
    auto& gps = vehicle.gps;
    gps.fix = static_cast<GpsFix>(fix.type);
    gps.satellites = fix.satellites;
    gps.hdop_c = fix.hdop_c;
    gps.received_ms = hal::now_ms();
    gps.age_ms = fix.age_ms;
    if (fix.type == drivers::GpsFixType::none) return;
    gps.position = {fix.latitude_e7, fix.longitude_e7};
    gps.altitude_cm = fix.altitude_cm;
    // what the receiver does not report of climbing and sinking the barometer does
    gps.velocity_mps = {fix.north_cms * kMetre, fix.east_cms * kMetre,
                        fix.has_down ? fix.down_cms * kMetre : -vehicle.estimate.climb_mps};
    gps.ground_speed_mps = fix.speed_cms * kMetre;
    gps.course_cd = fix.course_cd;
    gps.fresh = true;  // the estimator clears it
}

}  // namespace

const drivers::GpsFix& gpsFix() { return receiver.fix(); }

void startGps() { receiver.start(static_cast<uint8_t>(parameters.gps_type)); }

void runGps() {
    const bool arrived = receiver.step(hal::now_ms());
    if (receiver.protocol() != reported) reportWhatWasFound();
    vehicle.gps.healthy = receiver.healthy();
    if (!vehicle.gps.healthy) vehicle.gps.fix = GpsFix::no_gps;
    if (vehicle.gps.healthy && vehicle.gps.fix == GpsFix::no_gps) vehicle.gps.fix = GpsFix::none;
    if (arrived) take(receiver.fix());
}

bool gpsWaits() {
    constexpr uint8_t kMuch = 32;
    return hal::serialAvailable(hal::Port::gps) >= kMuch;
}

}  // namespace sensors
}  // namespace firmware
