// SPDX-License-Identifier: GPL-3.0-or-later
// For the other end of the link (ground station, simulator, tests): a parser that understands
// every message of messages.hpp at its full length. The vehicle's own accepts what it handles.
#pragma once
#include "mavlink/all_messages.hpp"
#include "mavlink/parser.hpp"

namespace mavlink {

struct AllMessages {
    static uint8_t find(uint16_t id, Accepted& to) {
        for (uint8_t row = 0; row < core::count(kAllMessages); ++row) {
            to = core::romRead(kAllMessages[row]);
            if (to.id == id) return row;
        }
        return kNoRow;
    }
};
using PeerParser = Parser<AllMessages, kLongestFrame>;

// The whole frame in `to`; returns its size.
template <class Message>
uint16_t encode(const Sender& sender, const Message& message, uint8_t (&to)[kLongestFrame]) {
    uint16_t size = 0;
    writeFrame(
        [&](const uint8_t* bytes, uint8_t count) {
            memcpy(to + size, bytes, count);
            size = static_cast<uint16_t>(size + count);
        },
        sender, outgoing(sender.framing, message));
    return size;
}

}  // namespace mavlink
