// SPDX-License-Identifier: GPL-3.0-or-later
// From the week and time of a receiver's report to the time of day on the ground.
#pragma once
#include <stdint.h>

namespace firmware {
namespace gcs {

// UTC as the sum of the two: the beginning of the GPS week in seconds since 1970, and milliseconds
// since then. week_s is 0 until the receiver has named week and time and there has been a fix.
struct UtcTime {
    uint32_t week_s;
    uint32_t since_ms;
};
// Of a GPS week; 0: the week is not known. GPS time has no leap seconds: 18 since 2017.
inline uint32_t weekBegan_utc_s(uint16_t week) {
    constexpr uint32_t kGpsBegan_s = 315964800, kWeek_s = 604800, kLeap_s = 18;
    return week == 0 ? 0 : kGpsBegan_s - kLeap_s + week * kWeek_s;
}
UtcTime utcTime();

uint64_t micros(uint32_t time_ms);  // as messages have it

}  // namespace gcs
}  // namespace firmware
