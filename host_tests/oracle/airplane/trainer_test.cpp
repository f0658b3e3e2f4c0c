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
