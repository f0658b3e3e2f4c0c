// SPDX-License-Identifier: GPL-3.0-or-later
// From the demanded bank and pitch to the surfaces.
#pragma once
#include "core/file_state.hpp"
#include "core/fixed.hpp"

namespace firmware {
namespace control {

struct Surfaces {  // -1..1: right wing down, nose up, nose right
    core::Ratio aileron, elevator, rudder;
    core::Ratio throttle;  // 0..1
};
extern core::FileState<Surfaces> surfaces;

void runAttitudeControl();  // 100 Hz, after the mode and before runOutputs
// What it works with, and what costs too much for 100 Hz:
void runSpeedScaling();  // 20 Hz: the effect of the surfaces at this airspeed, the rates of a turn;
                         // whether an axis oscillates
void runRollGains();     // 5 Hz, as the next two: of the parameters; the fastest rate
void runPitchGains();
void runControlLimits();  // of bank and pitch, the mix of the rudder

// Of a loop, for the log: the rate that is demanded now and the present one, and what the last
// deflection is the sum of. 45 degrees are all of a surface. Yaw demands the rate of a coordinated
// turn and damps, without the rudder's share of the aileron and of the stick.
enum class Loop : uint8_t { roll, pitch, yaw };
struct LoopFigures {
    float demand_cdps, rate_cdps;
    float proportional_cd, integral_cd, feed_forward_cd, derivative_cd;
};
void loopFigures(Loop loop, LoopFigures& to);

// How far the nose is below what is demanded; 0 while the airplane rolls upright or upside down.
core::Angle pitchShort_rad();

// How fast the nose rises beyond what the turn, at this bank and airspeed, turns the body about its
// wings.
core::BodyRate pitchRise_rads();

}  // namespace control
}  // namespace firmware
