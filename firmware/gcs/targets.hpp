// SPDX-License-Identifier: GPL-3.0-or-later
// Where to fly, sent as a message that has no answer (SET_POSITION_TARGET_...): GUIDED goes to a
// place or a height, as by DO_REPOSITION; speeds, accelerations and attitudes are not flown. What
// is not obeyed is answered by a text, every four seconds at most.
#pragma once
#include "mavlink/frame.hpp"

namespace firmware {
namespace gcs {

struct Link;

bool onPositionTarget(Link& link, const mavlink::Frame& frame);  // ..._GLOBAL_INT, ..._LOCAL_NED
bool refuseTarget(Link& link, const mavlink::Frame& frame);

}  // namespace gcs
}  // namespace firmware
