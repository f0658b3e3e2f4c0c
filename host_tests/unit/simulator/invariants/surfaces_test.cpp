// SPDX-License-Identifier: GPL-3.0-or-later
#include "host_tests/unit/simulator/invariants/flown.hpp"

namespace simulator::invariants {

namespace {

Flown steady() {
    Flown flown;
    flown.run(2);
    flown.inTheAir();
    flown.run(3);
    return flown;
}
Flown atTheStop() {
    Flown flown = steady();
    flown.now.servo_us[1] = 1900;
    return flown;
}

TEST(SurfacesOffTheirStops, two_seconds_at_a_stop_violate_it) {
    Flown long_enough = atTheStop(), too_long = atTheStop();
    long_enough.run(1.9);
    long_enough.now.servo_us[1] = 1890;
    long_enough.run(3);
    too_long.run(2.2);
    EXPECT_EQ(long_enough.violated(), "");
    EXPECT_EQ(too_long.violated(), "surface_at_its_stop ");
}

TEST(SurfacesOffTheirStops, the_stop_is_where_the_parameters_set_it) {
    Flown wider = atTheStop(), narrower = atTheStop();
    wider.parameter("RC2_MAX", 2000);
    narrower.parameter("RC2_MAX", 1700);
    narrower.now.servo_us[1] = 1699;
    wider.run(4);
    narrower.run(4);
    EXPECT_EQ(wider.violated(), "");
    EXPECT_EQ(narrower.violated(), "surface_at_its_stop ");
}

struct Excuse {
    const char* name;
    void (*give)(Flown&);
};
TEST(SurfacesOffTheirStops, a_cause_outside_the_firmware_excuses_it) {
    const Excuse excuses[] = {
        {"MANUAL", [](Flown& flown) { flown.mode = 0; }},
        {"the pilot's stick", [](Flown& flown) { flown.now.stick_us[1] = 1900; }},
        {"the inertial sensor", [](Flown& flown) { flown.now.faulty[0] = true; }},
        {"too slow", [](Flown& flown) { flown.now.truth.airspeed_mps = 5; }},
        {"an output set by command",
         [](Flown& flown) { flown.command(mavlink::MavCmd::do_set_servo, 2, 1900); }},
    };
    for (const Excuse& excuse : excuses) {
        Flown flown = atTheStop();
        excuse.give(flown);
        flown.run(4);
        EXPECT_EQ(flown.violated().find("surface"), std::string::npos) << excuse.name;
    }
}

TEST(SurfacesOffTheirStops, a_faulty_compass_is_no_excuse) {
    Flown flown = atTheStop();
    flown.now.faulty[3] = true;
    flown.run(4);
    EXPECT_EQ(flown.violated(), "surface_at_its_stop ");
}

// Aileron from one side to the other every 0.4 s.
void swing(Flown& flown, int changes, double travel_us = 300) {
    for (int i = 0; i < changes; ++i) {
        flown.now.servo_us[0] = i % 2 == 0 ? 1500 + travel_us : 1500 - travel_us;
        flown.run(0.4);
    }
    flown.now.servo_us[0] = 1500;
}

TEST(SurfacesDoNotSwing, nine_changes_of_side_in_ten_seconds_violate_it) {
    Flown few = steady(), many = steady(), small = steady(), slow = steady();
    swing(few, 8);
    few.run(7);  // the first of them is forgotten
    swing(few, 8);
    swing(many, 9);
    swing(small, 30, 180);
    for (int i = 0; i < 10; ++i) {
        swing(slow, 1, i % 2 == 0 ? 300 : -300);
        slow.run(1);
    }
    EXPECT_EQ(few.violated(), "");
    EXPECT_EQ(many.violated(), "surface_swings ");
    EXPECT_EQ(small.violated(), "");
    EXPECT_EQ(slow.violated(), "");
}

TEST(SurfacesDoNotSwing, a_cause_outside_the_firmware_excuses_it) {
    const Excuse excuses[] = {
        {"AUTOTUNE", [](Flown& flown) { flown.mode = 8; }},
        {"the receiver", [](Flown& flown) { flown.now.faulty[5] = true; }},
        {"the inertial sensor", [](Flown& flown) { flown.now.faulty[0] = true; }},
        {"the pilot's stick", [](Flown& flown) { flown.now.stick_us[1] = 1900; }},
    };
    for (const Excuse& excuse : excuses) {
        Flown flown = steady();
        excuse.give(flown);
        flown.run(2);
        swing(flown, 20);
        EXPECT_EQ(flown.violated().find("surface"), std::string::npos) << excuse.name;
    }
    Flown compass = steady();
    compass.now.faulty[3] = true;
    swing(compass, 20);
    EXPECT_EQ(compass.violated(), "surface_swings ");
}

}  // namespace
}  // namespace simulator::invariants
