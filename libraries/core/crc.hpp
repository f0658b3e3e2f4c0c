// SPDX-License-Identifier: GPL-3.0-or-later
// CRC-16/MCRF4XX ("X.25" in MAVLink): polynomial 0x1021 reflected, start 0xFFFF, no final
// inversion. Check value of "123456789": 0x6F91. Used on the ground link and for stored records.
#pragma once
#include <stdint.h>

#ifdef __AVR__
extern "C" uint16_t crc16OfBytes(uint16_t crc, const void* bytes, uint16_t size);  // hal_avr
#endif

namespace core {

constexpr uint16_t kCrcStart = 0xFFFF;

// In bytes and by swapping their halves, as the chip can; of 16-bit shifts the compiler makes
// loops.
constexpr uint16_t crc16(uint16_t crc, uint8_t byte) {
    uint8_t t = static_cast<uint8_t>(byte ^ crc);
    t = static_cast<uint8_t>(t ^ static_cast<uint8_t>(t << 4));
    const uint8_t swapped = static_cast<uint8_t>(t << 4 | t >> 4);
    const uint8_t down_4 = swapped & 0x0F;
    const uint8_t up_3 = static_cast<uint8_t>(t << 3);
    const uint8_t low = static_cast<uint8_t>(static_cast<uint8_t>(crc >> 8) ^ up_3 ^ down_4);
    const uint8_t high = static_cast<uint8_t>(t ^ static_cast<uint8_t>(down_4 >> 1));
    return static_cast<uint16_t>(low | static_cast<uint16_t>(high) << 8);
}

#ifdef __AVR__
inline uint16_t crc16(uint16_t crc, const void* bytes, uint16_t size) {
    return crc16OfBytes(crc, bytes, size);
}
#else
inline uint16_t crc16(uint16_t crc, const void* bytes, uint16_t size) {
    const uint8_t* byte = static_cast<const uint8_t*>(bytes);
    while (size-- > 0) crc = crc16(crc, *byte++);
    return crc;
}
#endif

}  // namespace core
