// SPDX-License-Identifier: GPL-3.0-or-later
// Moving air: a mean wind with a logarithmic profile below 10 m, and Dryden turbulence with the
// low-altitude lengths and intensities of MIL-F-8785C, section 3.7.3.
#pragma once
#include <cstdint>

#include "simulator/airplane/vector.hpp"
#include "simulator/devices/random.hpp"

namespace simulator {

// Where the air moves to: north, east, down.
Vec3 meanWind_mps(double wind_mps, double from_deg, double height_m);

// Gusts as the airplane meets them, in its heading axes (forward, right, down).
struct Gust {
    Vec3 velocity_mps;
    Vec3 rates_rads;  // of the air about the body axes
};

// Thermals and the sinking air between them, side by side in both directions and as strong; they
// begin at the ground and have their whole strength from 60 m on.
class Thermals {
public:
    Thermals(double strength_mps, uint64_t seed);

    double rise_mps(double north_m, double east_m, double height_m) const;

private:
    double strength_mps_;
    double north_wave_m_, east_wave_m_, north_phase_, east_phase_;
};

class Dryden {
public:
    // `deviation_mps` is the RMS of the forward and of the sideward gust.
    Dryden(double deviation_mps, double span_m, uint64_t seed);

    const Gust& advance(double dt_s, double airspeed_mps, double height_m);

private:
    // A white-noise-driven lag, and a second lag behind it.
    struct Lags {
        double first, second;
        explicit Lags(Random& random);  // as after a long time
        void advance(double dt_s, double time_s, Random& random);
    };

    double deviation_mps_, span_m_;
    Random random_;
    Lags forward_{random_}, right_{random_}, down_{random_}, roll_{random_};
    double right_lag_ = 0, down_lag_ = 0;
    Gust gust_;
};

}  // namespace simulator
