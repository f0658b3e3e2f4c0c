// SPDX-License-Identifier: GPL-3.0-or-later
// What the earth's field is here and what of the compass's reading is the airplane's own: the one
// keeps its direction over the ground when the airplane turns, the other turns along.
#pragma once
#include <stdint.h>

#include "core/maths.hpp"

namespace estimation {

class CompassField {
public:
    core::Vector3 earths(const core::Vector3& reading_mg) const { return reading_mg - own_mg_; }
    const core::Vector3& own_mg() const { return own_mg_; }  // body axes
    // For one who takes it, or a part of it, off the readings from now on.
    core::Vector3& own_mg() { return own_mg_; }

    void start(float horizontal_mg, float down_mg);

    // In whole milligauss.
    struct Known {
        int16_t own[3], horizontal, down;
    };
    void save(Known& known) const;
    void resume(const Known& known);

    // What of the field, own part taken off, along magnetic north, magnetic east and down was not
    // expected. The earth's part follows it, and the airplane's own, by learn(), about as quickly:
    // flying straight nothing is unexpected for long, and a turn distinguishes the two.
    core::Vector3 unexpected(const core::Vector3& field_mg, float dt_s);
    void learn(const core::Vector3& unexpected_body_mg, float dt_s);

private:
    core::Vector3 own_mg_ = {0, 0, 0};
    float horizontal_mg_ = 0, down_mg_ = 0;
};

}  // namespace estimation
