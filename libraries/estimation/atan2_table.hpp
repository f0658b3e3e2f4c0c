// SPDX-License-Identifier: GPL-3.0-or-later
// The angle whose sine and cosine are known, by a table in flash: a tenth of atan2f's cycles.
#pragma once
#include "core/fixed.hpp"

namespace estimation {

// Within 2e-4 rad, of a sine and cosine whose squares sum to one (within 1 %).
core::Angle tableAtan2(core::Ratio sine, core::Ratio cosine);

}  // namespace estimation
