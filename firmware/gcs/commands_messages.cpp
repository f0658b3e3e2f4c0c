// SPDX-License-Identifier: GPL-3.0-or-later
// Commands that ask for messages.
#include "firmware/gcs/commands_orders.hpp"
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

}  // namespace

uint8_t homePosition(Link& link, Order&) {
    if (!vehicle.home.set) return MavResult::temporarily_rejected;
    return request(link, mavlink::Wire<mavlink::HomePosition>::id);
}

uint8_t requestMessage(Link& link, Order& order) {
    const uint16_t id = number(order.item.param1);
    if (outgoingRow(id) == kNoMessage) return MavResult::unsupported;
    if (id == mavlink::Wire<mavlink::HomePosition>::id) return homePosition(link, order);
    return request(link, id);
}

uint8_t setMessageInterval(Link& link, Order& order) {
    const uint8_t row = outgoingRow(number(order.item.param1));
    if (row == kNoMessage) return MavResult::unsupported;
    const float interval_us = order.item.param2;
    if (!(interval_us >= -1 && interval_us < 1e9f)) return MavResult::denied;
    return whenTrue(setInterval(link, row, static_cast<int32_t>(interval_us)), MavResult::denied);
}

uint8_t getMessageInterval(Link& link, Order& order) {
    mavlink::MessageInterval message = {};
    message.message_id = number(order.item.param1);
    if (message.message_id == kNoNumber) return MavResult::denied;
    const uint8_t row = outgoingRow(message.message_id);
    if (row != kNoMessage) message.interval_us = interval_us(link, row);  // 0: unknown to us
    return whenTrue(send(link, message), MavResult::temporarily_rejected);
}

uint8_t autopilotVersion(Link& link, Order&) {
    return request(link, mavlink::Wire<mavlink::AutopilotVersion>::id);
}

uint8_t protocolVersion(Link& link, Order&) {
    return request(link, mavlink::Wire<mavlink::ProtocolVersion>::id);
}

uint8_t sendBanner(Link&, Order&) {
    sayHello();
    return MavResult::accepted;
}

}  // namespace gcs
}  // namespace firmware
