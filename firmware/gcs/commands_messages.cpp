// SPDX-License-Identifier: GPL-3.0-or-later
// Commands that ask for messages.
#include "firmware/gcs/available_modes.hpp"
#include "firmware/gcs/command_handlers.hpp"
#include "firmware/gcs/link.hpp"
#include "firmware/gcs/telemetry.hpp"
#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace gcs {

using namespace state;

namespace {

using mavlink::MavResult;

uint8_t request(Link& link, uint16_t message_id) {
    requestOnce(link, message_id);
    return MavResult::accepted;
}

uint8_t availableModes(Link& link, const CommandRequest& request) {
    const float index = request.item.param2;
    return whenTrue(askForModes(link, isGiven(index) ? number(index) : 0), MavResult::denied);
}

}  // namespace

uint8_t homePosition(Link& link, CommandRequest&) {
    if (!vehicle.home.set) return MavResult::temporarily_rejected;
    return request(link, mavlink::Wire<mavlink::HomePosition>::id);
}

uint8_t requestMessage(Link& link, CommandRequest& request) {
    const uint16_t id = number(request.item.param1);
    if (outgoingRow(id) == kNoMessage) return MavResult::unsupported;
    if (id == mavlink::Wire<mavlink::HomePosition>::id) return homePosition(link, request);
    if (id == mavlink::Wire<mavlink::AvailableModes>::id) return availableModes(link, request);
    return gcs::request(link, id);
}

uint8_t setMessageInterval(Link& link, CommandRequest& request) {
    const uint8_t row = outgoingRow(number(request.item.param1));
    if (row == kNoMessage) return MavResult::unsupported;
    const float interval_us = request.item.param2;
    if (!(interval_us >= -1 && interval_us < 1e9f)) return MavResult::denied;
    return whenTrue(setInterval(link, row, static_cast<int32_t>(interval_us)), MavResult::denied);
}

uint8_t getMessageInterval(Link& link, CommandRequest& request) {
    mavlink::MessageInterval message = {};
    message.message_id = number(request.item.param1);
    if (message.message_id == kNoNumber) return MavResult::denied;
    const uint8_t row = outgoingRow(message.message_id);
    if (row != kNoMessage) message.interval_us = interval_us(link, row);  // 0: unknown to us
    return whenTrue(send(link, message), MavResult::temporarily_rejected);
}

uint8_t autopilotVersion(Link& link, CommandRequest&) {
    return request(link, mavlink::Wire<mavlink::AutopilotVersion>::id);
}

uint8_t protocolVersion(Link& link, CommandRequest&) {
    return request(link, mavlink::Wire<mavlink::ProtocolVersion>::id);
}

uint8_t sendBanner(Link&, CommandRequest&) {
    sendBannerText();
    return MavResult::accepted;
}

}  // namespace gcs
}  // namespace firmware
