// SPDX-License-Identifier: GPL-3.0-or-later
#include "host_tests/unit/simulator/invariants/flown.hpp"

namespace simulator::invariants {

Flown stands() {
    Flown flown;
    flown.reports_place = true;
    flown.place.lat = 470000000;
    flown.place.lon = 80000000;
    flown.place.alt = 488000;
    flown.run(30);
    return flown;
}

struct Report {
    const char* name;
    void (*lawful)(Flown&);
    void (*false_one)(Flown&);
};

TEST(StandsStill, reported_motion_of_a_standing_airplane_violates_it) {
    const Report all[] = {
        {"place", [](Flown& flown) { flown.place.lat += 1900; },  // 21 m
         [](Flown& flown) { flown.place.lat += 2100; }},
        {"speed", [](Flown& flown) { flown.place.vx = 290; },
         [](Flown& flown) { flown.place.vx = 310; }},
        {"height", [](Flown& flown) { flown.place.alt += 14500; },
         [](Flown& flown) { flown.place.alt -= 15500; }},
        {"airspeed", [](Flown& flown) { flown.hud.airspeed = 4.9f; },
         [](Flown& flown) { flown.hud.airspeed = 5.1f; }},
    };
    for (const Report& each : all) {
        Flown lawful = stands(), false_one = stands();
        each.lawful(lawful);
        each.false_one(false_one);
        lawful.run(3);
        false_one.run(3);
        EXPECT_EQ(lawful.violated(), "") << each.name;
        EXPECT_EQ(false_one.violated(), "standing_report ") << each.name;
    }
}

TEST(StandsStill, in_wind_an_airspeed_is_allowed) {
    Flown flown = stands();
    flown.now.truth.equivalent_airspeed_mps = 8;
    flown.hud.airspeed = 10;
    flown.run(3);
    EXPECT_EQ(flown.violated(), "");
}

TEST(StandsStill, heights_that_were_zeroed_by_a_failed_barometer_are_excused_until_it_is_armed) {
    for (const bool failed_at_start : {true, false}) {
        Flown flown;
        flown.reports_place = true;
        flown.place = stands().place;
        flown.now.faulty[static_cast<size_t>(Faulty::barometer)] = failed_at_start;
        flown.run(10);
        flown.now.faulty[static_cast<size_t>(Faulty::barometer)] = false;
        flown.place.alt += 100'000;
        flown.run(90);
        EXPECT_EQ(flown.violated().empty(), failed_at_start);
        flown.arm();
        flown.run(20);
        EXPECT_FALSE(flown.violated().empty());
    }
}

TEST(StandsStill, the_first_seconds_and_a_failed_sensor_are_excused) {
    Flown early, faulty = stands();
    early.reports_place = true;
    early.place.lat = 460000000;
    early.place.lon = 80000000;
    early.run(20);
    EXPECT_EQ(early.violated(), "");
    faulty.now.faulty[4] = true;
    faulty.run(1);
    faulty.place.vx = 900;
    faulty.run(50);
    EXPECT_EQ(faulty.violated(), "");
}

}  // namespace simulator::invariants
