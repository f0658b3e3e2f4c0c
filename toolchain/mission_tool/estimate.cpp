// SPDX-License-Identifier: GPL-3.0-or-later
#include "toolchain/mission_tool/estimate.hpp"

#include <algorithm>
#include <cmath>

#include "firmware/state/parameters.hpp"
#include "simulator/airplane/atmosphere.hpp"
#include "toolchain/mission_tool/legs.hpp"
#include "toolchain/mission_tool/turns.hpp"

namespace mission_tool {
namespace {

using firmware::state::parameters;
using mission::Record;
using mission::Set;
using simulator::Point;

enum Id : uint8_t {
    kWaypoint = 0x10,
    kUnlimited = 0x11,
    kTurns = 0x12,
    kTime = 0x13,
    kReturn = 0x14,
    kLand = 0x15,
    kTakeoff = 0x16,
    kContinue = 0x1E,
    kToAltitude = 0x1F,
    kChangeAltitude1 = 0x21,
    kCruise1 = 0x40,
    kChangeAltitude = 0x71,
    kChangeSpeed = 0xB2,
};
constexpr double kMetresPerCm = 0.01;

bool circles(uint8_t id) { return id == kUnlimited || id == kTurns || id == kTime || id == kToAltitude; }

class Reckoning {
public:
    Reckoning(const Document& document, const FlightOrder& order, const Power& power,
              const Wind& wind)
        : document_(document), order_(order), power_(power), wind_(wind),
          frame_(degrees(document.entries[0].record.p3), degrees(document.entries[0].record.p4)),
          home_m_(document.entries[0].record.p2 * kMetresPerCm),
          indicated_mps_(parameters.cruise_speed_cms * kMetresPerCm) {}

    Estimate all() {
        total_.capacity_mah = power_.capacity_mah();
        const double cruise_mps = airspeedOf_mps(indicated_mps_, home_m_);
        full_climb_mps_ = power_.largestClimb_mps(cruise_mps);
        total_.largest_climb_mps = std::max(
            0.0, std::min<double>(parameters.speed_height.climb_max_mps, full_climb_mps_));
        total_.largest_sink_mps = parameters.speed_height.sink_max_mps;
        for (size_t i = 0; i < order_.visits.size(); ++i)
            if (order_.visits[i].nav != 0) fly(i);
        return total_;
    }

private:
    static double degrees(int32_t e7) { return e7 * 1e-7; }
    const Record& recordOf(size_t item) const { return document_.entries[item].record; }

    Point placeOf(const Record& record) const {
        return frame_.at(degrees(record.p3), degrees(record.p4));
    }

    // What the commands beside it demand; each counts from the beginning of its NAV.
    void takeDemands(const Visit& visit, Stretch& stretch) {
        for (const size_t item : visit.beside) {
            const Record& record = recordOf(item);
            const bool first = document_.set == Set::apm1;
            if (record.id == (first ? kChangeAltitude1 : kChangeAltitude))
                stretch.wanted_height_m = heightOf_m(document_, item);
            if (first && record.id == kCruise1) demandAirspeed(record.p1);
            if (!first && record.id == kChangeSpeed && record.p2 != -1) {
                const double speed_mps = record.p4 != 0 ? record.p4 * kMetresPerCm : record.p2;
                if (record.p1 == 0) {
                    demandAirspeed(speed_mps);
                } else {
                    demanded_ground_mps_ = speed_mps;
                }
            }
        }
    }
    void demandAirspeed(double indicated_mps) {
        indicated_mps_ = indicated_mps;
        demanded_ground_mps_.reset();
    }

    double airspeed_mps(double course_rad, double height_m) const {
        const double true_mps = airspeedOf_mps(indicated_mps_, home_m_ + height_m);
        if (!demanded_ground_mps_) return true_mps;
        const double missing_mps =
            *demanded_ground_mps_ - groundSpeed_mps(true_mps, wind_, course_rad);
        return std::max<double>(parameters.speed_min_mps,
                                std::min<double>(parameters.speed_max_mps, true_mps + missing_mps));
    }

    void fly(size_t number) {
        const Visit& visit = order_.visits[number];
        const Record& record = recordOf(visit.nav);
        Stretch stretch;
        stretch.nav = visit.nav;
        stretch.from = visit.from_here || !last_ ? at_ : *last_;
        stretch.from_height_m = height_m_;
        stretch.wanted_height_m = wantedHeight(visit.nav);
        takeDemands(visit, stretch);
        stretch.placed = hasPlace(document_.entries[visit.nav]);
        stretch.to = stretch.placed ? placeOf(record) : record.id == kReturn ? Point{} : stretch.from;
        if (record.id == kTakeoff || record.id == kContinue) {
            climbStraightOn(number, stretch);
        } else {
            flyThere(stretch, record.id == kLand);
            if (circles(record.id)) circle(stretch, record);
        }
        add(stretch);
    }

    double wantedHeight(size_t nav) const {
        const Record& record = recordOf(nav);
        if (record.id != kReturn || record.p2 != 0) return heightOf_m(document_, nav);
        return parameters.rtl_height_cm < 0 ? height_m_ : parameters.rtl_height_cm * kMetresPerCm;
    }

    double climbLimited(const Stretch& stretch, double time_s, double climb_mps) const {
        const double up_m = stretch.wanted_height_m - stretch.from_height_m;
        return stretch.from_height_m +
               std::clamp(up_m, -total_.largest_sink_mps * time_s, climb_mps * time_s);
    }

    void flyThere(Stretch& stretch, bool landing) {
        const double course = courseTo(stretch.from, stretch.to);
        const double length_m = simulator::distance_m(stretch.from, stretch.to);
        const double indicated_mps = indicated_mps_;
        if (landing) indicated_mps_ = approachSpeed_mps(course);
        stretch.airspeed_mps = airspeed_mps(course, stretch.from_height_m);
        stretch.ground_mps = groundSpeed_mps(stretch.airspeed_mps, wind_, course);
        indicated_mps_ = indicated_mps;
        if (stretch.ground_mps <= 0) return;
        const double time_s = length_m / stretch.ground_mps;
        stretch.length_m = length_m;
        stretch.needed_climb_mps =
            time_s > 0 ? (stretch.wanted_height_m - stretch.from_height_m) / time_s : 0;
        stretch.height_m = landing ? stretch.wanted_height_m
                                   : climbLimited(stretch, time_s, total_.largest_climb_mps);
        if (stretch.circle_m > 0 || time_s == 0) stretch.needed_climb_mps = 0;
        spend(stretch, time_s, stretch.height_m - stretch.from_height_m, 1);
    }

    // As firmware/guidance/landing.cpp has it.
    double approachSpeed_mps(double course_rad) const {
        constexpr double kShare = 0.55, kOfHeadwind = 0.6, kMaxForHeadwind_mps = 3;
        const double headwind_mps =
            wind_.from_deg ? wind_.speed_mps * std::cos(*wind_.from_deg * M_PI / 180 - course_rad)
                           : wind_.speed_mps;
        return parameters.speed_min_mps + kShare * (indicated_mps_ - parameters.speed_min_mps) +
               std::clamp(kOfHeadwind * headwind_mps, 0.0, kMaxForHeadwind_mps);
    }

    void climbStraightOn(size_t number, Stretch& stretch) {
        const bool takeoff = recordOf(stretch.nav).id == kTakeoff;
        const double course = headingAfter(number);
        const double climb_mps = takeoff ? full_climb_mps_ : total_.largest_climb_mps;
        const double up_m = stretch.wanted_height_m - stretch.from_height_m;
        const double rate_mps = up_m >= 0 ? climb_mps : total_.largest_sink_mps;
        stretch.airspeed_mps = airspeed_mps(course, stretch.from_height_m);
        stretch.ground_mps = groundSpeed_mps(stretch.airspeed_mps, wind_, course);
        if (rate_mps <= 0 || (takeoff && up_m < 0)) return;
        const double time_s = std::abs(up_m) / rate_mps;
        stretch.length_m = std::max(0.0, stretch.ground_mps) * time_s;
        stretch.to = {stretch.from.north_m + stretch.length_m * std::cos(course),
                      stretch.from.east_m + stretch.length_m * std::sin(course)};
        stretch.height_m = stretch.wanted_height_m;
        spend(stretch, time_s, up_m, 1);
    }

    // The take-off run points at the next place, as a runway does.
    double headingAfter(size_t number) const {
        for (size_t i = number + 1; i < order_.visits.size(); ++i) {
            const size_t nav = order_.visits[i].nav;
            if (nav == 0 || !hasPlace(document_.entries[nav])) continue;
            const Point to = placeOf(recordOf(nav));
            if (simulator::distance_m(at_, to) >= 1) return courseTo(at_, to);
        }
        return 0;
    }
    static double courseTo(const Point& from, const Point& to) {
        return std::atan2(to.east_m - from.east_m, to.north_m - from.north_m);
    }

    void circle(Stretch& stretch, const Record& record) {
        stretch.circle_m = std::abs(parameters.loiter_radius_m);
        const double slowest_mps = stretch.airspeed_mps - wind_.speed_mps;
        const double load = loadOn(stretch);
        const double turn_s = slowest_mps > 0 ? timeOfTurn(stretch) : 0;
        const double left_m = stretch.wanted_height_m - stretch.height_m;
        const double climb_mps =
            left_m >= 0 ? total_.largest_climb_mps : total_.largest_sink_mps;
        double time_s = 0;
        if (record.id == kTurns) time_s = record.p1 * turn_s;
        if (record.id == kTime) time_s = record.p1 * 10.0;
        if (record.id == kToAltitude && climb_mps > 0) time_s = std::abs(left_m) / climb_mps;
        stretch.turns = turn_s > 0 ? time_s / turn_s : 0;
        stretch.length_m += stretch.turns * 2 * M_PI * stretch.circle_m;
        const double before_m = stretch.height_m;
        stretch.height_m = before_m + std::clamp(left_m, -total_.largest_sink_mps * time_s,
                                                 std::max(0.0, climb_mps) * time_s);
        // the climb may be ended on the circle
        stretch.needed_climb_mps = 0;
        spend(stretch, time_s, stretch.height_m - before_m, load);
    }
    double timeOfTurn(const Stretch& stretch) const {
        constexpr int kParts = 72;
        double time_s = 0;
        for (int i = 0; i < kParts; ++i)
            time_s += 2 * M_PI * stretch.circle_m / kParts /
                      groundSpeed_mps(stretch.airspeed_mps, wind_, i * 2 * M_PI / kParts);
        return time_s;
    }
    static double loadOn(const Stretch& stretch) {
        const double sideways =
            stretch.circle_m > 0 ? stretch.airspeed_mps * stretch.airspeed_mps / stretch.circle_m /
                                       simulator::kGravity_mss
                                 : 0;
        return std::min(2.0, std::hypot(1, sideways));
    }

    void spend(Stretch& stretch, double time_s, double up_m, double load) const {
        constexpr double kMahPerAs = 1 / 3.6;
        if (time_s <= 0) return;
        stretch.time_s += time_s;
        const double per_true =
            1 / airspeedOf_mps(1, home_m_ + (stretch.from_height_m + stretch.height_m) / 2);
        const double indicated_mps = std::max(5.0, stretch.airspeed_mps * per_true);
        stretch.used_mah +=
            power_.battery_a(indicated_mps, up_m / time_s, load) * time_s * kMahPerAs;
    }

    // What the arc between two legs is shorter than the way to the corner and on: half of it on
    // each. It begins no more than half of the shorter leg before the corner. A sharp turn swings
    // out, and is not counted as shorter than one by a right angle.
    void cutCorner(Stretch& before, Stretch& after) {
        constexpr double kSharpest_rad = M_PI / 2;
        const double turn_rad = std::min(turnBetween_rad(before, after), kSharpest_rad);
        if (turn_rad <= 0 || before.ground_mps <= 0 || after.ground_mps <= 0) return;
        const double speed_mps = std::sqrt(
            (before.ground_mps * before.ground_mps + after.ground_mps * after.ground_mps) / 2);
        const double tangent = std::tan(turn_rad / 2);
        const double radius_m =
            std::min(turnRadius_m(after.airspeed_mps, speed_mps),
                     std::min(before.length_m, after.length_m) / 2 / tangent);
        const double saved_m = radius_m * (2 * tangent - turn_rad);
        for (Stretch* leg : {&before, &after}) {
            const double time_s = leg->time_s, saved_s = saved_m / 2 / leg->ground_mps;
            leg->time_s -= saved_s;
            leg->used_mah *= 1 - saved_s / time_s;
        }
    }

    void add(Stretch stretch) {
        if (!total_.stretches.empty()) {
            Stretch& before = total_.stretches.back();
            const double time_s = before.time_s, used_mah = before.used_mah;
            cutCorner(before, stretch);
            total_.time_s += before.time_s - time_s;
            total_.used_mah += before.used_mah - used_mah;
        }
        at_ = stretch.to;
        height_m_ = stretch.height_m;
        if (stretch.placed || recordOf(stretch.nav).id == kReturn) {
            last_ = stretch.to;
        } else {
            last_.reset();
        }
        total_.stretches.push_back(stretch);
        total_.length_m += stretch.length_m;
        total_.time_s += stretch.time_s;
        total_.used_mah += stretch.used_mah;
        total_.climbed_m += std::max(0.0, stretch.height_m - stretch.from_height_m);
        total_.highest_m = std::max(total_.highest_m, stretch.height_m);
        total_.farthest_m = std::max(total_.farthest_m,
                                     std::hypot(at_.north_m, at_.east_m) + stretch.circle_m);
    }

    const Document& document_;
    const FlightOrder& order_;
    const Power& power_;
    const Wind wind_;
    const simulator::LocalFrame frame_;
    const double home_m_;
    double indicated_mps_;
    std::optional<double> demanded_ground_mps_;
    double full_climb_mps_ = 0;
    Point at_;
    std::optional<Point> last_;
    double height_m_ = 0;
    Estimate total_;
};

}  // namespace

double groundSpeed_mps(double airspeed_mps, const Wind& wind, double course_rad) {
    if (!wind.from_deg) return airspeed_mps - wind.speed_mps;
    const double to_rad = (*wind.from_deg + 180) * M_PI / 180 - course_rad;
    const double along_mps = wind.speed_mps * std::cos(to_rad);
    const double across_mps = wind.speed_mps * std::sin(to_rad);
    if (std::abs(across_mps) >= airspeed_mps) return -1;
    return std::sqrt(airspeed_mps * airspeed_mps - across_mps * across_mps) + along_mps;
}

double heightOf_m(const Document& document, size_t index) {
    const double above_m = document.entries[index].record.p2 * kMetresPerCm;
    return aboveHome(document, index) ? above_m
                                      : above_m - document.entries[0].record.p2 * kMetresPerCm;
}

double airspeedOf_mps(double indicated_mps, double above_sea_m) {
    constexpr double kLowest_m = -500, kHighest_m = 10'000;
    const double density =
        simulator::atmosphere(std::clamp(above_sea_m, kLowest_m, kHighest_m)).density_kgm3;
    return indicated_mps * std::sqrt(simulator::kSeaLevelDensity_kgm3 / density);
}

Estimate estimate(const Document& document, const FlightOrder& order, const Power& power,
                  const Wind& wind) {
    if (!onEarth(document.entries[0].record)) return {};
    return Reckoning(document, order, power, wind).all();
}

}  // namespace mission_tool
