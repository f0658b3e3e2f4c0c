// SPDX-License-Identifier: GPL-3.0-or-later
// Lateral guidance: which lateral acceleration brings the airplane onto a leg or a circle and
// keeps it there. Near the path it is the law of S. Park, J. Deyst and J. P. How (AIAA 2004-4900):
// the period and the damping of the crosstrack error are those of the L1 distance. Three things
// are added: farther out the demanded course is the one from which a turn of the given
// acceleration ends on the path, at the mean of the speeds over ground now and there; the bank's
// own lag is looked ahead over; and the wind turns the demand over ground into one across the air.
#pragma once
#include "geo/position.hpp"
#include "navigation/settings.hpp"

namespace navigation {

// Places are offsets from the leg's start or the circle's centre.
struct Motion {
    geo::Offset velocity_mps;  // over ground
    geo::Offset wind_mps;      // where it blows to
    float airspeed_mps;        // true
    float bank_accel_mss;      // gravity times tan(bank): what the present bank makes
    float bank_lag_s;          // from demanded to flown bank
};

struct LateralGains {      // worked out once for many steps
    float closing_hz;      // closing speed for a metre of crosstrack
    float turning_hz;      // acceleration for a metre per second across the demanded course
    float turn_accel_mss;  // of turns; at most what the bank limit makes
    float linear_m;        // so near the path the closing speed grows with the distance
};
LateralGains lateralGains(const LateralSettings& settings, float turn_accel_mss);

struct Lateral {
    float bank_accel_mss;  // demanded, positive to the right; not limited
    float crosstrack_m;    // positive: right of the leg, outside the circle
    float distance_m;      // to the end of the leg, to the centre
    float along_m;         // from the leg's start; 0 on a circle
    geo::Offset course;    // demanded, over ground, of length 1
};

struct Leg {
    geo::Offset forward;  // of length 1; nought when the leg is too short to have a direction
    float length_m;
};
Leg legAlong(const geo::Offset& start_to_end);

// The whole line through both ends is flown; coming from behind its start, no steeper than
// straight to the start. A leg without a direction is flown straight to its start.
Lateral followLeg(const LateralGains& gains, const Motion& motion, const Leg& leg,
                  const geo::Offset& from_start);

// How far before the end of a leg the turn to the next one begins, in metres: an arc between both
// with the turns' acceleration at the mean of the speeds over ground before and after it, and what
// is flown while the bank builds up. A turn by more than 120 degrees is led as one by 120; none by
// more than half of the shorter leg.
float turnLead_m(const LateralGains& gains, const Motion& motion, const Leg& leg, const Leg& next);

struct Circle {
    float radius_m;
    bool counter_clockwise;
};
// From outside it is joined along a tangent.
Lateral followCircle(const LateralGains& gains, const Motion& motion, const Circle& circle,
                     const geo::Offset& from_centre);

// The course over ground is held, wherever that leads. `course` is of length 1.
Lateral followCourse(const LateralGains& gains, const Motion& motion, const geo::Offset& course);

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
