// SPDX-License-Identifier: GPL-3.0-or-later
// An airplane from the few figures a designer begins with: masses, derivatives and propulsion as
// the estimates of textbooks give them (Nelson, Flight Stability and Automatic Control, chapters 2,
// 3 and 5; Roskam, Airplane Design VI; Drela's DC motor and propeller models).
#pragma once
#include "simulator/airplane/parameters.hpp"

namespace simulator::drawn {

struct Design {
    double mass_kg = 0, wing_loading_kgm2 = 0, aspect_ratio = 0;
    double static_margin = 0;  // of the chord, the centre of gravity ahead of the neutral point
    double dihedral_deg = 0;   // with what a high wing adds
    double tail_volume = 0, fin_volume = 0;
    double tail_arm_chords = 0;    // of both, in chords
    double thrust_to_weight = 0;   // standing, at sea level
    double pitch_speed_ratio = 0;  // the propeller's pitch speed by the cruising speed
    bool thrown = false;           // no wheels
};

double stallSpeed_mps(const AirplaneParameters& airplane);  // equivalent airspeed, wings level
// The steepest climb that its motor sustains at `airspeed_mps`, height by distance.
double climbGradient(const AirplaneParameters& airplane, double airspeed_mps, double density_kgm3);

AirplaneParameters estimate(const Design& design);
// Its propeller, motor and battery anew.
void givePropulsion(AirplaneParameters& airplane, const Design& design);

}  // namespace simulator::drawn
