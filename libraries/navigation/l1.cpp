// SPDX-License-Identifier: GPL-3.0-or-later
#include "navigation/l1.hpp"

#include <math.h>

#include "core/maths.hpp"

namespace navigation {
namespace {

using geo::Offset;

constexpr float kSlowest_mps = 3.0f;      // below, a course means nothing
constexpr float kFlies_mps = 6.0f;        // through the air
constexpr float kMaxBackwards = 0.5f;     // of the airspeed: more is a compass that points back
constexpr float kMaxCrab_sin = 0.866f;    // 60 degrees
constexpr float kNegligibleCrab = 1.03f;  // of 14 degrees
constexpr float kMaxPerCrab = 1.4f;       // of 45 degrees: more may be a wind that is not there
constexpr float kCaptured_m = 5.0f;
constexpr float kTrimReach_m = 3;     // farther from the path it is being captured, not trimmed
constexpr float kTrimRate = 0.08f;    // m/s2 a second for a metre: learned in ten seconds
constexpr float kMaxTrim_mss = 0.6f;  // 3.5 degrees
constexpr float kSmallestRadius_m = 5.0f;
constexpr float kLagMoves_m = 50.0f;    // at most, at 50 m/s and a lag of a second
constexpr float kShortestLeg_m = 1.0f;  // shorter ones have no direction: straight to the end

Offset operator+(const Offset& a, const Offset& b) {
    return {a.north_m + b.north_m, a.east_m + b.east_m};
}
Offset operator-(const Offset& a, const Offset& b) {
    return {a.north_m - b.north_m, a.east_m - b.east_m};
}
Offset operator*(const Offset& a, float s) { return {a.north_m * s, a.east_m * s}; }
float dot(const Offset& a, const Offset& b) { return a.north_m * b.north_m + a.east_m * b.east_m; }
float cross(const Offset& a, const Offset& b) {
    return a.north_m * b.east_m - a.east_m * b.north_m;
}
// North where there is none.
Offset directionOf(const Offset& a) {
    const float length_m = geo::length_m(a);
    return length_m > 0.1f ? a * core::inverse(length_m) : Offset{1, 0};
}
Offset rightOf(const Offset& a) { return {-a.east_m, a.north_m}; }

// Where the present bank will have brought the airplane when a new one takes effect.
struct Ahead {
    Offset moved_m;
    Offset velocity_mps;
    Offset turned_mps;  // what is turned to the course: the velocity; blown, that through the air
    float speed_mps, turned_length_mps;
    float airspeed_mps;
    float gained_mps;  // through the air, to the right, by the present bank
    float per_crab;    // 1 / cos of the angle between the course over ground and through the air
    bool blown;        // by a wind nearly as fast as the airplane, or faster
};
// By the wind: wherever it points, it moves downwind. Not inlined: that would take 2 bytes of
// stack.
__attribute__((noinline)) bool isOutrun(const Motion& motion) {
    constexpr uint16_t kBreeze_mps = core::sizeOfPower(2) + 0x40;  // 6, by the upper bits
    const Offset& wind = motion.wind_mps;
    if (core::sizeOf(wind.north_m) < kBreeze_mps && core::sizeOf(wind.east_m) < kBreeze_mps)
        return false;
    return core::squaredLength(wind.north_m, wind.east_m) > core::square(motion.airspeed_mps);
}
Ahead lookAhead(const Motion& motion) {
    Offset air = motion.velocity_mps - motion.wind_mps;
    const float airspeed = core::limit(motion.airspeed_mps, kSlowest_mps, 200.0f);
    const float gained_mps = motion.bank_accel_mss * motion.bank_lag_s;
    const Offset gained = rightOf(air) * (gained_mps / airspeed);
    Ahead ahead;
    ahead.velocity_mps = motion.velocity_mps + gained;
    ahead.moved_m = (motion.velocity_mps + ahead.velocity_mps) * core::half(motion.bank_lag_s);
    air = air + gained;
    const float moves_mps = geo::length_m(ahead.velocity_mps);
    ahead.speed_mps = core::limit(moves_mps, kSlowest_mps, 200.0f);
    const bool slow = moves_mps < motion.airspeed_mps * kMaxBackwards;
    ahead.blown = (slow || isOutrun(motion)) && motion.airspeed_mps > kFlies_mps;
    ahead.turned_mps = ahead.blown ? air : ahead.velocity_mps;
    ahead.turned_length_mps = ahead.blown ? airspeed : moves_mps;
    ahead.airspeed_mps = airspeed;
    ahead.gained_mps = gained_mps;
    const float together = dot(air, ahead.velocity_mps);
    const float product = airspeed * ahead.speed_mps;
    if (ahead.blown || together * kNegligibleCrab > product)
        ahead.per_crab = 1;
    else
        ahead.per_crab = together * kMaxPerCrab > product ? product / together : kMaxPerCrab;
    return ahead;
}

// Of the speeds over ground before and after a turn; by its acceleration that is its radius.
float meanSquare(float before_mps, float after_mps) {
    return core::half(core::squaredLength(before_mps, after_mps));
}

// Without a cross wind.
float along_mps(const Motion& motion, const Offset& forward) {
    return motion.airspeed_mps + dot(motion.wind_mps, forward);
}

// Sine of the angle at which the path is closed from `away_m`: linear near it, and where that
// would ask for too sharp a turn, the course of the arc that ends on it. A turn to a tail wind
// doubles the ground speed: an arc of the speed now is too small.
float closingSine(const LateralGains& gains, const Motion& motion, const Offset& forward,
                  float away_m, float speed_mps) {
    const float straight_mps = away_m * gains.closing_hz;
    if (away_m <= gains.linear_m && straight_mps < core::half(speed_mps))
        return straight_mps / speed_mps;
    const float begins_m = core::half(core::limit(gains.linear_m, 0.0f, away_m));
    const float after_mps = along_mps(motion, forward);
    const float share =
        (away_m - begins_m) * gains.turn_accel_mss / meanSquare(speed_mps, after_mps);
    if (share >= 1) return 1;
    const float arc = sqrtf(share * (2 - share));
    const float straight = straight_mps / speed_mps;
    return arc < straight ? arc : core::limit(straight, 0.0f, 1.0f);
}

float cosineOf(float sine) {
    const float squared = sine * sine;
    if (squared < 0.06f) return 1 - core::half(squared);  // within 5e-4
    return sqrtf(core::limit(1 - squared, 0.0f, 1.0f));
}

// The acceleration that turns the velocity towards `course`; all of it beyond a right angle. Nearly
// opposite to it the bank decides the side: in a wind about as fast as the airplane the velocity
// swings to and fro there while the nose turns, and would roll the airplane with it. Blown by the
// wind, the course over ground shows neither where the nose points nor what a bank changes: there
// the nose is turned to where wind and airspeed together make the course, and no farther into the
// wind than the steepest crab.
float turnTowards(const LateralGains& gains, const Ahead& ahead, const Offset& course) {
    float sine = cross(ahead.turned_mps, course);
    if (ahead.blown) {
        const float holds_mps = ahead.turned_length_mps * kMaxCrab_sin;
        sine -= core::limit(sine - cross(ahead.velocity_mps, course), -holds_mps, holds_mps);
    }
    if (core::isNegative(dot(ahead.turned_mps, course))) {
        constexpr float kAllBesideOpposite = 3;  // from 20 degrees beside it on
        const float most_mps = ahead.turned_length_mps;
        // by the present bank; more where the wind makes it fast
        const float turns_mps =
            ahead.gained_mps * core::square(ahead.speed_mps / ahead.airspeed_mps);
        sine = core::limit((sine + turns_mps) * kAllBesideOpposite, -most_mps, most_mps);
    }
    return sine * gains.turning_hz;
}

}  // namespace

LateralGains lateralGains(const LateralSettings& settings, float turn_accel_mss) {
    const float omega = 2 * core::kPi / core::limit(settings.period_s, 1.0f, 60.0f);
    const float twice_damping = 2 * core::limit(settings.damping, 0.4f, 2.0f);
    const float closing_hz = omega / twice_damping;
    return {closing_hz, omega * twice_damping, turn_accel_mss,
            turn_accel_mss / core::square(closing_hz)};
}

Leg legAlong(const Offset& start_to_end) {
    const float length_m = geo::length_m(start_to_end);
    if (length_m < kShortestLeg_m) return {{0, 0}, length_m};
    return {start_to_end * core::inverse(length_m), length_m};
}

Lateral followLeg(const LateralGains& gains, const Motion& motion, const Leg& leg,
                  const Offset& from_start) {
    if (leg.length_m < kShortestLeg_m) {
        const Offset back = from_start * -1.0f;
        Lateral out = followCourse(gains, motion, directionOf(back));
        out.distance_m = geo::length_m(back);
        out.along_m = leg.length_m - out.distance_m;
        return out;
    }
    Lateral out;
    out.along_m = dot(leg.forward, from_start);
    out.crosstrack_m = cross(leg.forward, from_start);
    out.distance_m = geo::length_m({leg.length_m - out.along_m, out.crosstrack_m});

    const Ahead ahead = lookAhead(motion);
    const Offset there = from_start + ahead.moved_m;
    const float off_m = cross(leg.forward, there);
    const float away_m = fabsf(off_m);
    float sine = closingSine(gains, motion, leg.forward, away_m, ahead.speed_mps);
    // farther on than the bank's lag moves it, it is not behind the start
    if (out.along_m < kLagMoves_m && core::isNegative(dot(leg.forward, there))) {
        const float to_start = away_m / core::limit(geo::length_m(there), 1.0f, 1e6f);
        if (to_start < sine) sine = to_start;
    }
    const float rightwards = core::isPositive(off_m) ? -sine : sine;
    out.course = leg.forward * cosineOf(sine) + rightOf(leg.forward) * rightwards;
    out.bank_accel_mss = turnTowards(gains, ahead, out.course) * ahead.per_crab;
    return out;
}

float turnLead_m(const LateralGains& gains, const Motion& motion, const Leg& leg, const Leg& next) {
    constexpr float kSharpest = -0.5f;
    const float cosine = core::limit(dot(leg.forward, next.forward), kSharpest, 1.0f);
    const float before_mps = along_mps(motion, leg.forward);
    const float radius_m =
        meanSquare(before_mps, along_mps(motion, next.forward)) / gains.turn_accel_mss;
    const float lead_m =
        radius_m * sqrtf((1 - cosine) / (1 + cosine)) + before_mps * motion.bank_lag_s;
    return core::limit(lead_m, 0.0f, core::half(fminf(leg.length_m, next.length_m)));
}

// Not inlined: its variables would lie in a stack frame beyond what an instruction reaches.
__attribute__((noinline)) Lateral followCircle(const LateralGains& gains, const Motion& motion,
                                               const Circle& circle, const Offset& from_centre) {
    const Ahead ahead = lookAhead(motion);
    const float radius_m = core::limit(circle.radius_m, kSmallestRadius_m, 1e5f);
    const Offset there = from_centre + ahead.moved_m;
    const float distance_m = geo::length_m(there);
    // in the very centre every way out is as good as the present one
    const Offset out_unit = distance_m > 1 ? there * core::inverse(distance_m)
                                           : ahead.velocity_mps * core::inverse(ahead.speed_mps);
    const float turn = circle.counter_clockwise ? -1.0f : 1.0f;
    const Offset along_unit = rightOf(out_unit) * turn;

    Lateral out;
    out.distance_m = geo::length_m(from_centre);
    out.crosstrack_m = out.distance_m - radius_m;
    out.along_m = 0;
    const float off_m = distance_m - radius_m;
    float sine = closingSine(gains, motion, along_unit, fabsf(off_m), ahead.speed_mps);
    bool on_tangent = false;
    if (core::isPositive(off_m)) {
        const float tangent = cosineOf(radius_m / distance_m);
        on_tangent = tangent < sine;
        if (on_tangent) sine = tangent;
    }
    const float outward = core::isPositive(off_m) ? -sine : sine;
    out.course = along_unit * cosineOf(sine) + out_unit * outward;

    float accel_mss = turnTowards(gains, ahead, out.course);
    const float along_mps = dot(ahead.velocity_mps, along_unit);
    if (!on_tangent && core::isPositive(along_mps)) {
        const float bend_m = core::limit(distance_m, core::half(radius_m), 1e6f);
        accel_mss += turn * core::square(along_mps) / bend_m;
    }
    out.bank_accel_mss = accel_mss * ahead.per_crab;
    return out;
}

Lateral followCourse(const LateralGains& gains, const Motion& motion, const Offset& course) {
    const Ahead ahead = lookAhead(motion);
    Lateral out;
    out.crosstrack_m = out.distance_m = out.along_m = 0;
    out.course = course;
    out.bank_accel_mss = turnTowards(gains, ahead, course) * ahead.per_crab;
    return out;
}

float bankFor_rad(float bank_accel_mss) {
    const float x = bank_accel_mss * (1.0f / core::kGravity_mss);
    const float size = fabsf(x);
    const bool steep = size > 1;
    const float t = steep ? core::inverse(size) : size;
    // minimax of atan on 0..1: Rajan et al., IEEE Signal Processing Magazine 23(3), 2006
    const float low = t * (core::kPi / 4 + 0.273f * (1 - t));
    const float angle = steep ? core::kPi / 2 - low : low;
    return copysignf(angle, x);
}

void BankTrim::learn(float left_of_path_m, float dt_s) {
    if (left_of_path_m > kTrimReach_m || left_of_path_m < -kTrimReach_m) return;  // a capture
    const float step = core::limit(left_of_path_m, -1.0f, 1.0f) * kTrimRate * dt_s;
    accel_mss_ = core::limit(accel_mss_ + step, -kMaxTrim_mss, kMaxTrim_mss);
}

void TurnCount::update(const Circle& circle, const Offset& from_centre, float crosstrack_m) {
    if (!captured_) {
        captured_ = crosstrack_m < kCaptured_m && crosstrack_m > -kCaptured_m;
        last_ = from_centre;
        return;
    }
    const float distance2 = dot(from_centre, from_centre);
    if (distance2 < 1) return;
    // a twentieth of a second is a small angle: it is its own sine
    const float step_rad = cross(last_, from_centre) / distance2;
    turned_rad_ += circle.counter_clockwise ? -step_rad : step_rad;
    last_ = from_centre;
}

}  // namespace navigation
