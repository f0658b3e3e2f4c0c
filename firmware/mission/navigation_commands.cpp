// SPDX-License-Identifier: GPL-3.0-or-later
// NAV: what the airplane flies to. A start writes vehicle.demand, a check reads vehicle.progress.
#include "core/based.hpp"
#include "core/file_state.hpp"
#include "core/maths.hpp"
#include "core/seldom.hpp"
#include "firmware/guidance/demand.hpp"
#include "firmware/guidance/lateral.hpp"
#include "firmware/mission/engine.hpp"
#include "firmware/mission/handlers.hpp"
#include "firmware/mission/host.hpp"
#include "firmware/mission/rally.hpp"
#include "firmware/mission/speed.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware/state/vehicle.hpp"
#include "hal/clock.hpp"

namespace firmware {
namespace mission {

using namespace state;
using namespace guidance;

namespace {

struct Place {
    geo::Position position;
    float height_m;  // above home
};
struct NavCommand {
    Place last;  // of the NAV that last finished
    bool have_last;
    bool no_place;  // what is flown ends where the airplane is
    float acceptance_m;
    bool leg_counts;    // it is longer than the acceptance radius
    bool turn_planned;  // acceptance_m is no less than the next turn needs, or the item's own
    // Of a loiter: radians or seconds since capture. `before`: until the last resume.
    float loitered_before, loitered;
    uint16_t loiter_ms;
    bool circle_captured;
    bool throttle_was_low;  // in a landing: the stick was below what breaks it off
    uint32_t still_ms;
    bool height_given;  // of a way home
};
core::FileState<NavCommand> nav{};

geo::Position placeOf(const Record& record) { return {record.p3, record.p4}; }

Place airplane() { return {vehicle.estimate.position, vehicle.estimate.height_m}; }

float loiterRadius_m() {
    const int16_t radius_m = parameters.loiter_radius_m;
    return static_cast<float>(radius_m < 0 ? -radius_m : radius_m);
}

bool counterClockwise(const Record& record) {
    return missionSet() == ::mission::Set::apm1
               ? parameters.loiter_radius_m < 0
               : (record.options & ::mission::kCounterClockwise) != 0;
}

// A climb near the ground is not put off, and a small step is flown at once.
bool worthASlope(const PathDemand& demand) {
    constexpr float kLow_m = 20;
    const float up_m = demand.height_m - demand.from_height_m;
    return fabsf(up_m) >= core::real(parameters.glide_slope_min_m) &&
           (core::isNegative(up_m) || vehicle.estimate.height_m > kLow_m);
}

void demand(Path path, const Place& to, LegStart start) {
    PathDemand& demand = beginPath();
    const Place from = start.from_here || !nav.have_last ? airplane() : nav.last;
    nav.no_place = path == Path::takeoff;
    demand.path = path;
    demand.from = from.position;
    demand.from_height_m = from.height_m;
    demand.to = to.position;
    demand.height_m = to.height_m;
    demand.sloped = path == Path::land || (path != Path::takeoff && worthASlope(demand));
    demand.radius_m = static_cast<float>(loiterRadius_m());
    demand.counter_clockwise = false;
    demand.climb_rate_mps = 0;
    if (!start.resumed) forgetClimb();
    demandSpeed();
    if (start.resumed) goOnClimbing();
}

void changeHeightAtOnce() { changePath().sloped = false; }

void turnCounterClockwise(bool counter_clockwise) {
    changePath().counter_clockwise = counter_clockwise;
}

void demandLeg(const Place& to, float radius_m, LegStart start) {
    demand(Path::leg, to, start);
    nav.acceptance_m = radius_m;
    nav.turn_planned = false;
    nav.leg_counts = geo::distance_m(vehicle.demand.from, to.position) > radius_m;
    if (!nav.leg_counts) changeHeightAtOnce();
}

Progress done(bool is) { return is ? Progress::done : Progress::running; }

// What guidance reports is about this path only after it has seen it.
bool progressIsOld() { return vehicle.demand.new_path; }

// Captured once is captured, until the loiter is started again.
bool onCircle() {
    if (progressIsOld()) return false;
    nav.circle_captured = nav.circle_captured || vehicle.progress.captured;
    return nav.circle_captured;
}

}  // namespace

float heightOf_m(const Record& record) {
    const bool relative = missionSet() == ::mission::Set::apm1
                              ? parameters.altitude_absolute == 0
                              : (record.options & ::mission::kRelativeAltitude) != 0;
    const int32_t zero_cm = relative ? 0 : vehicle.home.altitude_cm;
    return (static_cast<float>(record.p2) - static_cast<float>(zero_cm)) * 0.01f;
}

void here(Record& record) {
    record.p3 = vehicle.estimate.position.latitude_e7;
    record.p4 = vehicle.estimate.position.longitude_e7;
}

bool placeless() { return nav.no_place || vehicle.demand.path == Path::none; }

void rememberPlace() {
    const auto& demand = vehicle.demand;
    nav.last = nav.no_place ? airplane() : Place{demand.to, demand.height_m};
    nav.have_last = true;
}

void forgetPlace() { nav.have_last = false; }

void missionShiftHeights(float by_m) {
    nav.last.height_m += by_m;
    shiftClimb(by_m);
}

void holdPlace() {
    if (!nav.have_last) {
        nav.last = airplane();
        nav.have_last = true;
    }
    demand(Path::circle, nav.last, {false, true});
    turnCounterClockwise(parameters.loiter_radius_m < 0);
}

void startWaypoint(const Record& record, LegStart start) {
    const int16_t radius_m = record.p1 != 0 ? record.p1 : parameters.waypoint_radius_m;
    demandLeg({placeOf(record), heightOf_m(record)}, core::real(radius_m), start);
    nav.turn_planned = record.p1 != 0;  // an item's own radius is as it says
}

namespace {

// A leg too short to count was passed beside the waypoint: along its line it would fly away.
SELDOM void flyFromHere() {
    beginPath().from = vehicle.estimate.position;
    nav.leg_counts = true;
}

Progress legDone() {
    if (progressIsOld()) return Progress::running;
    const auto& progress = vehicle.progress;
    if (progress.distance_m <= nav.acceptance_m) return Progress::done;
    if (!progress.passed) return Progress::running;
    if (nav.leg_counts) return Progress::done;
    flyFromHere();
    return Progress::running;
}

// Planned once, where no turn begins yet: 22 m/s with a bank of 45 degrees need 80 m for a corner.
// Not while a CONDITION runs: what is behind it would be dropped.
SELDOM void planTurn() {
    if (mission_engine.conditionRuns()) return;
    geo::Position next;
    const core::Status status = nextPlace(next);
    if (status == core::Status::busy) return;
    nav.turn_planned = true;
    if (status == core::Status::ok) nav.acceptance_m = fmaxf(nav.acceptance_m, turnLead_m(next));
}

}  // namespace

Progress waypointDone(const Record&) {
    constexpr uint16_t kNear_m = core::sizeOfPower(8);  // 256, by the upper bits
    if (progressIsOld()) return Progress::running;
    if (!nav.turn_planned && core::sizeOf(vehicle.progress.distance_m) < kNear_m) planTurn();
    return legDone();
}

void startCircle(const Record& record, LegStart start) {
    demand(Path::circle, {placeOf(record), heightOf_m(record)}, start);
    turnCounterClockwise(counterClockwise(record));
    nav.loitered_before = start.resumed ? nav.loitered : 0;
    nav.loitered = nav.loitered_before;
    nav.loiter_ms = static_cast<uint16_t>(hal::now_ms());
    nav.circle_captured = false;
}

Progress never(const Record&) { return Progress::running; }
Progress done(const Record&) { return Progress::done; }

Progress turnsDone(const Record& record) {
    if (!onCircle()) return Progress::running;
    nav.loitered = nav.loitered_before + vehicle.progress.turned_rad;
    return done(nav.loitered >= core::real(record.p1) * (2 * core::kPi));
}

Progress timeDone(const Record& record) {
    const uint16_t now_ms = static_cast<uint16_t>(hal::now_ms());
    const uint16_t passed_ms = static_cast<uint16_t>(now_ms - nav.loiter_ms);
    nav.loiter_ms = now_ms;
    const bool counts = nav.circle_captured;
    if (!onCircle()) return Progress::running;
    if (counts) nav.loitered += passed_ms * 0.001f;
    return done(nav.loitered >= core::real(record.p1) * 10.0f);
}

void startReturn(const Record& record, LegStart start) {
    Place home = airplane();
    if (vehicle.home.set) home.position = vehicle.home.position;
    if (record.p2 != 0)
        home.height_m = heightOf_m(record);
    else if (parameters.rtl_height_cm >= 0)
        home.height_m = core::hundredths(parameters.rtl_height_cm);
    demandLeg(home, core::real(parameters.waypoint_radius_m), start);
    nav.height_given = record.p2 != 0;
    rallyBegin();
}

namespace {

// A climb that has begun goes on.
void returnTo(const geo::Position& place, float height_m) {
    if (nav.height_given) height_m = vehicle.demand.height_m;
    demandLeg({place, height_m}, core::real(parameters.waypoint_radius_m), {true, true});
}

}  // namespace

Progress returnDone(const Record&) {
    rallyLook(returnTo);
    return legDone();
}

void startLand(const Record& record, LegStart start) {
    demand(Path::land, {placeOf(record), heightOf_m(record)}, start);
    nav.still_ms = hal::now_ms();
    nav.throttle_was_low = false;
}

namespace {

// The landing was broken off.
Progress climbAway() {
    constexpr float kNear_m = 1;
    if (vehicle.estimate.height_m >= vehicle.demand.height_m - kNear_m) landAgain();
    return Progress::running;
}

}  // namespace

// Finished when down and disarmed; disarms itself when the airplane has stood long enough.
Progress landDone(const Record&) {
    if (vehicle.demand.path == Path::leg) return climbAway();
    breakOffByThrottle(nav.throttle_was_low);
    const uint32_t now_ms = hal::now_ms();
    const bool down = !vehicle.estimate.flying;
    if (down && !vehicle.armed) return Progress::done;
    if (!down) nav.still_ms = now_ms;
    const uint16_t delay_s = static_cast<uint8_t>(parameters.land_disarm_delay_s);
    if (delay_s != 0 && now_ms - nav.still_ms >= delay_s * 1000UL) host.disarmAfterLanding();
    return Progress::running;
}

void startTakeoff(const Record& record, LegStart start) {
    start.from_here = true;
    demand(Path::takeoff, {vehicle.estimate.position, heightOf_m(record)}, start);
    changePath().takeoff_pitch_rad = core::radians(core::real(record.p1));
}

Progress takeoffDone(const Record& record) {
    constexpr float kNear_m = 1;  // the demanded height is approached ever more slowly
    return done(vehicle.armed && vehicle.estimate.height_m >= heightOf_m(record) - kNear_m);
}

namespace {

// As long as a place far ahead can be true.
geo::Position straightAhead() {
    constexpr float kAhead_m = 5000, kSlowest_mps = 3;  // a slower course is noise
    const auto& now = core::based(vehicle.estimate);
    if (now.ground_speed_mps >= kSlowest_mps) {
        const float share = kAhead_m / now.ground_speed_mps;
        return geo::moved(now.position, {now.velocity_mps.x * share, now.velocity_mps.y * share});
    }
    const float heading_rad = vehicle.attitude.yaw_rad.toFloat();
    return geo::moved(now.position, {cosf(heading_rad) * kAhead_m, sinf(heading_rad) * kAhead_m});
}

// Of 1 to 2 ends of the way at most as much is left as of a take-off's.
constexpr float kNear_m = 5, kAlmost_m = 1;

}  // namespace

// The whole line is flown, also beyond its end.
void startContinue(const Record& record, LegStart start) {
    start.from_here = true;
    demand(Path::leg, {straightAhead(), heightOf_m(record)}, start);
    changeHeightAtOnce();
    nav.no_place = true;
}

Progress continueDone(const Record& record) {
    const float left_m = heightOf_m(record) - vehicle.estimate.height_m;
    constexpr uint8_t kClimb = 1, kDescend = 2;
    if (record.p1 == kClimb) return done(left_m <= kAlmost_m);
    if (record.p1 == kDescend) return done(left_m >= -kAlmost_m);
    return done(fabsf(left_m) <= kNear_m);
}

namespace {

// The course over ground is that of the next leg, which begins at the circle's centre.
bool headsForNext() {
    constexpr int32_t kNear_cd = 1000;
    geo::Position place;
    const core::Status status = nextPlace(place);
    if (status != core::Status::ok) return status != core::Status::busy;
    const int32_t off_cd =
        core::wrap180_cd(vehicle.estimate.course_cd - geo::bearing_cd(vehicle.demand.to, place));
    return off_cd >= -kNear_cd && off_cd <= kNear_cd;
}

}  // namespace

Progress toHeightDone(const Record& record) {
    if (!onCircle()) return Progress::running;
    if (fabsf(heightOf_m(record) - vehicle.estimate.height_m) > kNear_m) return Progress::running;
    return done(record.p1 == 0 || headsForNext());
}

}  // namespace mission
}  // namespace firmware
