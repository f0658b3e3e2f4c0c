// SPDX-License-Identifier: GPL-3.0-or-later
#include "host_tests/unit/simulator/invariants/flown.hpp"

namespace simulator::invariants {

Flown atTheStop() {
    Flown flown;
    flown.run(2);
    flown.inTheAir();
    flown.run(3);
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

}  // namespace simulator::invariants
