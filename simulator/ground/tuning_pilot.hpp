// SPDX-License-Identifier: GPL-3.0-or-later
// The sticks of a pilot who flies AUTOTUNE: full roll to either side, then the wings held level and
// the nose up and down. The throttle keeps the height that the elevator leaves.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "simulator/world.hpp"

namespace simulator {

constexpr double kTuneRolls_s = 100, kTuneAll_s = 200;  // then the nose; when he has done
constexpr uint16_t kFirstMode_us = 1165;                // the mode switch on FLTMODE1

// A pilot who knows his airplane: at `cruise_mps` it flies easily, and slower he neither banks it
// steeply nor pulls, but gives it power first.
inline std::array<uint16_t, 8> tuningSticks(double since_s, const Truth& truth, double cruise_mps) {
    constexpr double kLow_m = 60;  // lower the nose is not put down
    const bool other = std::fmod(since_s, 6) >= 3;
    const double speed_mps = truth.equivalent_airspeed_mps;
    const bool slow = speed_mps < 0.85 * cruise_mps;
    int roll = 0, pitch = 0;
    if (since_s < kTuneRolls_s) {
        roll = slow ? 0 : other ? 400 : -400;
        pitch = truth.height_m < 90 && speed_mps > cruise_mps ? 120 : 0;
    } else {
        const bool up = other && !slow;
        pitch = up ? 350 : (truth.height_m > kLow_m ? -350 : 0);
    }
    const double wanted = 0.6 + (100 - truth.height_m) * 0.02 + (cruise_mps - speed_mps) * 0.15;
    const double throttle = std::clamp(wanted, 0.2, 1.0);
    const auto us = [](double by) { return static_cast<uint16_t>(1500 + by); };
    return {us(roll), us(pitch), us(-400 + 800 * throttle), 1500, 1500, 1500, 1500, kFirstMode_us};
}

}  // namespace simulator
