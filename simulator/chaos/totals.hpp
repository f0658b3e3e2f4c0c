// SPDX-License-Identifier: GPL-3.0-or-later
// What many flights come down to: how many of what was done to them, and what was violated.
#pragma once
#include <map>
#include <string>

#include "simulator/chaos/outcome.hpp"

namespace simulator::chaos {

// Of something that was drawn: how often it came, in how many flights, and what became of those.
struct Drawn {
    unsigned times = 0, flights = 0, crashed = 0, violated = 0;
};

// The events of a scenario by their kinds, faults and restarts by what failed: "fault gps:lost".
std::map<std::string, unsigned> eventsIn(const Scenario& scenario);

class Totals {
public:
    void add(const Scenario& scenario, const Outcome& outcome);
    std::string text() const;

    unsigned flights() const { return flights_; }
    unsigned airborne() const { return airborne_; }
    unsigned crashed() const { return crashed_; }
    unsigned promised() const { return promised_; }  // flights that must not crash
    unsigned violated() const { return violated_; }
    double emulated_s() const { return emulated_s_; }
    const std::map<std::string, Drawn>& events() const { return events_; }
    const std::map<std::string, Drawn>& airplanes() const { return airplanes_; }
    // By the names of the invariants, flights with at least one.
    const std::map<std::string, unsigned>& violations() const { return violations_; }

private:
    unsigned flights_ = 0, airborne_ = 0, crashed_ = 0, promised_ = 0, violated_ = 0;
    double emulated_s_ = 0;
    std::map<std::string, Drawn> events_, airplanes_;
    std::map<std::string, unsigned> violations_;
};

}  // namespace simulator::chaos
