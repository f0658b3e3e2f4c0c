// SPDX-License-Identifier: GPL-3.0-or-later
// Places on the WGS 84 ellipsoid near a start, and the magnetic field there.
#pragma once
#include "simulator/airplane/vector.hpp"

namespace simulator {

struct Place {
    double latitude_deg, longitude_deg;
};

// Along the meridian and the parallel at the mean latitude, by the radii of curvature there.
Place moved(const Place& from, double altitude_m, double north_m, double east_m);

Vec3 ecefPosition_m(double latitude_deg, double longitude_deg, double ellipsoid_height_m);
Vec3 ecefVelocity_mps(double latitude_deg, double longitude_deg, double north_mps, double east_mps,
                      double down_mps);

struct MagneticField {
    double declination_deg, inclination_deg, strength_mg;
};
Vec3 northEastDown_mg(const MagneticField& field);

}  // namespace simulator
