// SPDX-License-Identifier: GPL-3.0-or-later
// One measurement of a GPS, and what its messages are made of.
#pragma once
#include <cmath>
#include <cstdint>

namespace simulator {

struct GpsFix {        // errors included
    uint64_t time_us;  // of the measurement
    bool valid;
    int satellites;
    double latitude_deg, longitude_deg, altitude_m;  // above sea level
    double velocity_north_mps, velocity_east_mps, velocity_down_mps;
};

// Emulated time 0 is Monday 2024-06-03 10:00:00 UTC: GPS week 2317, 18 leap seconds.
constexpr uint16_t kGpsWeek = 2317;
constexpr double kGeoid_m = 47.0;  // height of the geoid over the ellipsoid
constexpr uint32_t kDop = 180, kNoDop = 9999;

inline uint32_t timeOfWeek_ms(const GpsFix& fix) {
    constexpr uint32_t kStart_ms = (24 + 10) * 3'600'000u + 18'000u, kWeek_ms = 604'800'000u;
    return static_cast<uint32_t>((fix.time_us / 1000 + kStart_ms) % kWeek_ms);
}

struct Utc {
    uint32_t year, month, day, hour, minute, second, ms;
};
inline Utc utc(const GpsFix& fix) {
    constexpr uint32_t kLeap_ms = 18'000, kDay_ms = 86'400'000;
    constexpr int kYear = 2024, kMonth = 6, kSunday = 2;
    const uint32_t ms = timeOfWeek_ms(fix) - kLeap_ms, of_day = ms % kDay_ms;
    return {kYear,
            kMonth,
            kSunday + ms / kDay_ms,
            of_day / 3'600'000,
            of_day / 60'000 % 60,
            of_day / 1000 % 60,
            of_day % 1000};
}

inline double groundSpeed_mps(const GpsFix& fix) {
    return std::hypot(fix.velocity_north_mps, fix.velocity_east_mps);
}
inline double course_deg(const GpsFix& fix) {
    const double course = std::atan2(fix.velocity_east_mps, fix.velocity_north_mps) * 180 / M_PI;
    return course < 0 ? course + 360 : course;
}

}  // namespace simulator
