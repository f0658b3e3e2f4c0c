// SPDX-License-Identifier: GPL-3.0-or-later
// The circles of a fence, as the firmware stores and sees them, against the geodesics of
// GeographicLib.
#include <GeographicLib/Geodesic.hpp>
#include <cmath>
#include <random>

#include "firmware/mission/fence_line.hpp"
#include "points_rig.hpp"

namespace firmware {
namespace {

geo::Position geodesic(const geo::Position& from, double azimuth_deg, double distance_m) {
    double latitude_deg, longitude_deg;
    GeographicLib::Geodesic::WGS84().Direct(from.latitude_e7 * 1e-7, from.longitude_e7 * 1e-7,
                                            azimuth_deg, distance_m, latitude_deg, longitude_deg);
    return {static_cast<int32_t>(std::lround(latitude_deg * 1e7)),
            static_cast<int32_t>(std::lround(longitude_deg * 1e7))};
}

class Circles : public Points {
protected:
    void SetUp() override {
        fakes::reset();
        Rig::SetUp();
        fenceLineStart();
    }
    static bool holds(const geo::Position& place) {
        Side side = Side::unknown;
        for (int calls = 0; calls < 9 && side == Side::unknown; ++calls) side = fenceSide(place);
        EXPECT_NE(side, Side::unknown);
        return side == Side::inside;
    }
    static void raise(uint16_t command, const geo::Position& centre, float radius_m) {
        ASSERT_EQ(store(mavlink::MavMissionType::fence, {point(command, centre, radius_m)}),
                  MissionResult::accepted);
        for (int calls = 0; calls < 9 && fenceLine() != Line::fit; ++calls) fenceLineFollow();
        ASSERT_EQ(fenceLine(), Line::fit);
    }
};

// Within 0.05 % and 10 cm of the edge either answer will do.
TEST_F(Circles, of_any_size_anywhere_end_where_the_geodesic_does) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> latitude_deg(-80, 80), longitude_deg(-180, 180),
        azimuth_deg(-180, 180), log_radius(std::log(1.0), std::log(10000.0));
    for (int i = 0; i < 1000; ++i) {
        const bool inclusion = i % 2 == 0;
        const double east_deg =
            i % 3 == 0 ? 180 - longitude_deg(random) * 1e-4 : longitude_deg(random);
        const geo::Position centre = {
            static_cast<int32_t>(std::lround(latitude_deg(random) * 1e7)),
            static_cast<int32_t>(std::lround(std::remainder(east_deg, 360.0) * 1e7))};
        const double drawn_m = std::exp(log_radius(random));
        const double radius_m = drawn_m < 250 ? std::round(drawn_m * 10) / 10 : std::round(drawn_m);
        SCOPED_TRACE(testing::Message()
                     << radius_m << " m at " << centre.latitude_e7 << ", " << centre.longitude_e7);
        raise(inclusion ? mavlink::MavCmd::nav_fence_circle_inclusion
                        : mavlink::MavCmd::nav_fence_circle_exclusion,
              centre, static_cast<float>(radius_m));
        const double near_m = radius_m * 5e-4 + 0.1;
        for (int edge = 0; edge < 10; ++edge) {
            const double azimuth = azimuth_deg(random);
            EXPECT_EQ(holds(geodesic(centre, azimuth, radius_m - near_m)), inclusion) << azimuth;
            EXPECT_EQ(holds(geodesic(centre, azimuth, radius_m + near_m)), !inclusion) << azimuth;
        }
        if (HasFailure()) return;
    }
}

}  // namespace
}  // namespace firmware
