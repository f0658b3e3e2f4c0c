// SPDX-License-Identifier: GPL-3.0-or-later
#include "toolchain/declination/model.hpp"

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

namespace declination {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kRadians = kPi / 180;
constexpr double kReference_km = 6371.2;
// WGS 84
constexpr double kEquator_km = 6378.137;
constexpr double kFlattening = 1 / 298.257223563;

}  // namespace

double Field::declination_deg() const { return std::atan2(east_nt, north_nt) / kRadians; }
double Field::horizontal_nt() const { return std::hypot(north_nt, east_nt); }

Model::Model(std::istream& coefficients) {
    std::string line;
    std::getline(coefficients, line);
    if (!(std::istringstream(line) >> epoch_)) throw std::runtime_error("no epoch in line 1");
    int read = 0;
    while (std::getline(coefficients, line)) {
        std::istringstream words(line);
        int n = 0, m = 0;
        Coefficient c{};
        if (!(words >> n >> m >> c.g >> c.h >> c.g_per_year >> c.h_per_year)) break;
        if (n < 1 || n > kDegree || m < 0 || m > n) throw std::runtime_error("no term: " + line);
        coefficients_[n][m] = c;
        ++read;
    }
    constexpr int kTerms = kDegree * (kDegree + 3) / 2;
    if (read != kTerms) throw std::runtime_error("not a model of degree 12");
}

// By the usual recursions, with the slope to the latitude.
Model::Legendre Model::legendre(double sine, double cosine) {
    Legendre l{};
    Terms &p = l.value, &d = l.slope;
    p[0][0] = 1;
    for (int n = 1; n <= kDegree; ++n) {
        for (int m = 0; m < n; ++m) {
            const double root = std::sqrt(n * n - m * m);
            const double older = n > 1 && m < n - 1 ? std::sqrt((n - 1) * (n - 1) - m * m) : 0;
            const double p2 = n > 1 ? p[n - 2][m] : 0, d2 = n > 1 ? d[n - 2][m] : 0;
            p[n][m] = ((2 * n - 1) * sine * p[n - 1][m] - older * p2) / root;
            d[n][m] =
                ((2 * n - 1) * (sine * d[n - 1][m] + cosine * p[n - 1][m]) - older * d2) / root;
        }
        const double k = n == 1 ? 1 : std::sqrt((2.0 * n - 1) / (2.0 * n));
        p[n][n] = k * cosine * p[n - 1][n - 1];
        d[n][n] = k * (cosine * d[n - 1][n - 1] - sine * p[n - 1][n - 1]);
    }
    return l;
}

Field Model::at(double latitude_deg, double longitude_deg, double height_km, double year) const {
    const double latitude = latitude_deg * kRadians, longitude = longitude_deg * kRadians;
    const double e2 = kFlattening * (2 - kFlattening);
    const double curvature_km =
        kEquator_km / std::sqrt(1 - e2 * std::sin(latitude) * std::sin(latitude));
    const double aside_km = (curvature_km + height_km) * std::cos(latitude);
    const double up_km = (curvature_km * (1 - e2) + height_km) * std::sin(latitude);
    const double radius_km = std::hypot(aside_km, up_km);
    const double sine = up_km / radius_km, cosine = aside_km / radius_km;
    const Legendre l = legendre(sine, cosine);
    double north = 0, east = 0, down = 0;
    for (int n = 1; n <= kDegree; ++n) {
        const double scale = std::pow(kReference_km / radius_km, n + 2);
        for (int m = 0; m <= n; ++m) {
            const Coefficient& c = coefficients_[n][m];
            const double g = c.g + c.g_per_year * (year - epoch_);
            const double h = c.h + c.h_per_year * (year - epoch_);
            const double along = g * std::cos(m * longitude) + h * std::sin(m * longitude);
            const double across = g * std::sin(m * longitude) - h * std::cos(m * longitude);
            north -= scale * along * l.slope[n][m];
            east += scale * m * across * l.value[n][m] / cosine;
            down -= scale * (n + 1) * along * l.value[n][m];
        }
    }
    // from the sphere's horizon to the ellipsoid's
    const double tilt = std::asin(sine) - latitude;
    return {north * std::cos(tilt) - down * std::sin(tilt), east,
            north * std::sin(tilt) + down * std::cos(tilt)};
}

}  // namespace declination
