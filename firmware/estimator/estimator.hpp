// SPDX-License-Identifier: GPL-3.0-or-later
// Joins the sensors to what is flown by: attitude, place, height, speed, wind.
#pragma once
#include "core/maths.hpp"
#include "firmware/state/restart_record.hpp"

namespace firmware {
namespace estimator {

void runEstimator();  // every frame, after the sensors

core::Vector3 gyroDrift_rads();  // learnt in flight, on top of the calibration

// For flying on after a restart: what is known, and the same again `lost_s` later, when the
// airplane has turned on.
void keepEstimate(state::SteadyRecord& to);
void keepEstimate(state::MovingRecord& to);
void resumeEstimate(const state::SteadyRecord& steady, const state::MovingRecord& moving,
                    const core::Vector3& turned_rad, float lost_s);

void zeroHeight();             // the airplane stands at height 0 now
void shiftHeight(float by_m);  // added to every height from now on

}  // namespace estimator
}  // namespace firmware
