// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/report/track_files.hpp"

#include <gmock/gmock.h>

using namespace simulator;
using testing::HasSubstr;
using testing::Not;

static std::vector<Sample> one() {
    Sample sample{};
    sample.time_s = 61.5;
    sample.truth.latitude_deg = 47.4;
    sample.truth.longitude_deg = 8.5;
    sample.truth.altitude_m = 500;
    return {sample};
}

static DocumentPlan plan() {
    DocumentPlan made;
    made.items = {{2, "WAYPOINT", "a < b", DocumentPlace{47.5, 8.6, 548.0}, {}},
                  {3, "DO_CHANGE_SPEED", "13 m/s", {}, {}}};
    return made;
}

TEST(Kml, has_times_along_the_track) {
    const std::string kml = trackKml(one(), plan(), "flight", kSimulatedEpoch_s);

    EXPECT_THAT(kml, HasSubstr("<gx:Track>"));
    EXPECT_THAT(kml, HasSubstr("<when>2024-06-03T10:01:01.5Z</when>"));
    EXPECT_THAT(kml, HasSubstr("<gx:coord>8.5000000 47.4000000 500.0</gx:coord>"));
}

TEST(Kml, has_a_pin_for_every_place_of_the_mission) {
    const std::string kml = trackKml(one(), plan(), "flight", kSimulatedEpoch_s);

    EXPECT_THAT(kml, HasSubstr("<name>2 WAYPOINT</name><description>a &lt; b</description>"));
    EXPECT_THAT(kml, HasSubstr("<coordinates>8.6000000,47.5000000,548.0</coordinates></Point>"));
    EXPECT_THAT(kml, Not(HasSubstr("DO_CHANGE_SPEED")));
}

TEST(Gpx, has_the_track_with_times_and_the_waypoints) {
    const std::string gpx = trackGpx(one(), plan(), "flight", kSimulatedEpoch_s);

    EXPECT_THAT(gpx, HasSubstr("<wpt lat=\"47.5000000\" lon=\"8.6000000\"><ele>548.0</ele>"
                               "<name>2 WAYPOINT</name><desc>a &lt; b</desc></wpt>"));
    EXPECT_THAT(gpx, HasSubstr("<trkpt lat=\"47.4000000\" lon=\"8.5000000\"><ele>500.0</ele>"
                               "<time>2024-06-03T10:01:01.5Z</time></trkpt>"));
}
