// SPDX-License-Identifier: GPL-3.0-or-later
// Ground stations of before 2020 send fence and rally points one by one (FENCE_POINT, RALLY_POINT).
// ArduPlane has not compiled these messages in since 4.7; here too points come by the mission
// protocol's types, and a station that sends the old messages is answered with a text.
#pragma once
#include "mavlink/frame.hpp"

namespace firmware {
namespace gcs {

struct Link;

bool refuseLegacyPoint(Link& link, const mavlink::Frame& frame);

}  // namespace gcs
}  // namespace firmware
