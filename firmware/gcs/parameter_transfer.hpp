// SPDX-License-Identifier: GPL-3.0-or-later
// The parameter protocol: list, read, set. https://mavlink.io/en/services/parameter.html
// Values travel as numbers cast to float, whatever the field's type.
#pragma once
#include "mavlink/frame.hpp"

namespace firmware {
namespace gcs {

struct Link;

bool onParamRequestList(Link& link, const mavlink::Frame& frame);
bool onParamRequestRead(Link& link, const mavlink::Frame& frame);
bool onParamSet(Link& link, const mavlink::Frame& frame);
bool refuseParamSet(Link& link, const mavlink::Frame& frame);  // the store stayed busy

// The value now; false: no room. No such index: nothing to send, true.
bool parameterSend(Link& link, uint16_t index);
bool parameterListSend(Link& link);  // the next of a list; false: no list, or no room

}  // namespace gcs
}  // namespace firmware
