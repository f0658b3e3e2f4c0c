// SPDX-License-Identifier: GPL-3.0-or-later
// CRC-16/MCRF4XX ("X.25" in MAVLink): polynomial 0x1021 reflected, start 0xFFFF, no final
// inversion. Check value of "123456789": 0x6F91. Used on the ground link and for stored records.
#pragma once
#include <stdint.h>

namespace core {

constexpr uint16_t kCrcStart = 0xFFFF;

constexpr uint16_t crc16(uint16_t crc, uint8_t byte) {
    uint8_t t = static_cast<uint8_t>(byte ^ (crc & 0xFF));
    t = static_cast<uint8_t>(t ^ (t << 4));
    return static_cast<uint16_t>((crc >> 8) ^ (static_cast<uint16_t>(t) << 8) ^
                                 (static_cast<uint16_t>(t) << 3) ^ (t >> 4));
}

inline uint16_t crc16(uint16_t crc, const void* bytes, uint16_t size) {
    const uint8_t* byte = static_cast<const uint8_t*>(bytes);
    while (size-- > 0) crc = crc16(crc, *byte++);
    return crc;
}

}  // namespace core
