// SPDX-License-Identifier: GPL-3.0-or-later
// The command line of the chaos program.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace simulator::chaos {

struct ChaosOptions {
    uint64_t flights = 100, seed = 1;
    unsigned jobs = 1;
    std::string firmware;  // empty: natively compiled
    std::string replay, cut, out;
    std::vector<std::string> until;  // names of invariants; empty: all flights
    bool no_shrink = false;
};

// The options, or the status to end with: 0 after --help, 2 after one line about what is wrong.
struct ParsedChaos {
    ChaosOptions options;
    std::optional<int> exit_status;
};
ParsedChaos parseChaosOptions(int count, char** words);

}  // namespace simulator::chaos
