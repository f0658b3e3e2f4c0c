// SPDX-License-Identifier: GPL-3.0-or-later
// The angle whose sine and cosine are known, by a table in flash: a third of atan2f's cycles, in
// fixed point a tenth.
#pragma once
#include "core/fixed.hpp"

namespace estimation {

// Radians in -pi..pi, within 1.5e-4, of a sine and cosine whose squares sum to one (within 1 %).
float tableAtan2_rad(float sine, float cosine);
core::Angle tableAtan2(core::Ratio sine, core::Ratio cosine);  // as well, within 2e-4

}  // namespace estimation
