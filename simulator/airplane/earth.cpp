// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/airplane/earth.hpp"

#include "simulator/constants.hpp"

namespace simulator {
namespace {

constexpr double kEquator_m = 6'378'137.0, kFlattening = 1 / 298.257223563;
constexpr double kEccentricity2 = kFlattening * (2 - kFlattening);

double primeVerticalRadius_m(double latitude_deg) {
    const double sine = std::sin(latitude_deg * kRadians);
    return kEquator_m / std::sqrt(1 - kEccentricity2 * sine * sine);
}
double meridianRadius_m(double latitude_deg) {
    const double n = primeVerticalRadius_m(latitude_deg);
    return n * n * n * (1 - kEccentricity2) / (kEquator_m * kEquator_m);
}

}  // namespace

Place moved(const Place& from, double altitude_m, double north_m, double east_m) {
    const double middle_deg =
        from.latitude_deg +
        north_m / (meridianRadius_m(from.latitude_deg) + altitude_m) / kRadians / 2;
    const double parallel_m =
        (primeVerticalRadius_m(middle_deg) + altitude_m) * std::cos(middle_deg * kRadians);
    const double longitude_deg = from.longitude_deg + east_m / parallel_m / kRadians;
    return {from.latitude_deg + north_m / (meridianRadius_m(middle_deg) + altitude_m) / kRadians,
            std::remainder(longitude_deg, 360.0)};
}

Vec3 ecefPosition_m(double latitude_deg, double longitude_deg, double ellipsoid_height_m) {
    const double n = primeVerticalRadius_m(latitude_deg);
    const double latitude = latitude_deg * kRadians, longitude = longitude_deg * kRadians;
    const double across = (n + ellipsoid_height_m) * std::cos(latitude);
    return {across * std::cos(longitude), across * std::sin(longitude),
            (n * (1 - kEccentricity2) + ellipsoid_height_m) * std::sin(latitude)};
}

Vec3 ecefVelocity_mps(double latitude_deg, double longitude_deg, double north_mps, double east_mps,
                      double down_mps) {
    const double latitude = latitude_deg * kRadians, longitude = longitude_deg * kRadians;
    const double outward = -north_mps * std::sin(latitude) - down_mps * std::cos(latitude);
    return {outward * std::cos(longitude) - east_mps * std::sin(longitude),
            outward * std::sin(longitude) + east_mps * std::cos(longitude),
            north_mps * std::cos(latitude) - down_mps * std::sin(latitude)};
}

Vec3 northEastDown_mg(const MagneticField& field) {
    const double level = field.strength_mg * std::cos(field.inclination_deg * kRadians);
    return {level * std::cos(field.declination_deg * kRadians),
            level * std::sin(field.declination_deg * kRadians),
            field.strength_mg * std::sin(field.inclination_deg * kRadians)};
}

}  // namespace simulator
