// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivers/mtk.hpp"

namespace drivers {
namespace {

// Behind preamble and length: latitude, longitude, height (cm), speed (cm/s), course (0.01
// degrees), satellites, fix, date, time of day, dilution.
GpsFixType fixType(uint8_t value) {
    if (value == 2 || value == 6) return GpsFixType::two_d;  // 6, 7: with a satellite's corrections
    return value == 3 || value == 7 ? GpsFixType::three_d : GpsFixType::none;
}

int32_t scaled(const uint8_t* at, uint8_t scale, GpsEpoch& epoch) {
    constexpr int32_t kMax = 180000000;  // what scaled by 10 is still within half a turn
    const int32_t value = loaded<int32_t>(at);
    if (scale == 1) return value;
    if (value > kMax || value < -kMax) epoch.odd = true;
    return epoch.odd ? 0 : value * scale;
}

bool read(const uint8_t* frame, uint8_t scale, GpsEpoch& epoch) {
    const uint8_t* payload = frame + 3;
    GpsFix& fix = epoch.fix;
    fix.latitude_e7 = scaled(payload, scale, epoch);
    fix.longitude_e7 = scaled(payload + 4, scale, epoch);
    fix.altitude_cm = loaded<int32_t>(payload + 8);
    epoch.setSpeed(loaded<uint32_t>(payload + 12), loaded<uint32_t>(payload + 16));
    epoch.velocityFromCourse();
    fix.satellites = payload[20];
    fix.hdop_c = loaded<uint16_t>(payload + 30);
    epoch.setUtc(loaded<uint32_t>(payload + 26) * scale, loaded<uint32_t>(payload + 22));
    epoch.finish(fixType(payload[21]));
    return true;
}

}  // namespace

// 1e-6 degrees and hundredths of a second.
bool readMtk16(const uint8_t* frame, GpsEpoch& epoch) { return read(frame, 10, epoch); }
// 1e-7 degrees and milliseconds.
bool readMtk19(const uint8_t* frame, GpsEpoch& epoch) { return read(frame, 1, epoch); }

}  // namespace drivers
