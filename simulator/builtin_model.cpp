// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/builtin_model.hpp"

#include <algorithm>

namespace simulator {

constexpr double kCentre_us = 1500, kTravel_us = 400, kIdle_us = 1100, kFull_us = 1900;

Controls BuiltinModel::controlsOf(const ServoPulses& pulses, const AirplaneParameters& airplane) {
    const auto output = [&pulses](size_t number) {
        return std::clamp((pulses.standing_us[number - 1] - kCentre_us) / kTravel_us, -1.0, 1.0);
    };
    Controls out;
    out.aileron = output(1);
    out.elevator = output(2);
    out.rudder = output(4);
    if (airplane.elevons) {
        out.aileron = 0.5 * (output(1) - output(2));
        out.elevator = 0.5 * (output(1) + output(2));
        out.rudder = 0;
    }
    if (airplane.v_tail) {
        out.elevator = 0.5 * (output(2) + output(4));
        out.rudder = 0.5 * (output(4) - output(2));
    }
    if (airplane.flaperons) {
        out.aileron = 0.5 * (output(5) - output(6));
        out.flap = std::max(0.0, 0.5 * (output(5) + output(6)));
    }
    if (pulses.width_us[2] > 0)
        out.throttle =
            std::clamp((pulses.width_us[2] - kIdle_us) / (kFull_us - kIdle_us), 0.0, 1.0);
    return out;
}

}  // namespace simulator
