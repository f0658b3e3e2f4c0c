// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/gcs/link.hpp"

#include "firmware/mission/mission.hpp"
#include "firmware/notify/text_queue.hpp"
#include "firmware/sensors/sensors.hpp"

namespace firmware {
namespace gcs {

using namespace state;
using namespace mission;
using namespace notify;

static_assert(kLinks == kLogReader, "a reader of texts for each link, then the log");

core::FileState<Links> links{};

// Another board's sense pin says nothing: it is to be heard on USB, and arms for nobody.
bool usbPlugged() { return hal::usbConnected() || sensors::wrongBoard(); }

bool isUsb(const Link& link) { return linkNumber(link) == 0 && usbPlugged(); }

namespace {

bool isSilent(const Link& link) { return telemetryMuted() && !isUsb(link); }

}  // namespace

bool sendPayload(Link& link, const void* payload, const mavlink::Layout& in_flash) {
    if (isSilent(link)) return true;
    // field by field: as a whole it would be copied three times
    const mavlink::Layout layout = {core::romRead(in_flash.id), core::romRead(in_flash.length),
                                    core::romRead(in_flash.length_with_extensions),
                                    core::romRead(in_flash.crc_extra)};
    // an id past 255 and a signature have no MAVLink 1 frame; who asks for them can read the other
    const uint8_t signature = link.signature;
    const mavlink::Framing framing =
        signature != 0 || layout.id > 255 ? mavlink::Framing::v2 : link.framing;
    const mavlink::Outgoing message = mavlink::outgoing(framing, payload, layout);
    const hal::Port port = portOf(link);
    if (hal::serialRoom(port) < mavlink::frameSize(framing, message.length) + signature)
        return false;
    const mavlink::Sender sender = {framing, link.sequence++,
                                    static_cast<uint8_t>(parameters.system_id), kComponent,
                                    signature != 0};
    uint8_t header[mavlink::kHeaderV2];
    const uint8_t header_size = mavlink::writeHeader(sender, message, header);
    hal::linkWriteFrame(port, {header, header_size}, {message.payload, message.length},
                        mavlink::crcBefore(header[0]), message.crc_extra, signature);
    if (signature != 0) link.wake_room = kAnyRoom;
    return true;
}

bool sendAnswer(Link& link, const void* payload, uint8_t answer) {
    return sendPayload(link, payload, kAnswers[answer]);
}

bool textWaits(const Link& link) { return notify::textWaits(linkNumber(link)); }

// Rarely gone through, and large. Inlined, its message burdens every look whether a text waits:
// 0.18 % of the processor.
__attribute__((noinline)) bool sendText(Link& link) {
    mavlink::Statustext message = {};
    Severity severity;
    if (!readText(linkNumber(link), severity, message.text)) return false;
    message.severity = static_cast<uint8_t>(severity);
    if (!send(link, message)) return false;
    textTaken(linkNumber(link));
    return true;
}

}  // namespace gcs
}  // namespace firmware
