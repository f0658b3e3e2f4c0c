// SPDX-License-Identifier: GPL-3.0-or-later
// The serial ports by the part they play. Both directions are buffered and driven by interrupts;
// nothing here waits.
#pragma once
#include <stdint.h>

namespace hal {

enum class Port : uint8_t { link0, gps, link1 };  // link0: USB or telemetry, see usbConnected
constexpr uint8_t kPorts = 3;

// 8N1. Forgets what either buffer holds. May be called again at any time.
void serialOpen(Port port, uint32_t baud);

uint8_t serialAvailable(Port port);         // bytes received and not yet read
bool serialRead(Port port, uint8_t& byte);  // false: none there
uint8_t serialRoom(Port port);              // bytes that serialWrite would take now

// Queues all `size` bytes and returns true, or queues none and returns false.
bool serialWrite(Port port, const void* bytes, uint8_t size);

// Queues a frame on a link that has room for it: head, body and their checksum (core/crc.hpp),
// which was `crc` before them and counts the byte `extra` after them. Costs less than to go through
// the bytes twice.
struct Piece {
    const uint8_t* bytes;
    uint8_t size;
};
void linkWriteFrame(Port link, const Piece& head, const Piece& body, uint16_t crc, uint8_t extra);

uint16_t serialLost(Port port);  // received bytes dropped since reset: overrun or buffer full

// True while a USB cable has taken link0 over from the telemetry connector.
bool usbConnected();

}  // namespace hal
