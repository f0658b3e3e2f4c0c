// SPDX-License-Identifier: GPL-3.0-or-later
// The estimates against the derivatives of the simulator's own airplanes, which are held to other
// formulas (host_tests/oracle/airplane). Of these mass, area, span and static margin go in; tail,
// fin and dihedral are the middle of what is drawn.
#include "simulator/drawn/estimate.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace simulator;

namespace {

drawn::Design designOf(const AirplaneParameters& p) {
    drawn::Design d;
    d.mass_kg = p.mass_kg;
    d.wing_loading_kgm2 = p.mass_kg / p.area_m2;
    d.aspect_ratio = p.span_m * p.span_m / p.area_m2;
    d.static_margin = -p.pitch.alpha / p.lift.alpha;
    d.dihedral_deg = 5;
    d.tail_volume = 0.525;
    d.fin_volume = 0.041;
    d.tail_arm_chords = 3.4;
    d.thrust_to_weight = 0.65;
    d.pitch_speed_ratio = 2.25;
    return d;
}

struct Compared {
    const char* name;
    double (*of)(const AirplaneParameters&);
    double share;  // of the airplane's own
};

#define DERIVATIVE(path, share)                                          \
    {                                                                    \
#path, [](const AirplaneParameters& p) { return p.path; }, share \
    }

constexpr Compared kTailed[] = {
    DERIVATIVE(lift.alpha, 0.02),      DERIVATIVE(lift.pitch_rate, 0.12),
    DERIVATIVE(lift.elevator, 0.12),   DERIVATIVE(drag.parasite, 0.05),
    DERIVATIVE(drag.induced, 0.05),    DERIVATIVE(side.beta, 0.1),
    DERIVATIVE(side.yaw_rate, 0.2),    DERIVATIVE(side.rudder, 0.25),
    DERIVATIVE(roll.beta, 0.1),        DERIVATIVE(roll.roll_rate, 0.02),
    DERIVATIVE(roll.yaw_rate, 0.15),   DERIVATIVE(roll.aileron, 0.05),
    DERIVATIVE(pitch.pitch_rate, 0.2), DERIVATIVE(pitch.elevator, 0.15),
    DERIVATIVE(yaw.beta, 0.4),         DERIVATIVE(yaw.yaw_rate, 0.12),
    DERIVATIVE(yaw.aileron, 0.2),      DERIVATIVE(yaw.rudder, 0.4),
    DERIVATIVE(yaw.roll_rate, 1.1),  // that of the trainers is the lower half of what is drawn
    DERIVATIVE(inertia_kgm2.xx, 0.07), DERIVATIVE(inertia_kgm2.yy, 0.26),
    DERIVATIVE(inertia_kgm2.zz, 0.1),  {"stall", drawn::stallSpeed_mps, 0.02},
};
// What a wing alone has; all else is the tail's, of which a flying wing has none.
constexpr Compared kWing[] = {
    DERIVATIVE(lift.alpha, 0.2),    DERIVATIVE(drag.induced, 0.07),
    DERIVATIVE(roll.beta, 0.1),     DERIVATIVE(roll.roll_rate, 0.17),
    DERIVATIVE(roll.aileron, 0.05), {"stall", drawn::stallSpeed_mps, 0.13},
};

template <size_t Count>
void compare(const char* name, const Compared (&all)[Count]) {
    const AirplaneParameters own = loadAirplane(name);
    const AirplaneParameters estimated = drawn::estimate(designOf(own));
    for (const Compared& each : all) {
        const double is = each.of(own);
        EXPECT_NEAR(each.of(estimated), is, each.share * std::abs(is)) << name << ": " << each.name;
    }
}

}  // namespace

TEST(Estimate, is_near_the_derivatives_of_the_two_trainers) {
    compare("trainer_6kg", kTailed);
    compare("foam_trainer", kTailed);
}

TEST(Estimate, is_near_what_a_flying_wing_has_of_its_wing) { compare("flying_wing", kWing); }

TEST(Estimate, has_the_static_margin_that_is_wanted) {
    for (const double margin : {0.07, 0.12, 0.17}) {
        drawn::Design design = designOf(loadAirplane("trainer_6kg"));
        design.static_margin = margin;
        const AirplaneParameters p = drawn::estimate(design);
        EXPECT_NEAR(-p.pitch.alpha / p.lift.alpha, margin, 1e-9);
    }
}
