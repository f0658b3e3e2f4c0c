// SPDX-License-Identifier: GPL-3.0-or-later
// Each airplane of simulator/airplanes against the textbook's formulas for its derivatives. What is
// expected comes from the data alone; what is found is flown.
#include <gtest/gtest.h>

#include <ostream>

#include "flying.hpp"

using namespace simulator;

namespace {

constexpr double kDensity = 1.225;

struct Case {
    const char* airplane;
    double cruise_mps, stall_mps;
    double roll_error;  // of the roll rate, as a part of it
    double spiral_rad;  // the bank after 20 s, begun at 0.2
};
void PrintTo(const Case& one, std::ostream* to) { *to << one.airplane; }

class EveryAirplane : public testing::TestWithParam<Case> {
protected:
    const AirplaneParameters whole_ = loadAirplane(GetParam().airplane);
    const AirplaneParameters p_ = symmetric(whole_);
    const double cruise_mps_ = GetParam().cruise_mps;
    const double density_ = atmosphere(500).density_kgm3;  // where it is flown
    const Trim trim_ = trimmed(p_, cruise_mps_, density_);

    // In cruise, faster or steeper by so much, hands off.
    void put(Airplane& airplane, double faster_mps = 0, double steeper_rad = 0) const {
        airplane.place(levelFlight(cruise_mps_ + faster_mps, trim_.alpha_rad + steeper_rad, 500),
                       trim_.controls);
    }
    const std::function<Controls(const Truth&)> hands_off_ = [this](const Truth&) {
        return trim_.controls;
    };
    double pressureArea() const { return 0.5 * density_ * cruise_mps_ * cruise_mps_ * p_.area_m2; }
};

// Of angle of attack and pitch rate, in seconds (Etkin and Reid, Dynamics of Flight, section 4.9).
struct PitchDerivatives {
    double za, zq, ma, mq;
};
PitchDerivatives pitchDerivatives(const AirplaneParameters& p, double speed_mps, double qs) {
    const double chord_s = p.chord_m / (2 * speed_mps), momentum = p.mass_kg * speed_mps;
    return {-qs * (p.lift.alpha + p.drag.parasite) / momentum,
            -qs * chord_s * p.lift.pitch_rate / momentum,
            qs * p.chord_m * p.pitch.alpha / p.inertia_kgm2.yy,
            qs * p.chord_m * chord_s * p.pitch.pitch_rate / p.inertia_kgm2.yy};
}

Controls wild(const Truth& t) {
    const double s = seconds(t);
    return {0.5 * std::sin(3 * s), 0.25 * std::sin(4 * s + 1), 0.4 * std::sin(2 * s),
            0.5 + 0.4 * std::sin(s)};
}

Vec3 velocityOf(const Truth& t) {
    return {t.velocity_north_mps, t.velocity_east_mps, t.velocity_down_mps};
}
Vec3 forceOf(const Truth& t) { return {t.force_x_mss, t.force_y_mss, t.force_z_mss}; }
Rotation attitudeOf(const Truth& t) {
    return Rotation(quaternion(t.roll_rad, t.pitch_rad, t.yaw_rad));
}

double energy_j(const AirplaneParameters& p, const Truth& t) {
    return p.mass_kg * (0.5 * dot(velocityOf(t), velocityOf(t)) + kGravity_mss * t.height_m);
}

}  // namespace

TEST_P(EveryAirplane, flies_level_hands_off_at_its_trim) {
    for (const double factor : {0.84, 1.0, 1.28}) {
        const double speed_mps = factor * cruise_mps_;
        const Trim trim = trimmed(p_, speed_mps, density_);
        Airplane airplane(p_, stillAir(), 0);
        airplane.place(levelFlight(speed_mps, trim.alpha_rad, 500), trim.controls);
        fly(airplane, 30, [&](const Truth&) { return trim.controls; });
        EXPECT_NEAR(airplane.truth().airspeed_mps, speed_mps, 0.1);
        EXPECT_NEAR(airplane.truth().velocity_down_mps, 0, 0.15);
        EXPECT_NEAR(airplane.truth().roll_rad, 0, 1e-6);
    }
}

TEST_P(EveryAirplane, cruises_at_a_throttle_and_an_elevator_that_leave_room) {
    EXPECT_GT(trim_.controls.throttle, 0.3);
    EXPECT_LT(trim_.controls.throttle, 0.6);
    EXPECT_NEAR(trim_.controls.elevator, 0, 0.12);
    const double glide = trim_.lift_coefficient / trim_.drag_coefficient;
    EXPECT_GT(glide, 6);
    EXPECT_LT(glide, 12);
}

// m g = rho / 2 V^2 S CLmax, with the lift that is left when the elevator holds the nose there.
TEST_P(EveryAirplane, stalls_at_the_speed_of_its_largest_lift) {
    double most = 0;
    for (double alpha = 0; alpha < 0.6; alpha += 0.001) {
        const double elevator =
            -(p_.pitch.at_zero + p_.pitch.alpha * std::sin(alpha)) / p_.pitch.elevator;
        most = std::max(most, polar(p_, alpha).lift + p_.lift.elevator * elevator);
    }
    const double stall_mps =
        std::sqrt(2 * p_.mass_kg * kGravity_mss / (density_ * p_.area_m2 * most));
    EXPECT_NEAR(stall_mps * std::sqrt(density_ / kDensity), GetParam().stall_mps, 0.2);

    Airplane airplane(p_, stillAir(), 0);
    put(airplane);
    double found_mps = 0, steepest_rad = 0;
    fly(
        airplane, 40,
        [](const Truth& t) {  // holds height with the elevator, motor off, until it can not
            return holdAttitude(t, t.alpha_rad + 0.15 * t.velocity_down_mps, 0);
        },
        [&](const Truth& t) {
            if (found_mps == 0 && t.velocity_down_mps > 1.5) found_mps = t.airspeed_mps;
            steepest_rad = std::max(steepest_rad, t.alpha_rad);
        });
    EXPECT_NEAR(found_mps, stall_mps, 0.1 * stall_mps);
    EXPECT_GT(steepest_rad, 0.22);
}

// Lanchester's pi sqrt(2) V / g, lengthened by the pitch damping, which is strong in so light an
// airplane (McRuer, Ashkenas, Graham: Aircraft Dynamics and Automatic Control, three degrees of
// freedom: w^2 = g Zu Mw / (U Mw - Zw Mq)).
TEST_P(EveryAirplane, has_the_textbooks_phugoid) {
    Airplane airplane(p_, stillAir(), 0);
    put(airplane, 1);
    std::vector<double> peaks_s, peaks_mps;
    double before = 0, last = 0;
    fly(airplane, 30, hands_off_, [&](const Truth& t) {
        if (seconds(t) > 2 && last > before && t.airspeed_mps < last) {
            peaks_s.push_back(seconds(t));
            peaks_mps.push_back(last);
        }
        before = last;
        last = t.airspeed_mps;
    });
    ASSERT_GE(peaks_s.size(), 2u);
    const double period_s = peaks_s[1] - peaks_s[0];
    const PitchDerivatives d = pitchDerivatives(p_, cruise_mps_, pressureArea());
    const double lanchester_s = M_PI * M_SQRT2 * cruise_mps_ / kGravity_mss;
    const double expected_s = lanchester_s * std::sqrt(1 - d.za * d.mq / d.ma);
    RecordProperty("period_s", std::to_string(period_s));
    EXPECT_NEAR(period_s, expected_s, 0.04 * period_s);
    EXPECT_LT(peaks_mps[1] - cruise_mps_, 0.7 * (peaks_mps[0] - cruise_mps_));
}

// Two degrees of freedom (Etkin): alpha' = (1 + Zq) q + Za alpha, q' = Ma alpha + Mq q, so
// w^2 = Za Mq - (1 + Zq) Ma and 2 zeta w = -(Za + Mq). Found from the flown alpha and its first two
// derivatives, which such a motion ties together at every moment.
TEST_P(EveryAirplane, has_the_textbooks_short_period) {
    Airplane airplane(p_, stillAir(), 0);
    put(airplane, 0, 0.02);
    std::vector<double> alphas, rates;
    fly(airplane, 0.3, hands_off_, [&](const Truth& t) {
        alphas.push_back(t.alpha_rad - trim_.alpha_rad);
        rates.push_back(t.pitch_rate_rads);
    });
    // least squares of a'' = -w2 a - b a' over the flight
    double aa = 0, ab = 0, bb = 0, ya = 0, yb = 0;
    for (size_t i = 1; i + 1 < alphas.size(); ++i) {
        const double a = alphas[i], h = Airplane::kStep_s;
        const double b = (alphas[i + 1] - alphas[i - 1]) / (2 * h);
        const double y = (alphas[i + 1] - 2 * a + alphas[i - 1]) / (h * h);
        aa += a * a, ab += a * b, bb += b * b, ya += y * a, yb += y * b;
    }
    const double determinant = aa * bb - ab * ab;
    const double w2 = -(ya * bb - yb * ab) / determinant,
                 damping = -(aa * yb - ab * ya) / determinant;
    const PitchDerivatives d = pitchDerivatives(p_, cruise_mps_, pressureArea());
    const double expected_rads = std::sqrt(d.za * d.mq - (1 + d.zq) * d.ma);
    EXPECT_NEAR(std::sqrt(w2), expected_rads, 0.04 * expected_rads);
    EXPECT_NEAR(damping, -(d.za + d.mq), 0.07 * -(d.za + d.mq));
    EXPECT_LT(*std::min_element(rates.begin(), rates.end()), -0.02) << "it really turned";
}

// First order: p' = Lp p + La aileron.
TEST_P(EveryAirplane, rolls_with_the_time_constant_and_rate_of_its_derivatives) {
    const double qs = pressureArea();
    const double damping = -qs * p_.span_m * p_.span_m / (2 * cruise_mps_) * p_.roll.roll_rate;
    const double time_s = p_.inertia_kgm2.xx / damping;
    constexpr double kAileron = 0.2;
    const double aileron_rad = kAileron * p_.controls.aileron_deg * M_PI / 180;
    const double steady_rads = qs * p_.span_m * p_.roll.aileron * aileron_rad / damping;

    Airplane airplane(p_, stillAir(), 0);
    Controls controls = trim_.controls;
    controls.aileron = kAileron;
    airplane.place(levelFlight(cruise_mps_, trim_.alpha_rad, 500), controls);
    double reached_s = 0, most = 0;
    fly(
        airplane, 6 * time_s, [&](const Truth&) { return controls; },
        [&](const Truth& t) {
            if (reached_s == 0 && t.roll_rate_rads > steady_rads * (1 - std::exp(-1)))
                reached_s = seconds(t);
            most = std::max(most, t.roll_rate_rads);
        });
    EXPECT_NEAR(reached_s, time_s, 0.15 * time_s);
    EXPECT_NEAR(most, steady_rads, GetParam().roll_error * steady_rads);
}

TEST_P(EveryAirplane, does_not_diverge_sideways) {
    Airplane airplane(p_, stillAir(), 0);
    Motion motion = levelFlight(cruise_mps_, trim_.alpha_rad, 500);
    motion.velocity_mps.y = 0.1 * cruise_mps_;
    motion.attitude = quaternion(0.1, trim_.alpha_rad, 0);
    airplane.place(motion, trim_.controls);
    EXPECT_GT(airplane.truth().beta_rad, 0.08);
    fly(airplane, 15, hands_off_);
    EXPECT_NEAR(airplane.truth().beta_rad, 0, 0.01);
    EXPECT_LT(std::fabs(airplane.truth().roll_rad), 0.25);
}

TEST_P(EveryAirplane, ends_a_sideslip) {
    Airplane airplane(p_, stillAir(), 0);
    Motion motion = levelFlight(cruise_mps_, trim_.alpha_rad, 500);
    motion.velocity_mps.y = 0.16 * cruise_mps_;
    airplane.place(motion, trim_.controls);
    EXPECT_GT(airplane.truth().beta_rad, 0.15);
    fly(airplane, 5, hands_off_);
    EXPECT_NEAR(airplane.truth().beta_rad, 0, 0.01);
}

TEST_P(EveryAirplane, does_not_tighten_a_turn) {
    Airplane airplane(p_, stillAir(), 0);
    Motion motion = levelFlight(cruise_mps_, trim_.alpha_rad, 500);
    motion.attitude = quaternion(0.2, trim_.alpha_rad, 0);
    airplane.place(motion, trim_.controls);
    fly(airplane, 20, hands_off_);
    EXPECT_LT(std::fabs(airplane.truth().roll_rad), GetParam().spiral_rad);
}

TEST_P(EveryAirplane, gains_and_loses_the_energy_that_the_forces_bring) {
    Airplane airplane(whole_, stillAir(), 0);
    put(airplane);
    Truth last = airplane.truth();
    const double before_j = energy_j(whole_, last);
    double work_j = 0, max_j = 0;
    const auto power = [this](const Truth& at) {
        return whole_.mass_kg * dot(attitudeOf(at).toBody(velocityOf(at)), forceOf(at));
    };
    fly(airplane, 20, wild, [&](const Truth& t) {
        work_j += (power(last) + power(t)) / 2 * Airplane::kStep_s;
        max_j = std::max(max_j, std::fabs(work_j));
        last = t;
    });
    EXPECT_GT(max_j, 15 * whole_.mass_kg);
    EXPECT_NEAR(energy_j(whole_, last) - before_j, work_j, 0.01 * max_j);
}

TEST_P(EveryAirplane, never_creates_energy) {
    AirplaneParameters p = p_;
    p.propeller.thrust0 = p.propeller.thrust1 = p.propeller.thrust2 = 0;
    Airplane airplane(p, stillAir(), 0);
    airplane.place(levelFlight(cruise_mps_, trim_.alpha_rad, 300), {});
    double last_j = energy_j(p, airplane.truth());
    fly(
        airplane, 20, [](const Truth&) { return Controls{}; },
        [&](const Truth& t) {
            EXPECT_LT(energy_j(p, t), last_j);
            last_j = energy_j(p, t);
        });
}

TEST_P(EveryAirplane, has_a_specific_force_that_is_the_change_of_velocity_less_gravity) {
    Airplane airplane(whole_, stillAir(), 0);
    put(airplane);
    Truth last = airplane.truth();
    double worst_mss = 0, largest_mss = 0;
    fly(airplane, 10, wild, [&](const Truth& now) {
        const Vec3 mean =
            (attitudeOf(last).toEarth(forceOf(last)) + attitudeOf(now).toEarth(forceOf(now))) * 0.5;
        const Vec3 change = (velocityOf(now) - velocityOf(last)) * (1 / Airplane::kStep_s);
        worst_mss = std::max(worst_mss, length(change - Vec3{0, 0, kGravity_mss} - mean));
        largest_mss = std::max(largest_mss, length(mean));
        last = now;
    });
    EXPECT_LT(worst_mss, 0.15);
    EXPECT_GT(largest_mss, 13) << "it really manoeuvred";
}

TEST_P(EveryAirplane, stands_still_where_it_stands) {
    Airplane airplane(whole_, stillAir(), 0);
    fly(airplane, 5, [](const Truth&) { return Controls{}; });
    const Truth& t = airplane.truth();
    EXPECT_TRUE(t.on_ground);
    EXPECT_FALSE(t.crashed);
    EXPECT_NEAR(std::hypot(t.north_m, t.east_m), 0, 0.01);
    EXPECT_NEAR(t.height_m, whole_.launch.height_m, 0.01);
    EXPECT_NEAR(length(velocityOf(t)), 0, 0.01);
    EXPECT_NEAR(length(forceOf(t)), kGravity_mss, 0.05);
}

INSTANTIATE_TEST_SUITE_P(All, EveryAirplane,
                         testing::Values(Case{"foam_trainer", 13, 7.9, 0.1, 0.2},
                                         Case{"trainer_6kg", 15, 9.0, 0.1, 0.2},
                                         Case{"flying_wing", 13, 7.9, 0.12, 0.3}));

namespace {

Truth thrown(Airplane& airplane, double duration_s) {
    airplane.launch();
    fly(airplane, duration_s, [](const Truth& t) { return holdAttitude(t, 0.2, 1); });
    return airplane.truth();
}

}  // namespace

TEST(Throw, gives_the_wing_its_speed_along_its_own_axis_and_shows_in_the_specific_force) {
    const AirplaneParameters p = loadAirplane("flying_wing");
    WorldOptions options = stillAir();
    options.heading_deg = 90;
    Airplane airplane(p, options, 0);
    airplane.launch();
    double felt_mss = 0;
    const auto idle = [](const Truth&) { return Controls{}; };
    while (airplane.truth().on_ground && seconds(airplane.truth()) < 2)
        fly(airplane, Airplane::kStep_s, idle,
            [&](const Truth& t) { felt_mss = std::max(felt_mss, t.force_x_mss); });
    const Truth& t = airplane.truth();
    const double pitch = p.launch.pitch_deg * M_PI / 180;
    EXPECT_NEAR(length(velocityOf(t)), p.launch.speed_mps, 0.1);
    EXPECT_NEAR(t.velocity_east_mps, p.launch.speed_mps * std::cos(pitch), 0.1);
    EXPECT_NEAR(-t.velocity_down_mps, p.launch.speed_mps * std::sin(pitch), 0.1);
    EXPECT_NEAR(seconds(t), p.launch.speed_mps / p.launch.acceleration_mss, 0.01);
    EXPECT_NEAR(felt_mss, p.launch.acceleration_mss + kGravity_mss * std::sin(pitch), 0.1);
}

TEST(Throw, is_followed_by_flight) {
    Airplane airplane(loadAirplane("flying_wing"), stillAir(), 0);
    const Truth t = thrown(airplane, 6);
    EXPECT_FALSE(t.on_ground || t.crashed);
    EXPECT_GT(t.height_m, 8);
    EXPECT_GT(t.airspeed_mps, 9);
}

TEST(Throw, comes_by_itself_when_the_motor_pulls_and_not_before) {
    Airplane airplane(loadAirplane("flying_wing"), stillAir(), 0);
    fly(airplane, 5, [](const Truth&) { return Controls{0, 0, 0, 0.3}; });
    EXPECT_TRUE(airplane.truth().on_ground);
    fly(airplane, 3, [](const Truth& t) { return holdAttitude(t, 0.2, 1); });
    EXPECT_FALSE(airplane.truth().on_ground);
}

TEST(Throw, has_no_effect_on_an_airplane_on_wheels) {
    Airplane airplane(loadAirplane("foam_trainer"), stillAir(), 0);
    airplane.launch();
    fly(airplane, 2, [](const Truth&) { return Controls{}; });
    EXPECT_NEAR(airplane.truth().north_m, 0, 0.01);
}
