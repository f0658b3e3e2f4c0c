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
constexpr uint8_t kLinkRoom = 254;          // of a link that has nothing to send

// Queues all `size` bytes and returns true, or queues none and returns false.
bool serialWrite(Port port, const void* bytes, uint8_t size);

// Queues a frame on a link that has room for it: head, body and their checksum (core/crc.hpp),
// which was `crc` before them and counts the byte `extra` after them. Costs less than to go through
// the bytes twice.
struct Piece {
    const uint8_t* bytes;
    uint8_t size;
};
// With a `signature` so many bytes behind the frame are kept free for it, and the frame is held:
// it takes room, but is not sent before linkSendHeld. What is held goes out in its order: while
// there is some, no frame is queued without a signature.
void linkWriteFrame(Port link, const Piece& head, const Piece& body, uint16_t crc, uint8_t extra,
                    uint8_t signature);

// Bytes that may lie in two runs, as at the end of a ring.
struct Runs {
    uint8_t* first;
    uint8_t first_size;
    uint8_t* second;
    uint8_t& operator[](uint8_t at) const {
        return at < first_size ? first[at] : second[static_cast<uint8_t>(at - first_size)];
    }
};
uint8_t linkHeldSize(Port link);
Runs linkHeld(Port link);                    // from the oldest frame on
void linkSendHeld(Port link, uint8_t size);  // the oldest bytes, so many

uint16_t serialLost(Port port);  // received bytes dropped since reset: overrun or buffer full

// True while a USB cable has taken link0 over from the telemetry connector.
bool usbConnected();

}  // namespace hal
