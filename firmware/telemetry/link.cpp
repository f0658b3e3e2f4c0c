// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/telemetry/link.hpp"

namespace firmware {

Link links[kLinks];

bool sendMessage(Link& link, mavlink::Framing framing, const mavlink::Outgoing& message) {
    const hal::Port port = portOf(link);
    if (hal::serialRoom(port) < mavlink::frameSize(framing, message.length)) return false;
    const mavlink::Sender sender = {framing, link.sequence++,
                                    static_cast<uint8_t>(parameters.system_id), kComponent};
    mavlink::writeFrame(
        [port](const uint8_t* bytes, uint8_t size) { hal::serialWrite(port, bytes, size); }, sender,
        message);
    return true;
}

}  // namespace firmware
