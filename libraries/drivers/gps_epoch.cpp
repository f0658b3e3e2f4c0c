// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivers/gps_epoch.hpp"

#include "core/maths.hpp"

namespace drivers {
namespace {

constexpr uint16_t kFastest_cms = 30000;
constexpr int32_t kLowest_cm = -100000, kHighest_cm = 5000000;
constexpr int32_t kQuarterTurn_e7 = 900000000;

constexpr uint32_t kDay_ms = 86400000, kWeek_ms = 7 * kDay_ms;
constexpr uint32_t kLeap_ms = 18000;        // GPS is ahead of UTC since 2017
constexpr uint16_t kDaysBefore2000 = 7300;  // since 1980-01-06

bool plausible(const GpsFix& fix) {
    return fix.latitude_e7 >= -kQuarterTurn_e7 && fix.latitude_e7 <= kQuarterTurn_e7 &&
           fix.longitude_e7 >= -2 * kQuarterTurn_e7 && fix.longitude_e7 <= 2 * kQuarterTurn_e7 &&
           fix.altitude_cm > kLowest_cm && fix.altitude_cm < kHighest_cm;
}

// Since 2000-01-01, until 2099.
uint16_t days(uint8_t year, uint8_t month, uint8_t day) {
    const uint8_t shortened = month <= 2 ? 0 : year % 4 == 0 ? 1 : 2;
    return year * 365U + (year + 3U) / 4 + (367U * month - 362) / 12 - shortened + day - 1;
}

}  // namespace

void GpsEpoch::finish(GpsFixType as) {
    parts |= kReported;
    const bool fixed = as > GpsFixType::none;
    const bool impossible = fixed && (odd || !plausible(fix));
    if (impossible) refuse();
    fix.type = fixed && !impossible ? as : GpsFixType::none;
    odd = false;
}

int16_t GpsEpoch::speed(int32_t cms) {
    constexpr int32_t kFastest = kFastest_cms;
    if (cms <= kFastest && cms >= -kFastest) return static_cast<int16_t>(cms);
    odd = true;
    return 0;
}

void GpsEpoch::setSpeed(uint32_t cms, uint32_t course_cd) {
    if (cms > kFastest_cms || course_cd > 36000) odd = true;
    fix.speed_cms = static_cast<uint16_t>(cms);
    fix.course_cd = static_cast<uint16_t>(course_cd == 36000 ? 0 : course_cd);
}

void GpsEpoch::velocityFromCourse() {
    const float course_rad = core::radiansFromCentidegrees(fix.course_cd);
    fix.north_cms = static_cast<int16_t>(core::rounded(fix.speed_cms * cosf(course_rad)));
    fix.east_cms = static_cast<int16_t>(core::rounded(fix.speed_cms * sinf(course_rad)));
    fix.down_cms = 0;
    fix.has_down = false;
}

void GpsEpoch::setUtc(uint32_t hhmmssmmm, uint32_t ddmmyy) {
    const uint16_t hhmm = static_cast<uint16_t>(hhmmssmmm / 100000);
    const uint16_t ddmm = static_cast<uint16_t>(ddmmyy / 100);
    const uint8_t year = static_cast<uint8_t>(ddmmyy % 100), month = ddmm % 100;
    fix.time_ms = hhmmssmmm % 100000 + (hhmm / 100 * 60U + hhmm % 100) * 60000UL;
    fix.week = 0;
    if (fix.time_ms >= kDay_ms || ddmmyy > 311299 || month == 0 || month > 12) return;
    const uint16_t since_1980 = kDaysBefore2000 + days(year, month, ddmm / 100);
    fix.week = since_1980 / 7;
    fix.time_ms += since_1980 % 7 * kDay_ms + kLeap_ms;
    if (fix.time_ms < kWeek_ms) return;
    fix.time_ms -= kWeek_ms;
    ++fix.week;
}

}  // namespace drivers
