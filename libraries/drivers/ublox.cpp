// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivers/ublox.hpp"

#include "drivers/gps_script.hpp"

namespace drivers {
namespace {

constexpr uint8_t kNav = 0x01, kAcknowledge = 0x05, kCfg = 0x06;
constexpr uint8_t kPosllh = 0x02, kStatus = 0x03, kSol = 0x06, kPvt = 0x07, kVelned = 0x12;
constexpr uint8_t kCfgNav5 = 0x24;

GpsFixType fixType(const uint8_t* type_and_flags) {
    if (!(type_and_flags[1] & 0x01)) return GpsFixType::none;
    const uint8_t type = type_and_flags[0];
    if (type == 2) return GpsFixType::two_d;
    return type == 3 || type == 4 ? GpsFixType::three_d : GpsFixType::none;
}

// Longitude, latitude, height over the ellipsoid and over the sea: in POSLLH as in PVT.
void takePosition(const uint8_t* at, GpsFix& fix) {
    fix.longitude_e7 = loaded<int32_t>(at);
    fix.latitude_e7 = loaded<int32_t>(at + 4);
    fix.altitude_cm = loaded<int32_t>(at + 12) / 10;
}

// Cut off instead of rounded, millimetres would make every speed half a centimetre too small.
int32_t rounded(int32_t value, uint8_t per) {
    const int32_t half = per / 2;
    return (value < 0 ? value - half : value + half) / per;
}

// North, east and down at `velocity`; speed over ground and course at `ground`.
void takeVelocity(const uint8_t* velocity, const uint8_t* ground, uint8_t per_cms,
                  GpsEpoch& epoch) {
    GpsFix& fix = epoch.fix;
    const auto at = [&](const uint8_t* from) { return rounded(loaded<int32_t>(from), per_cms); };
    fix.north_cms = epoch.speed(at(velocity));
    fix.east_cms = epoch.speed(at(velocity + 4));
    fix.down_cms = epoch.speed(at(velocity + 8));
    fix.has_down = true;
    const int32_t course_cd = loaded<int32_t>(ground + 4) / 1000;
    epoch.setSpeed(static_cast<uint32_t>(at(ground)),
                   static_cast<uint32_t>(course_cd < 0 ? course_cd + 36000 : course_cd));
}

bool report(GpsEpoch& epoch) {
    if (!epoch.whole()) return false;
    epoch.fix.time_ms = epoch.time;
    epoch.finish(epoch.type);
    return true;
}

// Of PVT, which has no week; its time of the week is the header's.
void takeWeek(const uint8_t* payload, GpsEpoch& epoch) {
    constexpr uint8_t kDateAndTime = 3;
    if ((payload[11] & kDateAndTime) != kDateAndTime) return;
    const uint16_t hhmm = payload[8] * 100U + payload[9], ddmm = payload[7] * 100U + payload[6];
    const uint32_t time_ms = epoch.fix.time_ms;
    epoch.setUtc(hhmm * 100000UL + payload[10] * 1000U,
                 ddmm * 100UL + static_cast<uint8_t>(loaded<uint16_t>(payload + 4) - 2000));
    epoch.fix.time_ms = time_ms;
}

bool readPvt(const uint8_t* payload, GpsEpoch& epoch) {
    // an M9 sends it behind POSLLH and VELNED, which have none of these, and has no SOL
    epoch.fix.satellites = payload[23];
    epoch.fix.hdop_c = loaded<uint16_t>(payload + 76);
    takeWeek(payload, epoch);
    if (!epoch.takes(GpsEpoch::kPosition | GpsEpoch::kVelocity, loaded<uint32_t>(payload)))
        return false;
    epoch.type = fixType(payload + 20);
    takePosition(payload + 24, epoch.fix);
    takeVelocity(payload + 48, payload + 60, 10, epoch);
    return report(epoch);
}

bool readPosition(const uint8_t* payload, GpsEpoch& epoch) {
    if (!epoch.takes(GpsEpoch::kPosition, loaded<uint32_t>(payload))) return false;
    takePosition(payload + 4, epoch.fix);
    return report(epoch);
}

bool readVelocity(const uint8_t* payload, GpsEpoch& epoch) {
    if (!epoch.takes(GpsEpoch::kVelocity, loaded<uint32_t>(payload))) return false;
    takeVelocity(payload + 4, payload + 20, 1, epoch);
    return report(epoch);
}

bool readStatus(const uint8_t* payload, GpsEpoch& epoch) {
    epoch.type = fixType(payload + 4);
    return false;
}

bool readSolution(const uint8_t* payload, GpsEpoch& epoch) {
    epoch.fix.week = loaded<uint16_t>(payload + 8);
    epoch.type = fixType(payload + 10);
    epoch.fix.hdop_c = loaded<uint16_t>(payload + 44);
    epoch.fix.satellites = payload[47];
    return false;
}

bool readSettings(const uint8_t* payload, GpsEpoch& epoch) {
    epoch.forgot = epoch.forgot || payload[2] != kAirborne4g;
    return false;
}

}  // namespace

bool isOfUblox(const uint8_t* frame) { return frame[2] == kNav || frame[2] == kAcknowledge; }

bool readUblox(const uint8_t* frame, GpsEpoch& epoch) {
    const uint8_t of_class = frame[2], id = frame[3], length = frame[4];
    const uint8_t* payload = frame + 6;
    if (of_class == kCfg && id == kCfgNav5 && length == 36) return readSettings(payload, epoch);
    if (of_class != kNav) return false;
    if (id == kPosllh && length == 28) return readPosition(payload, epoch);
    if (id == kVelned && length == 36) return readVelocity(payload, epoch);
    if (id == kStatus && length == 16) return readStatus(payload, epoch);
    if (id == kSol && length == 52) return readSolution(payload, epoch);
    if (id == kPvt && length >= 84) return readPvt(payload, epoch);
    return false;
}

}  // namespace drivers
