// SPDX-License-Identifier: GPL-3.0-or-later
// From the week of a receiver's report to the time of day on the ground.
#pragma once
#include <stdint.h>

namespace firmware {
namespace gcs {

// Of a GPS week, in seconds since 1970; 0: the week is not known. GPS time has no leap seconds: 18
// since 2017.
inline uint32_t weekBegan_utc_s(uint16_t week) {
    constexpr uint32_t kGpsBegan_s = 315964800, kWeek_s = 604800, kLeap_s = 18;
    return week == 0 ? 0 : kGpsBegan_s - kLeap_s + week * kWeek_s;
}

}  // namespace gcs
}  // namespace firmware
