// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/devices/ublox_reports.hpp"

#include <cmath>

#include "simulator/airplane/earth.hpp"
#include "simulator/devices/nmea_reports.hpp"
#include "simulator/devices/ublox_parser.hpp"

namespace simulator {
namespace {

constexpr uint32_t kHorizontal_mm = 1500, kVertical_mm = 2500, kSpeed_mms = 300;
constexpr uint32_t kUnknown_mm = 4'000'000;

class Payload {
public:
    Payload& u8(uint32_t value) { return put(value, 1); }
    Payload& u16(uint32_t value) { return put(value, 2); }
    Payload& u32(uint32_t value) { return put(value, 4); }
    Payload& i32(double value) {
        return put(static_cast<uint32_t>(static_cast<int32_t>(std::lround(value))), 4);
    }
    Payload& zeros(int count) { return put(0, count); }
    std::vector<uint8_t> frame(uint8_t id) const { return ubxBytes({0x01, id, bytes_}); }

private:
    Payload& put(uint32_t value, int size) {
        for (int i = 0; i < size; ++i)
            bytes_.push_back(i < 4 ? static_cast<uint8_t>(value >> 8 * i) : 0);
        return *this;
    }
    std::vector<uint8_t> bytes_;
};

uint32_t dop(const GpsFix& fix) { return fix.valid ? kDop : kNoDop; }
uint32_t fixType(const GpsFix& fix) { return fix.valid ? 3 : 0; }
std::vector<uint8_t> posllh(const GpsFix& fix) {
    return Payload()
        .u32(timeOfWeek_ms(fix))
        .i32(fix.longitude_deg * 1e7)
        .i32(fix.latitude_deg * 1e7)
        .i32((fix.altitude_m + kGeoid_m) * 1e3)
        .i32(fix.altitude_m * 1e3)
        .u32(fix.valid ? kHorizontal_mm : kUnknown_mm)
        .u32(fix.valid ? kVertical_mm : kUnknown_mm)
        .frame(0x02);
}

std::vector<uint8_t> status(const GpsFix& fix) {
    return Payload()
        .u32(timeOfWeek_ms(fix))
        .u8(fixType(fix))
        .u8(fix.valid ? 0x0D : 0x00)  // fix OK, week and time of week valid
        .u8(0)
        .u8(0)
        .u32(0)
        .u32(static_cast<uint32_t>(fix.time_us / 1000))
        .frame(0x03);
}

std::vector<uint8_t> solution(const GpsFix& fix) {
    const auto ecef =
        ecefPosition_m(fix.latitude_deg, fix.longitude_deg, fix.altitude_m + kGeoid_m);
    const auto velocity =
        ecefVelocity_mps(fix.latitude_deg, fix.longitude_deg, fix.velocity_north_mps,
                         fix.velocity_east_mps, fix.velocity_down_mps);
    Payload payload;
    payload.u32(timeOfWeek_ms(fix))
        .i32(0)
        .u16(kGpsWeek)
        .u8(fixType(fix))
        .u8(fix.valid ? 0x0D : 0x00);
    for (double metres : {ecef.x, ecef.y, ecef.z}) payload.i32(metres * 100);
    payload.u32((fix.valid ? kVertical_mm : kUnknown_mm) / 10);
    for (double mps : {velocity.x, velocity.y, velocity.z}) payload.i32(mps * 100);
    return payload.u32(kSpeed_mms / 10)
        .u16(dop(fix))
        .u8(0)
        .u8(static_cast<uint32_t>(fix.satellites))
        .u32(0)
        .frame(0x06);
}

std::vector<uint8_t> velned(const GpsFix& fix) {
    return Payload()
        .u32(timeOfWeek_ms(fix))
        .i32(fix.velocity_north_mps * 100)
        .i32(fix.velocity_east_mps * 100)
        .i32(fix.velocity_down_mps * 100)
        .i32(std::hypot(groundSpeed_mps(fix), fix.velocity_down_mps) * 100)
        .i32(groundSpeed_mps(fix) * 100)
        .i32(course_deg(fix) * 1e5)
        .u32(kSpeed_mms / 10)
        .u32(50'000)
        .frame(0x12);
}

std::vector<uint8_t> pvt(const GpsFix& fix) {
    const Utc time = utc(fix);
    return Payload()
        .u32(timeOfWeek_ms(fix))
        .u16(time.year)
        .u8(time.month)
        .u8(time.day)
        .u8(time.hour)
        .u8(time.minute)
        .u8(time.second)
        .u8(0x07)
        .u32(50)
        .i32(time.ms * 1e6)
        .u8(fixType(fix))
        .u8(fix.valid)
        .u8(0)
        .u8(static_cast<uint32_t>(fix.satellites))
        .i32(fix.longitude_deg * 1e7)
        .i32(fix.latitude_deg * 1e7)
        .i32((fix.altitude_m + kGeoid_m) * 1e3)
        .i32(fix.altitude_m * 1e3)
        .u32(fix.valid ? kHorizontal_mm : kUnknown_mm)
        .u32(fix.valid ? kVertical_mm : kUnknown_mm)
        .i32(fix.velocity_north_mps * 1e3)
        .i32(fix.velocity_east_mps * 1e3)
        .i32(fix.velocity_down_mps * 1e3)
        .i32(groundSpeed_mps(fix) * 1e3)
        .i32(course_deg(fix) * 1e5)
        .u32(kSpeed_mms)
        .u32(50'000)
        .u16(dop(fix))
        .zeros(6)
        .frame(0x07);
}

std::vector<uint8_t> gga(const GpsFix& fix) { return nmeaGga(fix, "GP"); }
std::vector<uint8_t> gll(const GpsFix& fix) { return nmeaGll(fix, "GP"); }
std::vector<uint8_t> gsa(const GpsFix& fix) { return nmeaGsa(fix, "GP"); }
std::vector<uint8_t> gsv(const GpsFix& fix) { return nmeaGsv(fix, "GP"); }
std::vector<uint8_t> rmc(const GpsFix& fix) { return nmeaRmc(fix, "GP"); }
std::vector<uint8_t> vtg(const GpsFix& fix) { return nmeaVtg(fix, "GP"); }

}  // namespace

const UbloxReport kReports[kReportCount] = {
    {0x01, 0x02, posllh},    {0x01, 0x03, status},    {0x01, 0x06, solution},
    {0x01, 0x12, velned},    {0x01, 0x07, pvt},       {kNmeaClass, 0x04, rmc},
    {kNmeaClass, 0x05, vtg}, {kNmeaClass, 0x00, gga}, {kNmeaClass, 0x02, gsa},
    {kNmeaClass, 0x03, gsv}, {kNmeaClass, 0x01, gll},
};

}  // namespace simulator
