// SPDX-License-Identifier: GPL-3.0-or-later
// Frames as the tests send and receive them.
#pragma once
#include <vector>

#include "mavlink/peer.hpp"

namespace test {

using Bytes = std::vector<uint8_t>;

template <class Message>
Bytes frame(const mavlink::Sender& sender, const Message& message) {
    uint8_t bytes[mavlink::kLongestFrame];
    const uint16_t size = mavlink::encode(sender, message, bytes);
    return Bytes(bytes, bytes + size);
}

inline Bytes operator+(Bytes a, const Bytes& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

// A frame whose checksum is right for the bytes given: header from the magic on, and payload.
inline Bytes sealed(Bytes bytes, uint8_t crc_extra) {
    uint16_t crc =
        core::crc16(core::kCrcStart, bytes.data() + 1, static_cast<uint16_t>(bytes.size() - 1));
    crc = core::crc16(crc, crc_extra);
    bytes.push_back(static_cast<uint8_t>(crc));
    bytes.push_back(static_cast<uint8_t>(crc >> 8));
    return bytes;
}

}  // namespace test
