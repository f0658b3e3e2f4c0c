// SPDX-License-Identifier: GPL-3.0-or-later
// The World Magnetic Model, evaluated as its report describes ("The US/UK World Magnetic Model for
// 2025-2030", NOAA NCEI and British Geological Survey, section 1.2).
#pragma once
#include <array>
#include <istream>

namespace declination {

struct Field {
    double north_nt, east_nt, down_nt;
    double declination_deg() const;
    double horizontal_nt() const;
};

class Model {
public:
    explicit Model(std::istream& coefficients);  // a file of NOAA's form, WMM.COF; throws

    double epoch() const { return epoch_; }
    // At a place on or above the WGS 84 ellipsoid, in a year such as 2027.5.
    Field at(double latitude_deg, double longitude_deg, double height_km, double year) const;

private:
    static constexpr int kDegree = 12;
    struct Coefficient {
        double g, h, g_per_year, h_per_year;
    };
    using Terms = std::array<std::array<double, kDegree + 1>, kDegree + 1>;
    struct Legendre {
        Terms value, slope;  // Schmidt's seminormalised functions of the sine of the latitude
    };
    static Legendre legendre(double sine, double cosine);

    double epoch_ = 0;
    std::array<std::array<Coefficient, kDegree + 1>, kDegree + 1> coefficients_{};
};

}  // namespace declination
