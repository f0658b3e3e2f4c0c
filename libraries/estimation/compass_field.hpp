// SPDX-License-Identifier: GPL-3.0-or-later
// What the earth's field is here and what of the compass's reading is the airplane's own: the one
// keeps its direction over the ground when the airplane turns, the other turns along.
#pragma once

#include "core/maths.hpp"

namespace estimation {

class CompassField {
public:
    core::Vector3 earths(const core::Vector3& reading_mg) const { return reading_mg - own_mg_; }
    const core::Vector3& own_mg() const { return own_mg_; }  // body axes

    void start(float horizontal_mg, float down_mg);
    // The field now, own part taken off: along magnetic north, magnetic east and down, with those
    // three directions in body axes. What is unexpected goes to the earth's part slowly, to the
    // airplane's own quickly: flying straight nothing is unexpected for long.
    void learn(const core::Vector3& field_mg, const core::Vector3& north, const core::Vector3& east,
               const core::Vector3& down, float dt_s);

private:
    core::Vector3 own_mg_ = {0, 0, 0};
    float horizontal_mg_ = 0, down_mg_ = 0;
};

}  // namespace estimation
