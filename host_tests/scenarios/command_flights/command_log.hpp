// SPDX-License-Identifier: GPL-3.0-or-later
// The starts and ends of a mission's commands, as the engine marks them for whoever watches the
// chip (hal/trace.hpp), in the words of the oracle:
//   W5 NAV 5 is flown from now on, or flown on   +5 finished   c5 CONDITION 5 begins   -5 ended
//   a5 action 5 runs   ?5 loop5 passed over   hold   RTL, landed the mission is over   reset
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "host_tests/oracle/mission/oracle.hpp"

class CommandLog {
public:
    void mark(uint8_t value, uint8_t item, double time_s);

    struct Entry {
        double time_s;
        std::string word;
    };
    const std::vector<Entry>& entries() const { return entries_; }
    // When it happened first; empty: never.
    std::optional<double> time_s(const std::string& word) const;

    std::string navsFinished() const;
    std::string words() const;  // without the ends of CONDITIONs, which the oracle does not say
    // What the oracle says when its NAVs and CONDITIONs end as they did here.
    std::string oracles(oracle::CommandSet set, const oracle::Mission& mission) const;

private:
    std::vector<Entry> entries_;
};
