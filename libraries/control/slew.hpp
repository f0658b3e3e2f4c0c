// SPDX-License-Identifier: GPL-3.0-or-later
// A value that follows another no faster than it may.
#pragma once
#include "core/maths.hpp"

namespace control {

inline float slewed(float value, float towards, float step) {
    return core::limit(towards, value - step, value + step);
}

}  // namespace control
