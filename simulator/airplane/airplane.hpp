// SPDX-License-Identifier: GPL-3.0-or-later
// The airplane as a rigid body in moving air over flat ground: quaternion attitude, six degrees of
// freedom, Runge and Kutta's fourth-order method at a fixed 400 Hz.
#pragma once
#include <cstdint>

#include "simulator/airplane/aerodynamics.hpp"
#include "simulator/airplane/atmosphere.hpp"
#include "simulator/airplane/ground.hpp"
#include "simulator/airplane/propulsion.hpp"
#include "simulator/airplane/servos.hpp"
#include "simulator/airplane/wind.hpp"
#include "simulator/world.hpp"

namespace simulator {

class Airplane {
public:
    static constexpr uint64_t kStep_us = 2500;
    static constexpr double kStep_s = kStep_us * 1e-6;

    Airplane(const AirplaneParameters& parameters, const WorldOptions& options, double gust_mps);
    Airplane(const Airplane&) = delete;
    Airplane& operator=(const Airplane&) = delete;

    void step(const Controls& demand);
    // One that is thrown stands still until this is called, or until its motor has pulled hard for
    // a second, as one throws a model whose motor runs. Nothing to one on wheels.
    void launch();
    // The mean wind at and above 10 m from now on, and where it comes from. Gusts stay as they are.
    void setWind(double mps, double from_deg) { wind_mps_ = mps, wind_from_deg_ = from_deg; }
    const Truth& truth() const { return truth_; }
    Vec3 toBody(const Vec3& earth) const { return Rotation(motion_.attitude).toBody(earth); }
    const AirplaneParameters& parameters() const { return p_; }

    // For tests: puts it somewhere, moving, with these control surfaces and the propeller at
    // the speed that belongs to this throttle.
    void place(const Motion& motion, const Controls& controls);

private:
    struct Derivative {
        Vec3 velocity, acceleration, angular;
        Quaternion turning;
    };
    Flow flow(const Motion& motion, const Rotation& rotation) const;
    Loads loads(const Motion& motion, const Rotation& rotation) const;
    Derivative derivative(const Motion& motion, Vec3* specific_force = nullptr) const;
    void integrate();
    void moveAir();
    void publish();
    void settle();
    void standReady();
    void runUp(const Controls& demand);

    const AirplaneParameters p_;
    const WorldOptions options_;
    double wind_mps_ = options_.wind_mps, wind_from_deg_ = options_.wind_from_deg;
    Servos servos_;
    Propulsion propulsion_;
    Ground ground_;
    Dryden dryden_;
    const Thermals thermals_;
    Motion motion_;
    Derivative now_;  // at motion_
    Vec3 specific_force_;
    Controls controls_;
    Vec3 air_mps_, air_rates_rads_;  // of the air: north, east, down; body
    double density_kgm3_ = kSeaLevelDensity_kgm3;
    double standing_m_;  // height of the centre of gravity on its wheels
    uint64_t steps_ = 0;
    enum class Launch { ready, running, gone } launch_ = Launch::gone;
    int pulling_steps_ = 0;
    Truth truth_{};
};

}  // namespace simulator
