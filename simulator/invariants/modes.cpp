// SPDX-License-Identifier: GPL-3.0-or-later
// A mode that changes: somebody has asked for it, or the board states why.
#include <algorithm>

#include "simulator/invariants/invariant.hpp"
#include "simulator/invariants/modes_of_flight.hpp"

namespace simulator::invariants {
namespace {

// The beginnings of texts that state why; those of sensors that no mode depends on are not among
// them.
constexpr const char* kReasons[] = {
    "Radio back",    "Ground station", "Inertial",  "Position",         "GPS",
    "Height",        "Barometer",      "Battery",   "Headwind",         "Fence",
    "RTL",           "Mode",           "Circling",  "Mission complete", "Landing broken",
    "No such mode",  "Started",        "Restarted", "Going to rally",
    "AUTO: mission",  // without a NAV command: RTL in its place, once it flies
};

class ModeHasACause : public Invariant {
    void frame(const Snapshot& now, const History& history, const Report& report) override {
        const bool over = to_s_ > 0 && now.time_s() > to_s_ + kAfter_s;
        if (over) {
            if (!caused(history))
                report(to_s_, text("mode %u became %u, and nothing says why", from_, to_));
            to_s_ = 0;
        }
        if (history.heartbeats() == heartbeats_) return;
        heartbeats_ = history.heartbeats();
        const Heard &before = history.heardBefore(), &after = history.heard();
        if (before.time_s <= kNever_s || before.mode == after.mode) return;
        from_ = before.mode;
        to_ = after.mode;
        from_s_ = before.time_s;
        to_s_ = after.time_s;
    }

    // It is heard up to a second after it happened. What was refused is asked for again for five
    // seconds.
    bool caused(const History& history) const {
        const double from_s = from_s_ - kBefore_s, to_s = to_s_ + kAfter_s;
        if (from_ == kInitialising) return true;
        for (const Cause cause : {Cause::flight_mode, Cause::mode_switch, Cause::overrides,
                                  Cause::restart, Cause::parameter})
            if (history.within(cause, from_s, to_s)) return true;
        // armed, a text says so
        if (!history.heardBefore().armed && history.within(Cause::radio_back, from_s, to_s))
            return true;
        if (behindOtherFrames(history, from_s - kFramesSettle_s, to_s)) return true;
        // a receiver that is lost changes no mode but by a failsafe, which names it
        if (history.saidWithin(text("Failsafe: mode %u", to_).c_str(), from_s, to_s)) return true;
        for (const char* reason : kReasons)
            if (history.saidWithin(reason, from_s, to_s)) return true;
        // behind a parameter or a mission that waits for the store, what comes on that link waits
        // too
        const double waits_s = from_s - kStoreBusy_s;
        if ((history.within(Cause::parameter, waits_s, to_s) ||
             history.within(Cause::mission, waits_s, to_s)) &&
            (history.within(Cause::flight_mode, waits_s, to_s) ||
             history.within(Cause::overrides, waits_s, to_s)))
            return true;
        // while the switch's channel is overridden its five seconds do not go on
        const bool held = history.within(Cause::overrides, from_s - kAsksAgain_s, to_s);
        const double refused_s = from_s - kAsksAgain_s - (held ? kOverridden_s : 0);
        for (const char* refused : {"Mode refused", "Circling needs", "RTL needs", "AUTO: mission"})
            if (history.saidWithin(refused, refused_s, to_s)) return true;
        return byMission(history, from_s, to_s);
    }

    // The receiver's frames have another number of channels than before: for a second none of them
    // counts as whole, and the mode switch is read from whole ones.
    static bool behindOtherFrames(const History& history, double from_s, double to_s) {
        if (!history.within(Cause::channel_count, from_s, to_s)) return false;
        return history.within(Cause::mode_switch, from_s, to_s) ||
               history.saidWithin("Radio back", from_s, to_s) ||
               (!history.heardBefore().armed && history.within(Cause::radio_back, from_s, to_s));
    }

    // RTL gives way to the mission's landing; a mission may contain a mode.
    bool byMission(const History& history, double from_s, double to_s) const {
        if (!history.saidWithin("Mission item", from_s, to_s)) return false;
        if (to_ == kAuto) return true;
        const auto& plan = history.plan();
        if (!plan) return true;
        return std::any_of(plan->begin(), plan->end(), [](const PlanItem& item) {
            return item.command == mavlink::MavCmd::do_set_mode;
        });
    }

    static constexpr double kBefore_s = 1, kAfter_s = 1, kAsksAgain_s = 6, kStoreBusy_s = 2;
    static constexpr double kOverridden_s = 3;
    static constexpr double kFramesSettle_s = 1;
    uint64_t heartbeats_ = 0;
    uint32_t from_ = 0, to_ = 0;
    double from_s_ = 0, to_s_ = 0;
};

}  // namespace

std::unique_ptr<Invariant> modeHasACause() { return std::make_unique<ModeHasACause>(); }

}  // namespace simulator::invariants
