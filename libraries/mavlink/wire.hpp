// SPDX-License-Identifier: GPL-3.0-or-later
// What the wire says of a message: its number, its payload length without and with the MAVLink 2
// extension fields, and the checksum seed that stands for its layout (CRC_EXTRA).
#pragma once
#include <stdint.h>

namespace mavlink {

template <uint16_t id_, uint8_t length_, uint8_t length_with_extensions_, uint8_t crc_extra_>
struct Shape {
    static constexpr uint16_t id = id_;
    static constexpr uint8_t length = length_;
    static constexpr uint8_t length_with_extensions = length_with_extensions_;
    static constexpr uint8_t crc_extra = crc_extra_;
};
// In C++14 a constant that is passed by reference needs a place.
template <uint16_t i, uint8_t l, uint8_t e, uint8_t c>
constexpr uint16_t Shape<i, l, e, c>::id;
template <uint16_t i, uint8_t l, uint8_t e, uint8_t c>
constexpr uint8_t Shape<i, l, e, c>::length;
template <uint16_t i, uint8_t l, uint8_t e, uint8_t c>
constexpr uint8_t Shape<i, l, e, c>::length_with_extensions;
template <uint16_t i, uint8_t l, uint8_t e, uint8_t c>
constexpr uint8_t Shape<i, l, e, c>::crc_extra;

// Wire<Heartbeat>::id and so on; messages.hpp has one for every message.
template <class Message>
struct Wire;

// What a sender must know of a message, for code that does not depend on its type.
struct Layout {
    uint16_t id;
    uint8_t length;
    uint8_t length_with_extensions;
    uint8_t crc_extra;
};
template <class Message>
constexpr Layout layoutOf() {
    return {Wire<Message>::id, Wire<Message>::length, Wire<Message>::length_with_extensions,
            Wire<Message>::crc_extra};
}

// What a receiver must know of a message it accepts.
struct Accepted {
    uint16_t id;
    uint8_t length;  // of a MAVLink 1 payload at least
    uint8_t crc_extra;
};
template <class Message>
constexpr Accepted accepts() {
    return {Wire<Message>::id, Wire<Message>::length, Wire<Message>::crc_extra};
}

}  // namespace mavlink
