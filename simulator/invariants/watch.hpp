// SPDX-License-Identifier: GPL-3.0-or-later
// Holds a flight to all invariants. It sees a snapshot of every frame and every MAVLink frame that
// goes either way, and says what was violated.
#pragma once
#include <memory>
#include <set>
#include <vector>

#include "simulator/invariants/invariant.hpp"

namespace simulator::invariants {

extern const std::vector<InvariantRow> kInvariants;

class Watch {
public:
    Watch();

    // `excused`: by name; for a flight that is about to do just that.
    void excuse(const std::string& name) { excused_.insert(name); }
    void frame(const Snapshot& now);
    void received(const mavlink::Frame& frame, double now_s) { history_.received(frame, now_s); }
    void sent(const mavlink::Frame& frame, double now_s) { history_.sent(frame, now_s); }
    // The processor is about to be restarted from outside; survivable: by the supply or the
    // watchdog, after which a flight goes on.
    void provokedRestart(bool survivable);
    void end(const BoardFigures& figures);  // of the flight; more than once does no harm

    const std::vector<Violation>& violations() const { return violations_; }
    const History& history() const { return history_; }

private:
    template <class Call>
    void each(Call call);

    History history_;
    Provoked provoked_;
    struct Held {
        const InvariantRow* row;
        std::unique_ptr<Invariant> invariant;
        double violated_s = kNever_s;
    };
    std::vector<Held> held_;
    std::set<std::string> excused_;
    std::vector<Violation> violations_;
    double now_s_ = 0;
    bool ended_ = false;
};

}  // namespace simulator::invariants
