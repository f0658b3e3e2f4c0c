// SPDX-License-Identifier: GPL-3.0-or-later
// Lateral guidance: which lateral acceleration brings the airplane onto a leg or a circle and
// keeps it there. Near the path it is the law of S. Park, J. Deyst and J. P. How (AIAA 2004-4900):
// the period and the damping of the crosstrack error are those of the L1 distance. Three things
// are added: farther out the demanded course is the one from which a turn of the given
// acceleration ends on the path; the bank's own lag is looked ahead over; and the wind turns the
// demand over ground into one across the air.
#pragma once
#include "geo/position.hpp"
#include "navigation/settings.hpp"

namespace navigation {

struct Motion {
    geo::Position position;
    geo::Offset velocity_mps;  // over ground
    geo::Offset wind_mps;      // where it blows to
    float bank_accel_mss;      // gravity times tan(bank): what the present bank makes
    float bank_lag_s;          // from demanded to flown bank
    float turn_accel_mss;      // of turns; at most what the bank limit makes
};

struct Lateral {
    float bank_accel_mss;  // demanded, positive to the right; not limited
    float crosstrack_m;    // positive: right of the leg, outside the circle
    float distance_m;      // to the end of the leg, to the centre
    float along_m;         // from the leg's start; 0 on a circle
    float length_m;        // of the leg
    geo::Offset course;    // demanded, over ground, of length 1
};

// The whole line through both ends is flown; coming from behind its start, no steeper than
// straight to the start.
Lateral followLeg(const LateralSettings& settings, const Motion& motion, const geo::Position& from,
                  const geo::Position& to);

struct Circle {
    geo::Position centre;
    float radius_m;
    bool counter_clockwise;
};
// From outside it is joined along a tangent.
Lateral followCircle(const LateralSettings& settings, const Motion& motion, const Circle& circle);

// The course over ground is held, wherever that leads. `course` is of length 1.
Lateral followCourse(const LateralSettings& settings, const Motion& motion,
                     const geo::Offset& course);

float bankFor_rad(float bank_accel_mss);  // atan(a / g) within 0.3 degrees

// The part of the bank that turns nothing: a level not quite true, a wing not quite straight. It is
// learned from what stays beside the path, and kept from one path to the next.
class BankTrim {
public:
    void start() { accel_mss_ = 0; }
    void learn(float left_of_path_m, float dt_s);
    float accel_mss() const { return accel_mss_; }  // to be added to what a law demands

private:
    float accel_mss_ = 0;
};

// How far round a circle the airplane has come since it was on it.
class TurnCount {
public:
    void start() { captured_ = false, turned_rad_ = 0; }
    // `from_centre` and the result of followCircle for the same moment.
    void update(const Circle& circle, const geo::Offset& from_centre, float crosstrack_m);
    bool captured() const { return captured_; }
    float turned_rad() const { return turned_rad_; }

private:
    geo::Offset last_ = {0, 0};
    float turned_rad_ = 0;
    bool captured_ = false;
};

}  // namespace navigation
