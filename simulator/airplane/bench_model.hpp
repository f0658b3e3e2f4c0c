// SPDX-License-Identifier: GPL-3.0-or-later
// An airplane that does not fly: somebody holds it on the bench, lays it on one side after the
// other and turns it about.
#pragma once
#include "simulator/airplane/vector.hpp"
#include "simulator/flight_model.hpp"

namespace simulator {

class BenchModel : public FlightModel {
public:
    explicit BenchModel(const WorldOptions& options);

    void step(const ServoPulses& pulses) override;
    const Truth& truth() const override { return truth_; }
    Vec3 toBody(const Vec3& earth) const override { return Rotation(attitude_).toBody(earth); }
    // By the shortest way, as fast as a hand turns it.
    void turnTo(double roll_rad, double pitch_rad, double yaw_rad) override;
    // On and on, until it is laid down again.
    void turn(double roll_rads, double pitch_rads, double yaw_rads) override;
    // At once; the height of the bench is 0.
    void lift(double height_m) override;
    // Equivalent airspeed, of a pump at the tube: nothing else sees it.
    void blow(double airspeed_mps) override;

private:
    Vec3 ratesToTarget() const;
    void publish(const Vec3& rates_rads);

    Quaternion attitude_, target_;
    Vec3 turning_rads_;
    bool turns_ = false;
    double bench_altitude_m_;
    Truth truth_{};
};

}  // namespace simulator
