// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/telemetry/link.hpp"

#include "firmware/mission/mission.hpp"

namespace firmware {

Link links[kLinks];

namespace {

bool isSilent(const Link& link) {
    return radioSilenced() && !(linkNumber(link) == 0 && hal::usbConnected());
}

}  // namespace

bool sendMessage(Link& link, mavlink::Framing framing, const mavlink::Outgoing& message) {
    if (isSilent(link)) return true;
    const hal::Port port = portOf(link);
    if (hal::serialRoom(port) < mavlink::frameSize(framing, message.length)) return false;
    const mavlink::Sender sender = {framing, link.sequence++,
                                    static_cast<uint8_t>(parameters.system_id), kComponent};
    uint8_t header[mavlink::kHeaderV2];
    const uint8_t header_size = mavlink::writeHeader(sender, message, header);
    hal::linkWriteFrame(port, {header, header_size}, {message.payload, message.length},
                        mavlink::crcBefore(header[0]), message.crc_extra);
    return true;
}

}  // namespace firmware
