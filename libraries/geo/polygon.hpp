// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a place lies inside a polygon, exactly, in whole 1e-7 degrees. Edges are straight lines
// of latitude and longitude, as a chart in Mercator's or the plain projection nearly shows them.
#pragma once
#include "geo/position.hpp"

namespace geo {

// True when the parallel from `place` eastward crosses this edge. A place lies inside when an odd
// number of a polygon's edges is crossed; of a place on an edge the answer is one of the two.
// `origin` is the same place for all edges: nothing of the polygon may lie 180 degrees or more from
// it, so any corner serves.
bool crossesEdge(const Position& origin, const Position& from, const Position& to,
                 const Position& place);

}  // namespace geo
