// SPDX-License-Identifier: GPL-3.0-or-later
// Places between the float degrees of the older messages and whole 1e-7 degrees.
#pragma once
#include <stdint.h>

namespace firmware {
namespace gcs {

// NaN and what lies off the globe become INT32_MAX, which no range check lets pass.
int32_t degreesE7(float degrees);
float degreesFromE7(int32_t angle_e7);

}  // namespace gcs
}  // namespace firmware
