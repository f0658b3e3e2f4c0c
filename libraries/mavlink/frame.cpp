// SPDX-License-Identifier: GPL-3.0-or-later
#include "mavlink/frame.hpp"

namespace mavlink {

uint8_t writeHeader(const Sender& sender, const Outgoing& message, uint8_t (&to)[kHeaderV2]) {
    const uint8_t id_low = static_cast<uint8_t>(message.id);
    if (sender.framing == Framing::v1) {
        const uint8_t header[kHeaderV1] = {kMagicV1,      message.length,   sender.sequence,
                                           sender.system, sender.component, id_low};
        memcpy(to, header, sizeof header);
        return kHeaderV1;
    }
    const uint8_t id_high = static_cast<uint8_t>(message.id >> 8);
    const uint8_t header[kHeaderV2] = {
        kMagicV2,      message.length,   0,      0,       sender.sequence,
        sender.system, sender.component, id_low, id_high, 0};
    memcpy(to, header, sizeof header);
    return kHeaderV2;
}

void Frame::copyPayload(void* to, uint8_t size) const {
    const uint8_t given = length < size ? length : size;
    memcpy(to, payload, given);
    memset(static_cast<uint8_t*>(to) + given, 0, static_cast<uint8_t>(size - given));
}

}  // namespace mavlink
