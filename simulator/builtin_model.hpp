// SPDX-License-Identifier: GPL-3.0-or-later
// The simulator's own airplane behind the board's servo outputs.
#pragma once
#include "simulator/airplane/airplane.hpp"
#include "simulator/flight_model.hpp"

namespace simulator {

class BuiltinModel : public FlightModel {
public:
    BuiltinModel(const WorldOptions& options, double gust_mps)
        : airplane_(loadAirplane(options.airplane), options, gust_mps) {}

    void step(const ServoPulses& pulses) override {
        airplane_.step(controlsOf(pulses, airplane_.parameters()));
    }
    const Truth& truth() const override { return airplane_.truth(); }
    Vec3 toBody(const Vec3& earth) const override { return airplane_.toBody(earth); }
    void launch() override { airplane_.launch(); }
    bool setWind(double mps, double from_deg) override {
        airplane_.setWind(mps, from_deg);
        return true;
    }

    // Outputs 1..4 are aileron, elevator, throttle, rudder, where the airplane has none that are
    // mixed of two (AirplaneParameters).
    static Controls controlsOf(const ServoPulses& pulses, const AirplaneParameters& airplane);

private:
    Airplane airplane_;
};

}  // namespace simulator
