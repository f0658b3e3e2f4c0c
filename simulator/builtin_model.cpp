// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/builtin_model.hpp"

#include <algorithm>

namespace simulator {

constexpr double kCentre_us = 1500, kTravel_us = 400, kIdle_us = 1100, kFull_us = 1900;

Controls BuiltinModel::controlsOf(const ServoPulses& pulses, bool elevons) {
    const auto deflection = [&pulses](size_t output) {
        return std::clamp((pulses.standing_us[output] - kCentre_us) / kTravel_us, -1.0, 1.0);
    };
    Controls out;
    const double first = deflection(0), second = deflection(1);
    out.aileron = elevons ? (first - second) / 2 : first;
    out.elevator = elevons ? (first + second) / 2 : second;
    out.rudder = elevons ? 0 : deflection(3);
    if (pulses.width_us[2] > 0)
        out.throttle =
            std::clamp((pulses.width_us[2] - kIdle_us) / (kFull_us - kIdle_us), 0.0, 1.0);
    return out;
}

}  // namespace simulator
