// SPDX-License-Identifier: GPL-3.0-or-later
// What a GPS reports, whatever its make: one fix, in integers.
#pragma once
#include <stdint.h>

namespace drivers {

enum class GpsFixType : uint8_t { unknown, none, two_d, three_d };

struct GpsFix {
    int32_t latitude_e7, longitude_e7;
    int32_t altitude_cm;  // above sea level
    uint32_t time_ms;     // GPS time of week
    uint16_t week;        // GPS week; 0 when not reported
    int16_t north_cms, east_cms, down_cms;
    uint16_t speed_cms;  // over ground
    uint16_t course_cd;  // 0..35999
    uint16_t hdop_c;     // the receiver's dilution of position, 0.01
    uint16_t age_ms;     // how long ago this was true when its last byte was read
    GpsFixType type;
    uint8_t satellites;
    bool has_down;  // false: the receiver reports no vertical velocity, down_cms is 0
};

}  // namespace drivers
