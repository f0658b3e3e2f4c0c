// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/gcs/degrees.hpp"

#include "core/maths.hpp"
#include "core/seldom.hpp"

namespace firmware {
namespace gcs {

int32_t degreesE7(float degrees) {
    if (!(fabsf(degrees) <= 200)) return INT32_MAX;
    // in two steps, as a float has no room for all the digits
    const int32_t whole = static_cast<int32_t>(degrees);
    return whole * 10000000 + core::rounded((degrees - static_cast<float>(whole)) * 1e7f);
}

// Rounded once, where whole and rest are added: a float nearest to the place is up to 0.9 m off.
SELDOM float degreesFromE7(int32_t angle_e7) {
    const int32_t whole = angle_e7 / 10000000;
    return static_cast<float>(whole) + static_cast<float>(angle_e7 - whole * 10000000) * 1e-7f;
}

}  // namespace gcs
}  // namespace firmware
