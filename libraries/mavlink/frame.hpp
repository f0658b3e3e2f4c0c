// SPDX-License-Identifier: GPL-3.0-or-later
// The two framings of the protocol, and writing a message in either of them straight into a byte
// sink: the payload struct is sent from where it stands, no frame is ever assembled.
// https://mavlink.io/en/guide/serialization.html
#pragma once
#include <stdint.h>
#include <string.h>

#include "core/crc.hpp"
#include "mavlink/wire.hpp"

namespace mavlink {

enum class Framing : uint8_t { v1, v2 };

constexpr uint8_t kMagicV1 = 0xFE;
constexpr uint8_t kMagicV2 = 0xFD;
constexpr uint8_t kHeaderV1 = 6;   // magic length sequence system component id
constexpr uint8_t kHeaderV2 = 10;  // magic length incompat compat sequence system component id(3)
constexpr uint8_t kLengthAt = 1;
constexpr uint8_t kChecksum = 2;
constexpr uint8_t kSignature = 13;
constexpr uint8_t kSignedFlag = 0x01;  // the only incompat flag there is
constexpr uint16_t kLongestFrame = kHeaderV2 + 255 + kChecksum + kSignature;

struct Sender {
    Framing framing;
    uint8_t sequence;
    uint8_t system;
    uint8_t component;
    bool is_signed = false;  // version 2 only: the flag, not the signature
};

// A message as it will be sent: how much of its payload, and what identifies it.
struct Outgoing {
    const uint8_t* payload;
    uint16_t id;
    uint8_t length;
    uint8_t crc_extra;
};

// MAVLink 2 leaves out the zeros at the end of the payload, but for one byte.
inline uint8_t withoutTrailingZeros(const uint8_t* payload, uint8_t length) {
    while (length > 1 && payload[length - 1] == 0) --length;
    return length;
}

inline Outgoing outgoing(Framing framing, const void* message, const Layout& layout) {
    const uint8_t* payload = static_cast<const uint8_t*>(message);
    const uint8_t length = framing == Framing::v1
                               ? layout.length
                               : withoutTrailingZeros(payload, layout.length_with_extensions);
    return {payload, layout.id, length, layout.crc_extra};
}
template <class Message>
Outgoing outgoing(Framing framing, const Message& message) {
    return outgoing(framing, &message, layoutOf<Message>());
}

inline uint16_t frameSize(Framing framing, uint8_t payload_length) {
    const uint8_t overhead = (framing == Framing::v1 ? kHeaderV1 : kHeaderV2) + kChecksum;
    return static_cast<uint16_t>(overhead + payload_length);
}

// Fills in the header; returns its length.
uint8_t writeHeader(const Sender& sender, const Outgoing& message, uint8_t (&to)[kHeaderV2]);

// Of a checksum that is not touched by the byte a frame begins with, which does not count.
constexpr uint16_t crcBefore(uint8_t magic) { return static_cast<uint16_t>(0x3078 ^ magic); }
static_assert(core::crc16(crcBefore(kMagicV1), kMagicV1) == core::kCrcStart, "MAVLink 1");
static_assert(core::crc16(crcBefore(kMagicV2), kMagicV2) == core::kCrcStart, "MAVLink 2");

// Three calls of sink(const uint8_t* bytes, uint8_t size): header, payload, checksum.
template <class Sink>
void writeFrame(Sink&& sink, const Sender& sender, const Outgoing& message) {
    uint8_t header[kHeaderV2];
    const uint8_t header_size = writeHeader(sender, message, header);
    uint16_t crc = core::crc16(crcBefore(header[0]), header, header_size);
    crc = core::crc16(crc, message.payload, message.length);
    crc = core::crc16(crc, message.crc_extra);
    sink(header, header_size);
    sink(message.payload, message.length);
    const uint8_t checksum[kChecksum] = {static_cast<uint8_t>(crc), static_cast<uint8_t>(crc >> 8)};
    sink(checksum, kChecksum);
}

// A whole received frame; valid until the parser is given the next byte.
struct Frame {
    const uint8_t* payload;
    uint16_t id;
    uint8_t length;
    uint8_t row;  // of the table the parser accepts
    Framing framing;
    uint8_t sequence;
    uint8_t system;
    uint8_t component;

    // Bytes that were not sent read as zero; bytes of extensions younger than ours are dropped.
    void copyPayload(void* to, uint8_t size) const;
    template <class Message>
    Message read() const {
        Message message;
        copyPayload(&message, sizeof message);
        return message;
    }
};

}  // namespace mavlink
