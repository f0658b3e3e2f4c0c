// SPDX-License-Identifier: GPL-3.0-or-later
// What many flights come down to: how many of what was done to them, and what was violated.
#pragma once
#include <map>
#include <string>

#include "simulator/chaos/outcome.hpp"

namespace simulator::chaos {

class Totals {
public:
    void add(const Scenario& scenario, const Outcome& outcome);
    std::string text() const;
    unsigned violated() const { return violated_; }

private:
    unsigned flights_ = 0, airborne_ = 0, crashed_ = 0, promised_ = 0, violated_ = 0;
    double emulated_s_ = 0;
    std::map<std::string, unsigned> done_, violations_;  // flights with at least one
};

}  // namespace simulator::chaos
