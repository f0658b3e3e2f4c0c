// SPDX-License-Identifier: GPL-3.0-or-later
// Height and density from pressure and temperature.
#pragma once

namespace estimation {

// Height of the pressure above where `ground_pa` was measured, in air that cools from the ground's
// temperature as the standard atmosphere does. Within 0.1 % of it up to 3000 m; no logarithm.
float pressureHeight_m(float pressure_pa, float ground_pa, float ground_temperature_c);

// True airspeed / equivalent airspeed.
float trueSpeedRatio(float pressure_pa, float temperature_c);

}  // namespace estimation
