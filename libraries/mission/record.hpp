// SPDX-License-Identifier: GPL-3.0-or-later
// One mission command as it is stored: 14 bytes, little-endian, in one of two layouts. The layout
// belongs to the set of commands, which a stored mission names once for all its records.
//   byte      0    1        2        3..5     6..9   10..13
//   APM 1.0   id   p1       p2 (int32, 2..5)  p3     p4
//   APM 2.0   id   options  p1       p2       p3     p4
#pragma once
#include <stdint.h>

namespace mission {

enum class Set : uint8_t { apm1 = 1, apm2 = 2 };

constexpr uint8_t kRecordSize = 14;

enum Option : uint8_t {
    kRelativeAltitude = 1,
    kCounterClockwise = 4,
    kAboveTerrain = 8,
};

struct Record {
    uint8_t id;
    uint8_t options;  // 0 in the APM 1.0 layout
    uint8_t p1;
    int32_t p2, p3, p4;
};

constexpr int32_t kLargestP2 = 0x7FFFFF;  // 24 bits in the APM 2.0 layout

// What the layout has room for.
constexpr bool fits(Set set, const Record& record) {
    return set == Set::apm1 ? record.options == 0
                            : record.p2 >= -kLargestP2 - 1 && record.p2 <= kLargestP2;
}

void pack(Set set, const Record& record, uint8_t* to);  // a record that fits
Record unpack(Set set, const uint8_t* from);

}  // namespace mission
