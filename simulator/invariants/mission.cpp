// SPDX-License-Identifier: GPL-3.0-or-later
// The mission's current item: after one that was reached comes the next NAV command, or where a
// jump between them leads.
#include <algorithm>
#include <set>

#include "simulator/invariants/invariant.hpp"
#include "simulator/invariants/modes_of_flight.hpp"

namespace simulator::invariants {
namespace {

constexpr double kBefore_s = 3, kAfter_s = 1.5;

class MissionDoesNotJump : public Invariant {
    void frame(const Snapshot& now, const History& history, const Report& report) override {
        const Heard& heard = history.heard();
        if (heard.mode != mode_) mode_s_ = heard.time_s;
        mode_ = heard.mode;
        if (history.itemChanges() != changes_ && at_s_ <= 0) {
            changes_ = history.itemChanges();
            from_ = history.itemBefore();
            to_ = history.item();
            at_s_ = now.time_s();
        }
        if (at_s_ <= 0 || now.time_s() < at_s_ + kAfter_s) return;
        if (from_ > 0 && to_ > 0 && history.plan() && !caused(history) && !follows(history))
            report(at_s_, text("item %d became %d", from_, to_));
        at_s_ = 0;
    }

    bool caused(const History& history) const {
        const double from_s = at_s_ - kBefore_s, to_s = at_s_ + kAfter_s;
        for (const Cause cause :
             {Cause::mission, Cause::arms, Cause::flight_mode, Cause::mode_switch, Cause::overrides,
              Cause::restart, Cause::parameter})
            if (history.within(cause, from_s, to_s)) return true;
        return (mode_s_ >= from_s && mode_s_ <= to_s) ||
               history.saidWithin("Fence", from_s, to_s) || goesAround(history);
    }

    // Before the landing is begun again the airplane climbs, straight on.
    bool goesAround(const History& history) const {
        constexpr double kClimb_s = 120;
        const Plan& plan = *history.plan();
        const bool lands = from_ < static_cast<int>(plan.size()) &&
                           plan[static_cast<size_t>(from_)].command == mavlink::MavCmd::nav_land;
        return lands && (history.within(Cause::go_around, at_s_ - kClimb_s, at_s_) ||
                         history.saidWithin("Landing broken", at_s_ - kClimb_s, at_s_));
    }

    bool follows(const History& history) const {
        const std::set<int> led = ledAway(*history.plan());
        return led.count(to_) != 0 || goesOn({from_}, history) || goesOn(led, history);
    }

    // In the APM 2.0 set a jump beside a NAV leads away from it while it is flown.
    std::set<int> ledAway(const Plan& plan) const {
        std::set<int> led, seen;
        for (int at = std::min(from_, static_cast<int>(plan.size())) - 1;
             at > 0 && !plan[static_cast<size_t>(at)].isNav(); --at) {
            const PlanItem& item = plan[static_cast<size_t>(at)];
            if (item.command == mavlink::MavCmd::do_jump)
                follow(static_cast<int>(item.params[0]), plan, led, seen);
        }
        return led;
    }

    // Several short items may be over between two messages.
    bool goesOn(std::set<int> open, const History& history) const {
        std::set<int> seen;
        while (!open.empty()) {
            const int item = *open.begin();
            open.erase(open.begin());
            if (!seen.insert(item).second || !isOver(item, history)) continue;
            for (const int next : after(item, *history.plan())) {
                if (next == to_) return true;
                open.insert(next);
            }
        }
        return false;
    }

    bool isOver(int item, const History& history) const {
        const double from_s = at_s_ - kBefore_s, to_s = at_s_ + kAfter_s;
        const std::string skipped = "Mission item " + std::to_string(item) + " skipped";
        return history.reachedWithin(item, from_s, to_s) ||
               history.saidWithin(skipped.c_str(), from_s, to_s);
    }

    // The NAV commands that may follow.
    static std::set<int> after(int item, const Plan& plan) {
        std::set<int> found, seen;
        follow(item + 1, plan, found, seen);
        return found;
    }
    static void follow(int at, const Plan& plan, std::set<int>& found, std::set<int>& seen) {
        for (; at > 0 && at < static_cast<int>(plan.size()) && seen.insert(at).second; ++at) {
            const PlanItem& item = plan[static_cast<size_t>(at)];
            if (item.isNav()) return void(found.insert(at));
            if (item.command == mavlink::MavCmd::do_jump)
                follow(static_cast<int>(item.params[0]), plan, found, seen);
        }
    }

    uint64_t changes_ = 0;
    int from_ = 0, to_ = 0;
    double at_s_ = 0, mode_s_ = kNever_s;
    uint32_t mode_ = kInitialising;
};

}  // namespace

std::unique_ptr<Invariant> missionDoesNotJump() { return std::make_unique<MissionDoesNotJump>(); }

}  // namespace simulator::invariants
