// SPDX-License-Identifier: GPL-3.0-or-later
#include "toolchain/mission_tool/flight_findings.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "firmware/mission/command_table.hpp"
#include "firmware/state/parameters.hpp"
#include "simulator/airplane/atmosphere.hpp"
#include "toolchain/mission_tool/columns.hpp"
#include "toolchain/mission_tool/fence_check.hpp"
#include "toolchain/mission_tool/legs.hpp"
#include "toolchain/mission_tool/turns.hpp"

namespace mission_tool {
namespace {

using firmware::state::parameters;
using mission::Class;
using mission::Set;
using simulator::kGravity_mss;
using simulator::Point;

constexpr uint8_t kReturn = 0x14, kLand = 0x15, kTakeoff = 0x16;
constexpr double kHalfTheGlobe_m = 20'003'931;  // WGS84, from pole to pole
constexpr double kNearFence_m = 20;
constexpr double kDegree = M_PI / 180;

class FlightInspection {
public:
    FlightInspection(const Document& document, const FlightOrder& order, const Estimate& flight,
                     const Conditions& conditions)
        : document_(document),
          order_(order),
          flight_(flight),
          conditions_(conditions),
          frame_(document.entries[0].record.p3 * 1e-7, document.entries[0].record.p4 * 1e-7),
          fence_(conditions.fence, frame_) {}

    std::vector<Finding> all() {
        beginningAndEnd();
        legsAndLoops();
        fence();
        for (size_t i = 0; i < flight_.stretches.size(); ++i) stretch(i);
        heightOfReturn();
        battery();
        std::stable_sort(found_.begin(), found_.end(),
                         [](const Finding& a, const Finding& b) { return a.index < b.index; });
        return found_;
    }

private:
    // Once for an item, however often it is flown.
    void add(bool error, size_t index, const std::string& text) {
        if (said_.emplace(index, text).second) found_.push_back({error, index, text});
    }
    void warn(size_t index, const std::string& text) { add(false, index, text); }
    void refuse(size_t index, const std::string& text) { add(true, index, text); }

    uint8_t idOf(size_t item) const { return document_.entries[item].record.id; }

    void beginningAndEnd() {
        if (order_.visits.empty()) return;
        if (idOf(order_.visits.front().nav) != kTakeoff)
            warn(order_.visits.front().nav,
                 std::string("no TAKEOFF before it: the flight begins with ") +
                     nameOf(document_.entries[order_.visits.front().nav]));
        const size_t last = order_.visits.back().nav;
        if (order_.end == FlightOrder::End::longer) {
            warn(last, "more than " + std::to_string(order_.visits.size()) +
                           " NAVs are flown: what follows is not looked at");
        } else if (order_.end != FlightOrder::End::landed) {
            warn(last, "no LAND: the mission " + endOf(order_));
        }
    }

    // ---- without an airplane
    void legsAndLoops() {
        const std::vector<Leg> legs = legsOf(document_);
        for (size_t i = 1; i < legs.size(); ++i) {
            if (legs[i].known && legs[i].length_m > kHalfTheGlobe_m)
                refuse(i, format("a leg of %.0f km, longer than half the globe, %.0f km",
                                 static_cast<double>(legs[i].length_m) / 1000,
                                 kHalfTheGlobe_m / 1000));
            if (document_.entries[i].is(Class::jump)) loop(i);
        }
    }

    size_t target(size_t jump) const {
        const mission::Record& record = document_.entries[jump].record;
        constexpr uint8_t kReset = 0x31;
        if (record.id == kReset) return 1;
        const bool by_p2 = document_.set == Set::apm1 && record.p2 != 0;
        return static_cast<size_t>(by_p2 ? record.p2 : record.p1);
    }

    // The next jump that is reached from this one with neither a NAV nor a CONDITION between them.
    size_t nextJump(size_t jump) const {
        for (size_t i = target(jump); i < document_.entries.size(); ++i) {
            const Entry& entry = document_.entries[i];
            if (entry.is(Class::jump)) return i;
            if (entry.is(Class::nav) || entry.is(Class::condition)) break;
        }
        return 0;
    }

    bool counts(size_t jump) const {
        return document_.set == Set::apm2 && document_.entries[jump].record.p3 != mission::kForEver;
    }

    // Of jumps for ever it is said for every form of a mission, findings.cpp.
    void loop(size_t jump) {
        std::string way = std::to_string(jump);
        size_t at = jump;
        bool counted = counts(jump);
        for (size_t steps = 0; steps < document_.entries.size(); ++steps) {
            at = nextJump(at);
            if (at == 0 || at < jump) return;  // of one that began before, it is said there
            way += " to " + std::to_string(at);
            counted = counted || counts(at);
            if (at == jump) break;
        }
        if (at == jump && counted)
            warn(jump, "jumps in a circle, " + way +
                           ", with neither a NAV nor a CONDITION on the way: the firmware passes "
                           "over them when it has gone round");
    }

    // ---- the fence
    void fence() {
        const auto& fence = conditions_.fence;
        if (!fence.given()) return;
        for (const FenceProblem& each : problemsOf(fence, frame_))
            add(each.error, 0, "fence: " + each.text);
        const double home_m = fence_.outside_m({});
        if (home_m > 0) refuse(0, format("home lies %.0f m outside the fence", home_m));
        for (size_t i = 0; i < document_.rally.size(); ++i) {
            const auto& place = document_.rally[i].place;
            const double outside_m =
                fence_.outside_m(frame_.at(place.latitude_deg, place.longitude_deg));
            if (outside_m > 0)
                refuse(0,
                       format("rally point %zu lies %.0f m outside the fence", i + 1, outside_m));
        }
    }

    void againstFence(const Stretch& s) {
        if (!conditions_.fence.areas.empty()) {
            line(s.nav, "the leg", fence_.outsideOnLeg_m(s.from, s.to));
            if (s.circle_m > 0)
                line(s.nav, format("the circle of %.0f m", s.circle_m),
                     fence_.outsideOnCircle_m(s.to, s.circle_m));
        }
        if (parameters.fence_max_m <= parameters.fence_min_m) return;
        const double highest_m = std::max(s.height_m, s.from_height_m);
        if (highest_m > parameters.fence_max_m)
            refuse(s.nav, format("flies at %.0f m above home, over FENCE_MAXALT, %d m", highest_m,
                                 int{parameters.fence_max_m}));
        const bool low_is_meant = idOf(s.nav) == kLand || idOf(s.nav) == kTakeoff;
        if (!low_is_meant && s.height_m < parameters.fence_min_m)
            refuse(s.nav, format("flies at %.0f m above home, under FENCE_MINALT, %d m", s.height_m,
                                 int{parameters.fence_min_m}));
    }
    void line(size_t nav, const std::string& what, double outside_m) {
        if (outside_m > 0) {
            refuse(nav, what + format(" leaves the fence by %.0f m", outside_m));
        } else if (outside_m > -kNearFence_m) {
            warn(nav, what + format(" comes within %.0f m of the fence, nearer than %.0f m",
                                    -outside_m, kNearFence_m));
        }
    }

    // ---- what the airplane can do
    void stretch(size_t number) {
        const Stretch& s = flight_.stretches[number];
        againstFence(s);
        const double away_m = std::hypot(s.to.north_m, s.to.east_m) + s.circle_m;
        if (away_m > conditions_.range_m)
            warn(s.nav, format("%.0f m from home, farther than %.0f m (--range)", away_m,
                               conditions_.range_m));
        if (s.ground_mps <= 0) {
            refuse(s.nav, format("is not reached: the wind of %.1f m/s against an airspeed of "
                                 "%.1f m/s",
                                 conditions_.wind.speed_mps, s.airspeed_mps));
            return;
        }
        climb(s);
        if (s.circle_m > 0) bankOfCircle(s);
        turns(number);
    }

    void climb(const Stretch& s) {
        constexpr double kTolerance = 1.02;
        const double limit_mps =
            s.needed_climb_mps > 0 ? flight_.largest_climb_mps : flight_.largest_sink_mps;
        if (std::abs(s.needed_climb_mps) <= limit_mps * kTolerance) return;
        const bool up = s.needed_climb_mps > 0;
        const double length_m = simulator::distance_m(s.from, s.to);
        const double gradient = 100 * (s.wanted_height_m - s.from_height_m) / length_m;
        std::string text = format("needs %s %.1f m/s (a gradient of %.0f %%), more than %.1f (%s)",
                                  up ? "a climb of" : "a sink of", std::abs(s.needed_climb_mps),
                                  gradient, limit_mps, up ? "TECS_CLMB_MAX" : "TECS_SINK_MAX");
        if (s.wanted_height_m != s.height_m)
            text += format(": arrives at %.0f m, not %.0f", s.height_m, s.wanted_height_m);
        warn(s.nav, text);
    }

    double fastest_mps(const Stretch& s) const {
        return s.airspeed_mps + conditions_.wind.speed_mps;
    }

    void bankOfCircle(const Stretch& s) {
        const double speed_mps = fastest_mps(s), limit_deg = bankLimit_deg(s.airspeed_mps);
        const double bank_deg =
            std::atan2(speed_mps * speed_mps, s.circle_m * kGravity_mss) / kDegree;
        if (bank_deg > limit_deg)
            warn(s.nav,
                 format("the circle of %.0f m needs %.0f degrees of bank at %.1f m/s over the "
                        "ground, more than %.0f (LIM_ROLL_CD and the lowest speed)",
                        s.circle_m, bank_deg, speed_mps, limit_deg));
    }

    void turns(size_t number) {
        const Stretch& s = flight_.stretches[number];
        if (s.circle_m > 0 || !s.placed) return;
        const double speed_mps = fastest_mps(s);
        const double needed_m =
            turnRadius_m(s.airspeed_mps, speed_mps) *
            (leadOf(number) + (number + 1 < flight_.stretches.size() ? leadOf(number + 1) : 0));
        const double length_m = simulator::distance_m(s.from, s.to);
        const double planned_deg = std::atan(turnTangent(s.airspeed_mps)) / kDegree;
        if (length_m > 1 && length_m < needed_m)
            warn(s.nav,
                 format("the leg of %.0f m is shorter than the %.0f m that the turns at its "
                        "ends take at %.1f m/s, planned with %.0f of %.0f degrees of bank",
                        length_m, needed_m, speed_mps, planned_deg, bankLimit_deg(s.airspeed_mps)));
    }

    // Of the turn into this stretch: how far before the corner it begins, in radii.
    double leadOf(size_t number) const {
        constexpr double kSharpest = 150 * kDegree;
        if (number == 0) return 0;
        const double turn_rad =
            turnBetween_rad(flight_.stretches[number - 1], flight_.stretches[number]);
        return std::tan(std::min(turn_rad, kSharpest) / 2);
    }

    void heightOfReturn() {
        if (parameters.rtl_height_cm < 0) return;
        const double height_m = parameters.rtl_height_cm * 0.01;
        if (parameters.fence_max_m > parameters.fence_min_m && height_m > parameters.fence_max_m)
            refuse(0, format("RTL flies at %.0f m (ALT_HOLD_RTL), over FENCE_MAXALT, %d m",
                             height_m, int{parameters.fence_max_m}));
        double lowest_m = INFINITY;
        size_t lowest = 0;
        for (const Stretch& s : flight_.stretches) {
            const uint8_t id = idOf(s.nav);
            if (!s.placed || id == kReturn || id == kLand || s.wanted_height_m >= lowest_m)
                continue;
            lowest_m = s.wanted_height_m;
            lowest = s.nav;
        }
        if (height_m < lowest_m && lowest != 0)
            warn(0, format("RTL flies at %.0f m (ALT_HOLD_RTL), lower than the lowest place of the "
                           "mission, %.0f m at item %zu",
                           height_m, lowest_m, lowest));
    }

    void battery() {
        constexpr double kShare = 0.8;
        if (flight_.capacity_mah <= 0 || flight_.used_mah <= kShare * flight_.capacity_mah) return;
        const std::string text = format("the flight takes %.0f mAh, more than ", flight_.used_mah);
        if (flight_.used_mah > flight_.capacity_mah) {
            refuse(0, text + format("the battery's %.0f", flight_.capacity_mah));
        } else {
            warn(0, text + format("%.0f %% of the battery's %.0f", 100 * kShare,
                                  flight_.capacity_mah));
        }
    }

    const Document& document_;
    const FlightOrder& order_;
    const Estimate& flight_;
    const Conditions& conditions_;
    const simulator::LocalFrame frame_;
    const FenceCheck fence_;
    std::vector<Finding> found_;
    std::set<std::pair<size_t, std::string>> said_;
};

}  // namespace

std::vector<Finding> flightFindings(const Document& document, const FlightOrder& order,
                                    const Estimate& flight, const Conditions& conditions) {
    return FlightInspection(document, order, flight, conditions).all();
}

}  // namespace mission_tool
