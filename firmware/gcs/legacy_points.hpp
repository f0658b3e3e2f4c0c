// SPDX-License-Identifier: GPL-3.0-or-later
// Fence and rally points one by one, as ground stations of before the mission protocol's types send
// them (FENCE_POINT, RALLY_POINT). Point 0 of a fence is the return point, the last one is the
// first corner again and is not stored. Each change of a point stores the whole list anew.
#pragma once
#include "firmware/mission/lists.hpp"
#include "mavlink/frame.hpp"

namespace firmware {
namespace gcs {

struct Link;

bool onFencePoint(Link& link, const mavlink::Frame& frame);
bool onFenceFetchPoint(Link& link, const mavlink::Frame& frame);
bool onRallyPoint(Link& link, const mavlink::Frame& frame);
bool onRallyFetchPoint(Link& link, const mavlink::Frame& frame);
bool refusePoint(Link& link, const mavlink::Frame& frame);  // the store stayed busy

// FENCE_TOTAL, RALLY_TOTAL: cuts the list off, or adds blank points. To be called with the same
// arguments until it is not busy.
bool fenceTakesTotal(uint8_t total);
MUST_USE core::Status resizePoints(mission::ListKind kind, uint8_t total);

}  // namespace gcs
}  // namespace firmware
