// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a mission's landing was flown, by where the airplane touched down.
#pragma once
#include <optional>
#include <string>

namespace simulator {

// Distances from the landing point in m. Empty when all is well; else what is not, in one line.
std::string landingFault(std::optional<double> touchdown_m, double standing_m);

}  // namespace simulator
