// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/gcs/parameter_transfer.hpp"

#include "firmware/gcs/link.hpp"
#include "firmware/gcs/parameter_guard.hpp"
#include "firmware/notify/status_text.hpp"
#include "firmware/state/parameters.hpp"

namespace firmware {
namespace gcs {

using namespace notify;
using namespace state;

bool parameterSend(Link& link, uint16_t index) {
    mavlink::ParamValue message = {};
    char name[sizeof message.param_id];
    float value;
    uint8_t type;
    if (!parameterAt(index, name, value, type)) return true;
    memcpy(message.param_id, name, sizeof name);
    message.param_value = value;
    message.param_type = type;
    message.param_index = index;
    message.param_count = parameterCount();
    return send(link, message);
}

bool onParamRequestList(Link& link, const mavlink::Frame&) {
    link.next_parameter = 0;
    return true;
}

bool parameterListSend(Link& link) {
    if (link.next_parameter == kNoParameter || !parameterSend(link, link.next_parameter))
        return false;
    if (++link.next_parameter >= parameterCount()) link.next_parameter = kNoParameter;
    return true;
}

bool onParamRequestRead(Link& link, const mavlink::Frame& frame) {
    const auto asked = frame.read<mavlink::ParamRequestRead>();
    uint16_t index = static_cast<uint16_t>(asked.param_index);
    if (asked.param_index < 0 && !parameterFind(asked.param_id, index)) return true;
    return parameterSend(link, index);
}

static void reportRefused(core::Status why) {
    auto text = STATUS_TEXT("Parameter value refused: out of range");
    if (why == core::Status::denied) text = STATUS_TEXT("Parameter refused: armed");
    if (why == core::Status::unsupported) text = STATUS_TEXT("Parameter is read-only");
    sendStatusText(Severity::warning, text);
}

// Whatever comes of it, the answer is the value that is now in force.
bool onParamSet(Link& link, const mavlink::Frame& frame) {
    const auto wanted = frame.read<mavlink::ParamSet>();
    uint16_t index;
    if (!parameterFind(wanted.param_id, index)) {
        sendStatusText(Severity::warning, STATUS_TEXT("No such parameter"));
        return true;
    }
    if (!parameterMayBeSet(link, index)) return parameterSend(link, index);
    const bool changes = parameterChanges(index, wanted.param_value);
    const core::Status status = parameterSetAt(index, wanted.param_value);
    if (status == core::Status::busy) return false;
    if (status != core::Status::ok) reportRefused(status);
    if (changes && status == core::Status::ok) parameterWritten();
    for (Link& other : links)  // who has no room now asks again some day
        if (&other != &link) parameterSend(other, index);
    return parameterSend(link, index);
}

bool refuseParamSet(Link& link, const mavlink::Frame& frame) {
    const auto wanted = frame.read<mavlink::ParamSet>();
    uint16_t index;
    sendStatusText(Severity::warning, STATUS_TEXT("Parameter not set: store busy"));
    return !parameterFind(wanted.param_id, index) || parameterSend(link, index);
}

}  // namespace gcs
}  // namespace firmware
