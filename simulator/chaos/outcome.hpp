// SPDX-License-Identifier: GPL-3.0-or-later
// What came of a scenario, and flying it in a process of its own: the natively compiled firmware is
// global state, and one that dies takes no other flight with it.
#pragma once
#include <string>
#include <vector>

#include "simulator/chaos/scenario.hpp"
#include "simulator/invariants/invariant.hpp"

namespace simulator::chaos {

struct Outcome {
    std::vector<invariants::Violation> violations;
    double emulated_s = 0;
    bool airborne = false, crashed = false;

    bool violates(const std::string& name) const;
};

// In this process; at most one a process when `firmware` is empty.
Outcome flyScenario(const Scenario& scenario, const std::string& firmware, bool talks);

// In a process of its own. start() returns at once; a flight that neither ends nor dies is ended.
class FlightProcess {
public:
    FlightProcess(const Scenario& scenario, const std::string& firmware);
    FlightProcess(FlightProcess&& other) noexcept;
    FlightProcess& operator=(FlightProcess&&) = delete;
    ~FlightProcess();

    int pid() const { return pid_; }
    Outcome take(int status);  // once the process has ended with it
    Outcome wait();

private:
    int pid_ = -1, from_ = -1;
};

}  // namespace simulator::chaos
