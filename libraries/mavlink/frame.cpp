// SPDX-License-Identifier: GPL-3.0-or-later
#include "mavlink/frame.hpp"

namespace mavlink {

uint8_t writeHeader(const Sender& sender, const Outgoing& message, uint8_t (&to)[kHeaderV2]) {
    to[1] = message.length;
    if (sender.framing == Framing::v1) {
        to[0] = kMagicV1;
        to[2] = sender.sequence;
        to[3] = sender.system;
        to[4] = sender.component;
        to[5] = static_cast<uint8_t>(message.id);
        return kHeaderV1;
    }
    to[0] = kMagicV2;
    to[2] = sender.is_signed ? kSignedFlag : 0;
    to[3] = 0;
    to[4] = sender.sequence;
    to[5] = sender.system;
    to[6] = sender.component;
    to[7] = static_cast<uint8_t>(message.id);
    to[8] = static_cast<uint8_t>(message.id >> 8);
    to[9] = 0;
    return kHeaderV2;
}

void Frame::copyPayload(void* to, uint8_t size) const {
    const uint8_t given = length < size ? length : size;
    memcpy(to, payload, given);
    memset(static_cast<uint8_t*>(to) + given, 0, static_cast<uint8_t>(size - given));
}

}  // namespace mavlink
