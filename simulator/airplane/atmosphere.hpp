// SPDX-License-Identifier: GPL-3.0-or-later
// The standard atmosphere up to 11 km (ISO 2533).
#pragma once

#include "simulator/constants.hpp"

namespace simulator {

struct Atmosphere {
    double pressure_pa, temperature_k, density_kgm3;
};
Atmosphere atmosphere(double altitude_m);

}  // namespace simulator
