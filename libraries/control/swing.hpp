// SPDX-License-Identifier: GPL-3.0-or-later
// Notices an axis that its own gains make swing: the rate comes back with the other sign soon,
// again and again, and the surface moves far. Gusts swing a small airplane as fast, but the surface
// of gains that are right hardly moves then.
#pragma once
#include "core/fixed.hpp"

namespace control {

class Swing {
public:
    constexpr Swing() {}

    // What counts: `most` swings, each begun within so many runs of the one before it, and after
    // more than `quick_runs` only with a surface that moves twice as far: gusts are slow, too.
    struct Limits {
        uint8_t most, runs, quick_runs;
    };

    // Run regularly, with the surface's deflection within -1..1. True when it has swung `most`
    // times, and when it has done so again.
    bool watch(core::BodyRate rate_rads, core::Ratio surface, Limits limits);

private:
    int8_t side_ = 0;  // which way it swung last
    uint8_t swings_ = 0, since_ = 0;
    int16_t low_ = 0, high_ = 0;  // of the surface since the last swing
};

}  // namespace control
