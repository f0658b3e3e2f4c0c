// SPDX-License-Identifier: GPL-3.0-or-later
// What the sensors and the receiver say, and what goes to the servos.
#include <stddef.h>
#include <string.h>

#include "core/based.hpp"
#include "core/maths.hpp"
#include "core/seldom.hpp"
#include "firmware/gcs/gps_time.hpp"
#include "firmware/gcs/messages.hpp"
#include "firmware/sensors/sensors.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware/state/vehicle.hpp"
#include "hal/clock.hpp"

namespace firmware {
namespace gcs {

using namespace state;
using namespace sensors;

namespace {

constexpr uint8_t kUnknownRssi = 255;

// Thousandths of g, and of a rad/s; rounded.
SELDOM int16_t milliG(core::Acceleration accel_mss) {
    constexpr float kFactor = 1000 / core::kGravity_mss / core::Acceleration::kSteps * 65536;
    return core::upper(core::product(accel_mss.raw, static_cast<int16_t>(kFactor + 0.5f)));
}
SELDOM int16_t milli(core::BodyRate rate_rads) {
    constexpr float kFactor = 1000 / core::BodyRate::kSteps * 65536 / 2;  // twice is past 16 bits
    return core::upper(core::product(rate_rads.raw, static_cast<int16_t>(kFactor)) * 2);
}

SELDOM float vibration_mss(uint8_t axis) {
    return core::hundredths(static_cast<int16_t>(vibration_cmss(axis)));
}

// The nine numbers that RAW_IMU and SCALED_IMU have one behind the other.
constexpr uint8_t kNumbers = 9;
static_assert(offsetof(mavlink::RawImu, zmag) - offsetof(mavlink::RawImu, xacc) == 16, "");
static_assert(offsetof(mavlink::ScaledImu, zmag) - offsetof(mavlink::ScaledImu, xacc) == 16, "");

void inertialAndField(void* to) {
    const auto& accel_mss = vehicle.imu.accel_mss;
    const auto& rate_rads = vehicle.imu.rate_rads;
    const auto& field_mg = vehicle.compass.field_mg;
    const int16_t numbers[kNumbers] = {milliG(accel_mss.x),
                                       milliG(accel_mss.y),
                                       milliG(accel_mss.z),
                                       milli(rate_rads.x),
                                       milli(rate_rads.y),
                                       milli(rate_rads.z),
                                       static_cast<int16_t>(field_mg.x),
                                       static_cast<int16_t>(field_mg.y),
                                       static_cast<int16_t>(field_mg.z)};
    memcpy(to, numbers, sizeof numbers);
}

}  // namespace

bool fillIn(const Link&, mavlink::RawImu& to) {
    // as ArduPilot sends it: mg, mrad/s, mgauss
    to.time_usec = hal::now_us();
    inertialAndField(&to.xacc);
    return true;
}

bool fillIn(const Link&, mavlink::ScaledImu& to) {
    to.time_boot_ms = hal::frame_ms();
    inertialAndField(&to.xacc);
    return true;
}

// The time is that of the log.
bool fillIn(const Link&, mavlink::Vibration& to) {
    to.time_usec = micros(hal::now_ms());
    to.vibration_x = vibration_mss(0);
    to.vibration_y = vibration_mss(1);
    to.vibration_z = vibration_mss(2);
    to.clipping_0 = accelerometerClips();
    return true;
}

bool fillIn(const Link&, mavlink::ScaledPressure& to) {
    to.time_boot_ms = hal::frame_ms();
    to.press_abs = static_cast<float>(vehicle.baro.pressure_pa) * 0.01f;
    to.press_diff = airspeedPressure_pa() * 0.01f;
    to.temperature = vehicle.baro.temperature_cc;
    return true;
}

bool fillIn(const Link&, mavlink::GpsRawInt& to) {
    const auto& gps = core::based(vehicle.gps);
    to.time_usec = micros(gps.received_ms);
    to.fix_type = static_cast<uint8_t>(gps.fix);
    to.lat = gps.position.latitude_e7;
    to.lon = gps.position.longitude_e7;
    to.alt = gps.altitude_cm * 10;
    to.eph = gps.hdop_c;
    to.epv = UINT16_MAX;
    to.vel = static_cast<uint16_t>(core::inHundredths(gps.ground_speed_mps));
    to.cog = static_cast<uint16_t>(gps.course_cd);
    to.satellites_visible = gps.satellites;
    return true;
}

bool fillIn(const Link&, mavlink::RcChannelsRaw& to) {
    to.time_boot_ms = hal::frame_ms();
    memcpy(&to.chan1_raw, vehicle.radio.pulse_us, sizeof vehicle.radio.pulse_us);
    to.rssi = kUnknownRssi;
    return true;
}

bool fillIn(const Link&, mavlink::RcChannels& to) {
    to.time_boot_ms = hal::frame_ms();
    constexpr uint8_t kChannels = (offsetof(mavlink::RcChannels, chancount) - 4) / 2;
    memset(&to.chan1_raw, 0xFF, 2 * kChannels);  // UINT16_MAX: no such channel
    memcpy(&to.chan1_raw, vehicle.radio.pulse_us, sizeof vehicle.radio.pulse_us);
    to.chancount = hal::kRcChannels;
    to.rssi = kUnknownRssi;
    return true;
}

// As it came in, without RCn_REV and RCn_DZ. A channel that was never received has no value.
static int16_t scaled(uint8_t channel) {
    const uint16_t pulse_us = vehicle.radio.pulse_us[channel];
    if (pulse_us == 0) return INT16_MAX;
    const Channel& ends = parameters.channel[channel];
    const int16_t off_us = static_cast<int16_t>(pulse_us) - ends.trim_us;
    const int16_t span_us = off_us < 0 ? ends.trim_us - ends.min_us : ends.max_us - ends.trim_us;
    if (span_us <= 0) return 0;
    return static_cast<int16_t>(core::limit<int16_t>(off_us, -span_us, span_us) * 10000L / span_us);
}

bool fillIn(const Link&, mavlink::RcChannelsScaled& to) {
    to.time_boot_ms = hal::frame_ms();
    for (uint8_t i = 0; i < hal::kRcChannels; ++i) (&to.chan1_scaled)[i] = scaled(i);
    to.rssi = kUnknownRssi;
    return true;
}

bool fillIn(const Link&, mavlink::ServoOutputRaw& to) {
    to.time_usec = hal::now_us();
    memcpy(&to.servo1_raw, vehicle.servo_us, sizeof vehicle.servo_us);
    return true;
}

}  // namespace gcs
}  // namespace firmware
