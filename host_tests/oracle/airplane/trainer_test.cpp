// SPDX-License-Identifier: GPL-3.0-or-later
// The trainer in the air against the textbook's formulas for its derivatives.
#include <gtest/gtest.h>

#include "flying.hpp"

using namespace simulator;

namespace {

const AirplaneParameters kTrainer = symmetric(loadAirplane("foam_trainer"));
constexpr double kDensity = 1.225, kCruise_mps = 12.5;

Airplane& cruising(Airplane& airplane, double speed_mps, double faster_mps = 0) {
    const Trim trim = trimmed(kTrainer, speed_mps);
    airplane.place(levelFlight(speed_mps + faster_mps, trim.alpha_rad, 500), trim.controls);
    return airplane;
}

// Of angle of attack and pitch rate at cruise speed, in seconds; Za and Zq turn the flight path.
struct PitchDerivatives {
    double za, zq, ma, mq;
};
PitchDerivatives pitchDerivatives(const AirplaneParameters& p, double density_kgm3) {
    const double qs = 0.5 * density_kgm3 * kCruise_mps * kCruise_mps * p.area_m2;
    const double chord_s = p.chord_m / (2 * kCruise_mps), momentum = p.mass_kg * kCruise_mps;
    return {-qs * (p.lift.alpha + p.drag.parasite) / momentum,
            -qs * chord_s * p.lift.pitch_rate / momentum,
            qs * p.chord_m * p.pitch.alpha / p.inertia_kgm2.yy,
            qs * p.chord_m * chord_s * p.pitch.pitch_rate / p.inertia_kgm2.yy};
}

double pressureArea(double speed_mps) {
    return 0.5 * kDensity * speed_mps * speed_mps * kTrainer.area_m2;
}

}  // namespace

TEST(Trim, holds_speed_and_height_hands_off) {
    for (double speed : {10.5, kCruise_mps, 16.0}) {
        Airplane airplane(kTrainer, stillAir(), 0);
        // The air is thinner up there; equal dynamic pressure is the same flight.
        const double true_mps = speed * std::sqrt(kDensity / atmosphere(500).density_kgm3);
        const Trim trim = trimmed(kTrainer, true_mps, atmosphere(500).density_kgm3);
        airplane.place(levelFlight(true_mps, trim.alpha_rad, 500), trim.controls);
        fly(airplane, 30, [&](const Truth&) { return trim.controls; });
        EXPECT_NEAR(airplane.truth().airspeed_mps, true_mps, 0.1);
        EXPECT_NEAR(airplane.truth().velocity_down_mps, 0, 0.15);
        EXPECT_NEAR(airplane.truth().roll_rad, 0, 1e-6);
    }
}

TEST(Trim, is_at_about_45_percent_throttle_and_little_elevator_in_cruise) {
    const Trim trim = trimmed(loadAirplane("foam_trainer"), kCruise_mps);
    EXPECT_NEAR(trim.controls.throttle, 0.45, 0.04);
    EXPECT_NEAR(trim.controls.elevator, 0, 0.05);
    EXPECT_NEAR(trim.lift_coefficient / trim.drag_coefficient, 9, 1.5);
}

TEST(Stall, comes_at_about_8_metres_a_second) {
    double most = 0;
    for (double alpha = 0; alpha < 0.5; alpha += 0.001)
        most = std::max(most, polar(kTrainer, alpha).lift);
    EXPECT_NEAR(std::sqrt(kTrainer.mass_kg * kGravity_mss / pressureArea(1) / most), 7.8, 0.3);
}

TEST(Stall, ends_level_flight_when_slowing_down) {
    Airplane airplane(kTrainer, stillAir(), 0);
    cruising(airplane, kCruise_mps);
    double stall_mps = 0, steepest = 0;
    fly(
        airplane, 30,
        [](const Truth& t) {  // holds height with the elevator, motor off, until it can not
            Controls out = holdAttitude(t, t.alpha_rad + 0.15 * t.velocity_down_mps, 0);
            return out;
        },
        [&](const Truth& t) {
            if (stall_mps == 0 && t.velocity_down_mps > 1.5) stall_mps = t.airspeed_mps;
            steepest = std::max(steepest, t.alpha_rad);
        });
    EXPECT_NEAR(stall_mps, 8, 0.8);
    EXPECT_GT(steepest, 0.22);
}

TEST(Stall, is_left_by_letting_the_nose_down) {
    Airplane airplane(kTrainer, stillAir(), 0);
    cruising(airplane, kCruise_mps);
    double deepest = 0;
    fly(
        airplane, 5,
        [](const Truth&) {
            return Controls{0, 1, 0, 0};
        },
        [&](const Truth& t) { deepest = std::max(deepest, polar(kTrainer, t.alpha_rad).stalled); });
    EXPECT_GT(deepest, 0.8);
    fly(airplane, 3, [](const Truth& t) { return holdAttitude(t, -0.6, 0.5); });
    fly(airplane, 8, [](const Truth& t) { return holdAttitude(t, 0, 0.5); });
    EXPECT_LT(polar(kTrainer, airplane.truth().alpha_rad).stalled, 0.05);
    EXPECT_NEAR(airplane.truth().roll_rad, 0, 0.1);
    EXPECT_GT(airplane.truth().airspeed_mps, 10);
}

// Lanchester's pi sqrt(2) V / g, lengthened by the pitch damping, which is strong in so light an
// airplane (McRuer, Ashkenas, Graham: Aircraft Dynamics and Automatic Control, three degrees of
// freedom: w^2 = g Zu Mw / (U Mw - Zw Mq)).
TEST(Phugoid, has_the_textbooks_period_and_dies_away) {
    Airplane airplane(kTrainer, stillAir(), 0);
    const Trim trim = trimmed(kTrainer, kCruise_mps, atmosphere(500).density_kgm3);
    airplane.place(levelFlight(kCruise_mps + 1, trim.alpha_rad, 500), trim.controls);
    std::vector<double> peaks_s, peaks_mps;
    double before = 0, last = 0;
    fly(
        airplane, 25, [&](const Truth&) { return trim.controls; },
        [&](const Truth& t) {
            if (seconds(t) > 2 && last > before && t.airspeed_mps < last) {
                peaks_s.push_back(seconds(t));
                peaks_mps.push_back(last);
            }
            before = last;
            last = t.airspeed_mps;
        });
    ASSERT_GE(peaks_s.size(), 2u);
    const double period_s = peaks_s[1] - peaks_s[0];
    const PitchDerivatives d = pitchDerivatives(kTrainer, atmosphere(500).density_kgm3);
    const double lanchester_s = M_PI * M_SQRT2 * kCruise_mps / kGravity_mss;
    EXPECT_NEAR(period_s, lanchester_s * std::sqrt(1 - d.za * d.mq / d.ma), 0.04 * period_s);
    EXPECT_LT(peaks_mps[1] - kCruise_mps, 0.7 * (peaks_mps[0] - kCruise_mps));
}

// Two-degree-of-freedom approximation (Etkin): alpha' = (1 + Zq) q + Za alpha, q' = Ma alpha + Mq
// q.
TEST(ShortPeriod, answers_a_disturbance_like_the_textbooks_approximation) {
    const PitchDerivatives d = pitchDerivatives(kTrainer, atmosphere(500).density_kgm3);
    Airplane airplane(kTrainer, stillAir(), 0);
    const Trim trim = trimmed(kTrainer, kCruise_mps, atmosphere(500).density_kgm3);
    constexpr double kDisturbance = 0.03;
    Motion motion = levelFlight(kCruise_mps, trim.alpha_rad + kDisturbance, 500);
    airplane.place(motion, trim.controls);
    double alpha = kDisturbance, rate = 0, worst = 0, worst_rate = 0, lowest = 0;
    fly(
        airplane, 0.5, [&](const Truth&) { return trim.controls; },
        [&](const Truth& t) {
            constexpr int kFine = 10;
            for (int i = 0; i < kFine; ++i) {
                const double dalpha = (1 + d.zq) * rate + d.za * alpha;
                const double drate = d.ma * alpha + d.mq * rate;
                alpha += dalpha * Airplane::kStep_s / kFine;
                rate += drate * Airplane::kStep_s / kFine;
            }
            worst = std::max(worst, std::fabs(t.alpha_rad - trim.alpha_rad - alpha));
            worst_rate = std::max(worst_rate, std::fabs(t.pitch_rate_rads - rate));
            lowest = std::min(lowest, t.pitch_rate_rads);
        });
    EXPECT_LT(worst, 0.04 * kDisturbance);
    EXPECT_LT(worst_rate, 0.1 * -lowest);
    EXPECT_LT(lowest, -0.08) << "it really turned";
}

// First order: p' = Lp p + La aileron.
TEST(RollMode, has_the_time_constant_and_rate_of_its_derivatives) {
    const double qs = pressureArea(kCruise_mps);
    const double damping =
        -qs * kTrainer.span_m * kTrainer.span_m / (2 * kCruise_mps) * kTrainer.roll.roll_rate;
    const double time_s = kTrainer.inertia_kgm2.xx / damping;
    constexpr double kAileron = 0.2;
    const double aileron_rad = kAileron * kTrainer.controls.aileron_deg * M_PI / 180;
    const double steady_rads = qs * kTrainer.span_m * kTrainer.roll.aileron * aileron_rad / damping;

    Airplane airplane(kTrainer, stillAir(), 0);
    const Trim trim = trimmed(kTrainer, kCruise_mps);
    Controls controls = trim.controls;
    controls.aileron = kAileron;
    airplane.place(levelFlight(kCruise_mps, trim.alpha_rad, 5), controls);
    double reached_s = 0, most = 0;
    fly(
        airplane, 0.3, [&](const Truth&) { return controls; },
        [&](const Truth& t) {
            if (reached_s == 0 && t.roll_rate_rads > steady_rads * (1 - std::exp(-1)))
                reached_s = seconds(t);
            most = std::max(most, t.roll_rate_rads);
        });
    EXPECT_NEAR(reached_s, time_s, 0.15 * time_s);
    EXPECT_NEAR(most, steady_rads, 0.1 * steady_rads);
}

TEST(DutchRoll, dies_away) {
    Airplane airplane(kTrainer, stillAir(), 0);
    const Trim trim = trimmed(kTrainer, kCruise_mps);
    Motion motion = levelFlight(kCruise_mps, trim.alpha_rad, 500);
    motion.velocity_mps.y = 2;
    airplane.place(motion, trim.controls);
    EXPECT_GT(airplane.truth().beta_rad, 0.15);
    fly(airplane, 5, [&](const Truth&) { return trim.controls; });
    EXPECT_NEAR(airplane.truth().beta_rad, 0, 0.01);
}

TEST(Spiral, does_not_tighten) {
    Airplane airplane(kTrainer, stillAir(), 0);
    const Trim trim = trimmed(kTrainer, kCruise_mps);
    Motion motion = levelFlight(kCruise_mps, trim.alpha_rad, 500);
    motion.attitude = quaternion(0.2, trim.alpha_rad, 0);
    airplane.place(motion, trim.controls);
    fly(airplane, 20, [&](const Truth&) { return trim.controls; });
    EXPECT_LT(std::fabs(airplane.truth().roll_rad), 0.2);
}

TEST(Controls, move_the_airplane_the_way_the_pulses_are_defined) {
    const auto answer = [](Controls extra) {
        Airplane airplane(kTrainer, stillAir(), 0);
        const Trim trim = trimmed(kTrainer, kCruise_mps);
        airplane.place(levelFlight(kCruise_mps, trim.alpha_rad, 500), trim.controls);
        extra.elevator += trim.controls.elevator;
        extra.throttle += trim.controls.throttle;
        fly(airplane, 0.4, [&](const Truth&) { return extra; });
        return airplane.truth();
    };
    EXPECT_GT(answer({0.3, 0, 0, 0}).roll_rate_rads, 0.3) << "aileron right";
    EXPECT_GT(answer({0, 0.3, 0, 0}).pitch_rad, 0.1) << "elevator up";
    EXPECT_GT(answer({0, 0, 0.3, 0}).yaw_rate_rads, 0.1) << "rudder right";
    EXPECT_GT(answer({0, 0, 0, 0.3}).force_x_mss, answer({}).force_x_mss + 1) << "throttle";
}

TEST(Servos, follow_with_a_lag_and_no_faster_than_they_turn) {
    Airplane airplane(kTrainer, stillAir(), 0);
    double fastest = 0, last = 0;
    const auto full = [](const Truth&) { return Controls{1, 0, 0, 0}; };
    fly(airplane, 0.05, full, [&](const Truth& t) {
        fastest = std::max(fastest, (t.aileron - last) / Airplane::kStep_s);
        last = t.aileron;
    });
    EXPECT_NEAR(fastest, kTrainer.controls.rate_per_s, 0.01);
    EXPECT_LT(last, 0.6);
    fly(airplane, 0.3, full);
    EXPECT_NEAR(airplane.truth().aileron, 1, 0.01);
}
