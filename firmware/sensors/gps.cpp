// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivers/ublox.hpp"
#include "firmware/sensors/devices.hpp"
#include "firmware/sensors/sensors.hpp"
#include "firmware/vehicle.hpp"
#include "hal/clock.hpp"

namespace firmware {
namespace {

drivers::Ublox receiver;

void take(const drivers::GpsFix& fix) {
    auto& gps = vehicle.gps;
    gps.fix = static_cast<GpsFix>(fix.type);
    gps.satellites = fix.satellites;
    gps.hdop_c = fix.hdop_c;
    gps.received_ms = hal::now_ms();
    if (fix.type == drivers::GpsFixType::none) return;
    gps.position = {fix.latitude_e7, fix.longitude_e7};
    gps.altitude_cm = fix.altitude_cm;
    gps.velocity_mps = fix.velocity_mps;
    gps.ground_speed_mps = fix.ground_speed_mps;
    gps.course_cd = fix.course_cd;
    gps.fresh = true;  // the estimator clears it
}

}  // namespace

const drivers::GpsFix& gpsFix() { return receiver.fix(); }

void startGps() { receiver.start(); }

void runGps() {
    const bool arrived = receiver.step(hal::now_ms());
    vehicle.gps.healthy = receiver.healthy();
    if (!vehicle.gps.healthy) vehicle.gps.fix = GpsFix::no_gps;
    if (vehicle.gps.healthy && vehicle.gps.fix == GpsFix::no_gps) vehicle.gps.fix = GpsFix::none;
    if (arrived) take(receiver.fix());
}

}  // namespace firmware
