// SPDX-License-Identifier: GPL-3.0-or-later
#include "navigation/l1.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "pilot.hpp"

namespace {

using flight_model::at;
using flight_model::Pilot;
using flight_model::Statistics;
using flight_model::Wind;
using navigation::Lateral;
using navigation::Motion;

const navigation::LateralGains kGains = navigation::lateralGains({7, 0.75f}, 6.9f);

Lateral alongLeg(const Motion& motion, const geo::Position& place, const geo::Position& from,
                 const geo::Position& to) {
    return followLeg(kGains, motion, navigation::legAlong(geo::offset(from, to)),
                     geo::offset(from, place));
}
constexpr Wind kCalm{};
Wind breeze(unsigned seed) { return {3, 4, 1, seed}; }

struct Place {
    double north, east;
};

// Where an airplane truly is along and beside a leg.
struct OnLeg {
    double along, cross, length;
};
OnLeg onLeg(const Place& from, const Place& to, const Pilot& pilot) {
    const double length = std::hypot(to.north - from.north, to.east - from.east);
    const double n = (to.north - from.north) / length, e = (to.east - from.east) / length;
    const double wn = pilot.plane.north - from.north, we = pilot.plane.east - from.east;
    return {wn * n + we * e, we * n - wn * e, length};
}

struct BoxFigures {
    Statistics after_5s, after_10s;
};

// Laps of a box of 600 m legs with turns of 90 degrees, each leg left 30 m before its end.
BoxFigures flyBox(const Wind& wind, double side_m = 600) {
    const std::vector<Place> corners = {{side_m, 0}, {side_m, side_m}, {0, side_m}, {0, 0}};
    Pilot pilot(wind);
    BoxFigures figures;
    Place from{0, 0};
    for (int leg = 0; leg < 8; ++leg) {
        const Place to = corners[leg % 4];
        const double start = pilot.time;
        const auto law = [&](const Motion& motion, const geo::Position& place) {
            return alongLeg(motion, place, at(from.north, from.east), at(to.north, to.east));
        };
        pilot.fly(300, law, [&](const Lateral& lateral) {
            const OnLeg truth = onLeg(from, to, pilot);
            if (pilot.time - start > 5) figures.after_5s.add(truth.cross);
            if (pilot.time - start > 10) figures.after_10s.add(truth.cross);
            return lateral.distance_m > 30 && truth.along < truth.length;
        });
        from = to;
    }
    return figures;
}

TEST(Leg, is_held_in_calm_air_from_five_seconds_after_a_turn) {
    const auto figures = flyBox(kCalm);

    EXPECT_LT(figures.after_5s.rms(), 0.5);
    EXPECT_LT(figures.after_10s.rms(), 0.2);
    EXPECT_LT(figures.after_10s.worst, 0.6);
}

TEST(Leg, is_held_in_wind_and_gusts) {
    for (unsigned seed = 1; seed <= 3; ++seed) {
        const auto figures = flyBox(breeze(seed));
        EXPECT_LT(figures.after_5s.rms(), 1.2) << seed;
        EXPECT_LT(figures.after_10s.rms(), 0.4) << seed;
    }
}

// How far it flies past the second of two legs of 1 km where the first is left as turnLead_m()
// says.
double pastCorner_m(const Wind& wind, double turn_rad) {
    Pilot pilot(wind);
    const Place corner{1000, 0};
    const Place end{1000 + 1000 * std::cos(turn_rad), 1000 * std::sin(turn_rad)};
    const geo::Position begin = at(0, 0), middle = at(corner.north, corner.east);
    const navigation::Leg before = navigation::legAlong(geo::offset(begin, middle));
    const navigation::Leg after =
        navigation::legAlong(geo::offset(middle, at(end.north, end.east)));
    double lead_m = 0;
    const auto first = [&](const Motion& motion, const geo::Position& place) {
        lead_m = turnLead_m(kGains, motion, before, after);
        return alongLeg(motion, place, begin, middle);
    };
    pilot.fly(300, first, [&](const Lateral& lateral) { return lateral.distance_m > lead_m; });
    double past_m = 0;
    const auto second = [&](const Motion& motion, const geo::Position& place) {
        return alongLeg(motion, place, middle, at(end.north, end.east));
    };
    pilot.fly(20, second, [&](const Lateral&) {
        const double cross = onLeg(corner, end, pilot).cross;
        past_m = std::max(past_m, turn_rad > 0 ? -cross : cross);
        return true;
    });
    return past_m;
}

TEST(Turn, is_led_so_that_the_next_leg_is_not_overshot) {
    for (const double turn_rad : {0.6, M_PI / 2, -M_PI / 2, 2.0})
        for (const double to_rad : {0.0, M_PI / 2, M_PI, -M_PI / 2}) {
            const Wind wind{6 * std::cos(to_rad), 6 * std::sin(to_rad), 0, 1};
            EXPECT_LT(pastCorner_m(wind, turn_rad), 4) << turn_rad << ", wind to " << to_rad;
        }
}

// In this turn from a cross wind to a tail wind the nose turns by up to 140 degrees, and the ground
// speed doubles.
TEST(Turn, with_a_strong_wind_from_behind_afterwards_is_not_overshot) {
    for (const double turn_rad : {M_PI / 2, -M_PI / 2})
        for (const double beside_rad : {-0.3, 0.0, 0.3}) {
            const double to_rad = turn_rad + beside_rad;
            const Wind wind{10 * std::cos(to_rad), 10 * std::sin(to_rad), 0, 1};
            EXPECT_LT(pastCorner_m(wind, turn_rad), 8) << turn_rad << ", wind to " << to_rad;
        }
}

TEST(Turn, is_led_by_the_arc_and_what_the_bank_takes) {
    const Motion fast{{22, 0}, {0, 0}, 22, 0, 0.5f};
    const navigation::Leg north{{1, 0}, 1000}, east{{0, 1}, 1000}, south{{-1, 0}, 1000};
    EXPECT_NEAR(turnLead_m(kGains, fast, north, east), 22 * 22 / 6.9 + 11, 0.1);
    EXPECT_NEAR(turnLead_m(kGains, fast, north, north), 11, 0.1) << "straight on";
    EXPECT_NEAR(turnLead_m(kGains, fast, north, south), 22 * 22 / 6.9 * std::sqrt(3.0) + 11, 0.1)
        << "as by 120 degrees";
    // into a wind from the side, then before it: (22^2 + 28^2) / 2
    const Motion blown{{22, 0}, {0, 6}, 22, 0, 0.5f};
    EXPECT_NEAR(turnLead_m(kGains, blown, north, east), 634 / 6.9 + 11, 0.1);
}

TEST(Turn, is_led_by_no_more_than_half_of_the_shorter_leg) {
    const Motion fast{{22, 0}, {0, 0}, 22, 0, 0.5f};
    const navigation::Leg north{{1, 0}, 500}, east{{0, 1}, 60};
    EXPECT_FLOAT_EQ(turnLead_m(kGains, fast, north, east), 30);
    EXPECT_FLOAT_EQ(turnLead_m(kGains, fast, east, north), 30);
    EXPECT_FLOAT_EQ(turnLead_m(kGains, fast, north, {{0, 0}, 0}), 0) << "nowhere";
}

TEST(Leg, is_captured_from_far_with_hardly_any_overshoot) {
    for (double east : {-400.0, 400.0}) {
        Pilot pilot;
        pilot.plane.east = east;
        double beyond = 0, captured_s = 0;
        const auto law = [&](const Motion& motion, const geo::Position& place) {
            return alongLeg(motion, place, at(0, 0), at(3000, 0));
        };
        pilot.fly(90, law, [&](const Lateral&) {
            const double side = pilot.plane.east * (east > 0 ? 1 : -1);
            beyond = std::max(beyond, -side);
            if (captured_s == 0 && side < 1) captured_s = pilot.time;
            return true;
        });

        EXPECT_LT(beyond, 2.0) << east;
        EXPECT_GT(captured_s, 30) << east;
        EXPECT_LT(captured_s, 50) << east << " the way straight across takes 33 s";
        EXPECT_NEAR(pilot.plane.east, 0, 0.5);
    }
}

TEST(Leg, is_captured_flying_away_from_it_and_flying_backwards) {
    for (double heading : {-90.0, 90.0, 180.0, -179.0}) {
        Pilot pilot;
        const double angle = heading * 3.14159265 / 180;
        pilot.plane.velocity_n = 12 * std::cos(angle);
        pilot.plane.velocity_e = 12 * std::sin(angle);
        const auto law = [&](const Motion& motion, const geo::Position& place) {
            return alongLeg(motion, place, at(0, 0), at(3000, 0));
        };
        pilot.fly(40, law, [](const Lateral&) { return true; });

        EXPECT_NEAR(pilot.plane.east, 0, 0.5) << heading;
        EXPECT_GT(pilot.plane.velocity_n, 11) << heading;
    }
}

TEST(Leg, begun_behind_its_start_is_not_closed_more_steeply_than_straight_to_the_start) {
    Pilot pilot;
    pilot.plane.north = -400;
    pilot.plane.east = 200;
    double steepest = 0;
    const auto law = [&](const Motion& motion, const geo::Position& place) {
        return alongLeg(motion, place, at(0, 0), at(1000, 0));
    };
    pilot.fly(50, law, [&](const Lateral& lateral) {
        if (pilot.time > 4) steepest = std::max<double>(steepest, -lateral.course.east_m);
        return pilot.plane.north < 0;
    });

    EXPECT_LT(steepest, 0.5) << "sine of the 26.6 degrees to the start, and a little";
    EXPECT_NEAR(pilot.plane.east, 0, 8);
}

TEST(Leg, gives_the_position_along_and_beside_the_leg) {
    Motion motion{};
    motion.velocity_mps = {12, 0};
    motion.airspeed_mps = 12;
    const auto lateral = alongLeg(motion, at(100, 20), at(0, 0), at(500, 0));

    EXPECT_NEAR(lateral.along_m, 100, 0.1);
    EXPECT_NEAR(lateral.crosstrack_m, 20, 0.1);
    EXPECT_NEAR(lateral.distance_m, std::hypot(400, 20), 0.6);
    EXPECT_LT(lateral.bank_accel_mss, 0) << "right of the leg: to the left";
}

TEST(Leg, without_a_length_is_flown_straight_to_its_end) {
    Pilot pilot;
    double nearest = 1e9;
    const auto law = [&](const Motion& motion, const geo::Position& place) {
        return alongLeg(motion, place, at(200, 150), at(200, 150));
    };
    pilot.fly(40, law, [&](const Lateral& lateral) {
        nearest = std::min<double>(nearest, lateral.distance_m);
        return nearest > 5;
    });

    EXPECT_LT(nearest, 5);
}

struct CircleFigures {
    Statistics radius;
    double turned_rad, captured_s;
};

CircleFigures flyCircle(const Wind& wind, const Place& start, bool counter_clockwise) {
    const navigation::Circle circle{60, counter_clockwise};
    Pilot pilot(wind);
    pilot.plane.north = start.north;
    pilot.plane.east = start.east;
    navigation::TurnCount turns;
    turns.start();
    CircleFigures figures{};
    const auto law = [&](const Motion& motion, const geo::Position& place) {
        return followCircle(kGains, motion, circle, geo::offset(at(0, 0), place));
    };
    pilot.fly(180, law, [&](const Lateral& lateral) {
        turns.update(circle, geo::offset(at(0, 0), at(pilot.plane.north, pilot.plane.east)),
                     lateral.crosstrack_m);
        if (turns.captured() && figures.captured_s == 0) figures.captured_s = pilot.time;
        if (turns.captured() && pilot.time > figures.captured_s + 3)
            figures.radius.add(std::hypot(pilot.plane.north, pilot.plane.east) - 60);
        return true;
    });
    figures.turned_rad = turns.turned_rad();
    return figures;
}

TEST(Circle, is_joined_from_outside_and_held_in_calm_air) {
    for (bool counter_clockwise : {false, true}) {
        const auto figures = flyCircle(kCalm, {-300, -40}, counter_clockwise);
        EXPECT_LT(figures.radius.rms(), 0.3);
        EXPECT_LT(figures.radius.worst, 1.5);
        EXPECT_NEAR(figures.turned_rad, (180 - figures.captured_s) * 12.5 / 60, 1.5);
    }
}

TEST(Circle, is_held_in_wind_and_gusts) {
    for (unsigned seed = 1; seed <= 3; ++seed) {
        const auto figures = flyCircle(breeze(seed), {-300, 100}, seed == 2);
        EXPECT_LT(figures.radius.rms(), 0.6) << seed;
        EXPECT_GT(figures.turned_rad, 25) << seed;
    }
}

TEST(Circle, is_reached_from_its_centre) {
    const auto figures = flyCircle(kCalm, {0, 0}, false);

    EXPECT_LT(figures.captured_s, 15);
    EXPECT_LT(figures.radius.rms(), 0.5);
}

TEST(TurnCount, begins_at_the_capture_and_grows_in_the_circles_direction) {
    const navigation::Circle circle{50, true};
    navigation::TurnCount turns;
    turns.start();
    turns.update(circle, {90, 0}, 40);
    EXPECT_FALSE(turns.captured());
    for (int degree = 0; degree <= 720; ++degree) {
        const float angle = static_cast<float>(-degree * 3.14159265 / 180);
        turns.update(circle, {50 * std::cos(angle), 50 * std::sin(angle)}, 0);
    }
    EXPECT_TRUE(turns.captured());
    EXPECT_NEAR(turns.turned_rad(), 4 * 3.14159265, 0.01);
}

TEST(BankTrim, takes_away_what_a_false_level_leaves_beside_the_path) {
    Pilot pilot;
    navigation::BankTrim trim;
    trim.start();
    const float false_level_mss = 0.35f;  // two degrees
    const auto law = [&](Motion motion, const geo::Position& place) {
        motion.bank_accel_mss += false_level_mss - trim.accel_mss();
        auto lateral = alongLeg(motion, place, at(0, 0), at(3000, 0));
        trim.learn(-lateral.crosstrack_m, 0.05f);
        lateral.bank_accel_mss += trim.accel_mss() - false_level_mss;
        return lateral;
    };
    pilot.fly(10, law, [](const Lateral&) { return true; });
    EXPECT_LT(pilot.plane.east, -0.05);
    pilot.fly(60, law, [](const Lateral&) { return true; });

    EXPECT_NEAR(pilot.plane.east, 0, 0.15);
    EXPECT_NEAR(trim.accel_mss(), false_level_mss, 0.1);
}

TEST(BankTrim, does_not_learn_from_a_capture_and_has_a_limit) {
    navigation::BankTrim trim;
    trim.start();
    for (int i = 0; i < 100; ++i) trim.learn(5, 0.05f);
    EXPECT_EQ(trim.accel_mss(), 0);
    for (int i = 0; i < 10000; ++i) trim.learn(1, 0.05f);
    EXPECT_FLOAT_EQ(trim.accel_mss(), 0.6f);
}

TEST(Course, is_held_across_the_wind) {
    Pilot pilot({0, 5, 0, 1});
    const auto law = [&](const Motion& motion, const geo::Position&) {
        return followCourse(kGains, motion, {1, 0});
    };
    pilot.fly(20, law, [](const Lateral&) { return true; });

    EXPECT_NEAR(pilot.plane.velocity_e, 0, 0.3);
}

// The wind is known, its gusts are not: they turn the little that it moves over the ground to every
// side.
float bankInWind_mss(float nose_rad, const geo::Offset& wind_mps, const geo::Offset& gust_mps) {
    Motion motion{};
    motion.airspeed_mps = 13;
    motion.bank_lag_s = 0.6f;
    motion.wind_mps = wind_mps;
    motion.velocity_mps = {13 * std::cos(nose_rad) + wind_mps.north_m + gust_mps.north_m,
                           13 * std::sin(nose_rad) + wind_mps.east_m + gust_mps.east_m};
    return followCourse(kGains, motion, {1, 0}).bank_accel_mss;
}

TEST(Course, is_held_by_the_nose_in_a_wind_as_fast_as_the_airplane) {
    const geo::Offset gusts_mps[] = {{0, 0}, {0.5f, 0}, {-0.5f, 0}, {0, 0.5f}, {0, -0.5f}};
    for (const float wind_mps : {-11.0f, -13.0f, -15.0f, -18.0f}) {
        for (const geo::Offset& gust_mps : gusts_mps) {
            const auto bank_mss = [&](float nose_rad) {
                return bankInWind_mss(nose_rad, {wind_mps, 0}, gust_mps);
            };
            EXPECT_LT(std::abs(bank_mss(0)), 2) << wind_mps << gust_mps.north_m << gust_mps.east_m;
            for (const float right_rad : {0.3f, 1.0f, 2.0f, 3.0f}) {
                EXPECT_LT(bank_mss(right_rad), -1) << "the nose is right of the course";
                EXPECT_GT(bank_mss(-right_rad), 1);
            }
        }
    }
}

// Driven sideways it turns the nose into the wind as far as that holds the course, and not about.
TEST(Course, is_held_by_a_crab_in_a_wind_across_it) {
    for (const float side : {1.0f, -1.0f}) {
        const auto bank_mss = [&](float nose_rad, float wind_mps) {
            return side * bankInWind_mss(side * nose_rad, {-5, -side * wind_mps}, {0, 0});
        };
        const float crab_rad = std::asin(10 / 13.0f);
        EXPECT_NEAR(bank_mss(crab_rad, 10), 0, 0.1);
        EXPECT_GT(bank_mss(crab_rad - 0.3f, 10), 1);
        EXPECT_LT(bank_mss(crab_rad + 0.3f, 10), -1);
        const float steepest_rad = std::asin(0.866f);
        EXPECT_NEAR(bank_mss(steepest_rad, 14), 0, 0.1) << "no crab holds it";
        EXPECT_GT(bank_mss(steepest_rad - 0.3f, 14), 1);
        EXPECT_LT(bank_mss(steepest_rad + 0.3f, 14), -1);
    }
}

// In a wind faster than the airplane no bank reaches the course.
TEST(Course, of_which_a_faster_wind_keeps_it_does_not_roll_it_from_side_to_side) {
    for (const double wind_mps : {14.0, 17.0, 20.0, 25.0, 30.0}) {
        for (const double across_mps : {0.0, 5.0, -5.0, 10.0}) {
            Pilot pilot({-wind_mps, across_mps, 0, 1});
            const auto law = [&](const Motion& motion, const geo::Position&) {
                return followCourse(kGains, motion, {1, 0});
            };
            int sides = 0;
            float before_mss = 0;
            pilot.fly(30, law, [&](const Lateral& lateral) {
                constexpr float kBanked_mss = 3;
                const float bank_mss = lateral.bank_accel_mss;
                if (std::abs(bank_mss) < kBanked_mss) return true;
                sides += bank_mss * before_mss < 0;
                before_mss = bank_mss;
                return true;
            });
            EXPECT_LE(sides, 4) << wind_mps << " " << across_mps;
        }
    }
}

// It points where it cannot go: it is then carried away by the difference of the two, and not by
// the wind, as it is when it circles.
TEST(Course, of_which_a_faster_wind_keeps_it_is_held_by_the_nose) {
    for (const double wind_mps : {18.0, 22.0, 28.0}) {
        for (const double across_mps : {0.0, 4.0, -4.0}) {
            Pilot pilot({-wind_mps, across_mps, 0, 1});
            const auto law = [&](const Motion& motion, const geo::Position&) {
                return followCourse(kGains, motion, {1, 0});
            };
            const auto on = [](const Lateral&) { return true; };
            pilot.fly(20, law, on);
            const double from_m = pilot.plane.north;
            pilot.fly(30, law, on);
            EXPECT_GT(pilot.plane.north - from_m, (pilot.plane.airspeed - wind_mps - 2) * 30)
                << wind_mps << " " << across_mps;
        }
    }
}

// Without an airspeed sensor and with a wrong wind it does not know that it is blown: the course of
// what hardly moves changes from frame to frame, and must not turn the bank over.
TEST(Course, of_what_hardly_moves_asks_for_little_bank) {
    for (int direction = 0; direction < 36; ++direction) {
        const float course_rad = static_cast<float>(direction) * 0.1745f;
        Motion motion{};
        motion.airspeed_mps = 2.7f;
        motion.velocity_mps = {0.3f * std::cos(course_rad), 0.3f * std::sin(course_rad)};
        motion.wind_mps = {-2.4f, 0};
        EXPECT_LT(std::abs(followCourse(kGains, motion, {1, 0}).bank_accel_mss),
                  0.3f * 1.41f * kGains.turning_hz)  // with the largest crab
            << direction;
    }
}

// A compass that is turned by 180 degrees has it fly backwards as fast as it flies.
TEST(Course, is_held_by_the_course_where_a_turned_compass_has_it_fly_backwards) {
    constexpr float kAirspeed_mps = 13;
    for (const float course_rad : {0.1f, -0.1f, 0.5f, -0.5f}) {
        Motion motion{};
        motion.airspeed_mps = kAirspeed_mps;
        motion.bank_lag_s = 0.6f;
        motion.velocity_mps = {kAirspeed_mps * std::cos(course_rad),
                               kAirspeed_mps * std::sin(course_rad)};
        motion.wind_mps = {2 * motion.velocity_mps.north_m, 2 * motion.velocity_mps.east_m};
        EXPECT_LT(followCourse(kGains, motion, {1, 0}).bank_accel_mss * course_rad, 0);
    }
}

TEST(Bank, is_the_arc_tangent_within_a_third_of_a_degree) {
    for (double accel = -40; accel <= 40; accel += 0.25)
        EXPECT_NEAR(navigation::bankFor_rad(static_cast<float>(accel)), std::atan(accel / 9.80665),
                    0.0053);
}

}  // namespace
