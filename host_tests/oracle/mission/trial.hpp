// SPDX-License-Identifier: GPL-3.0-or-later
// A flight made of missions and of what happens to them, flown by the engine and by the oracle
// side by side; by whom they part, it is cut down to the smallest that still does.
#pragma once
#include <string>
#include <vector>

#include "oracle.hpp"
#include "rig.hpp"

namespace oracle {

enum class Happens {
    pass,
    enter,
    enter_afresh,  // MIS_RESTART
    leave,
    set_current,  // argument: the item
    trailing,     // argument: MIS_TRAILING
    commit,       // argument: the mission
    watchdog,
    power_loss,
};

struct Step {
    Happens what = Happens::pass;
    int argument = 0;
    Pass how;
};

struct Stored {
    CommandSet set = CommandSet::apm2;
    Mission mission;
};

// A record in the layout of its set; what does not fit is cut.
Bytes make(CommandSet set, int id, int p1, int64_t p2, int64_t p3, int64_t p4);

struct Trial {
    std::vector<Stored> missions;  // the first is flown, others are committed in flight
    std::vector<Step> steps;
};

// Empty: they agree. Otherwise what each said in the step where they part. `said`: all of it.
// `passes`: made in AUTO. `most`: records of the longest of them.
std::string fly(const Trial& trial, std::string* said = nullptr, long* passes = nullptr,
                int* most = nullptr);

Trial minimise(Trial trial);
std::string readable(const Trial& trial);

class Random {
public:
    explicit Random(uint64_t seed) : state_(seed * 2 + 1) {}
    int below(int n) { return static_cast<int>(next() % static_cast<uint32_t>(n)); }
    int from(int64_t low, int64_t high) {
        return static_cast<int>(low + next() % (high - low + 1));
    }
    bool percent(int p) { return below(100) < p; }
    uint32_t next();

private:
    uint64_t state_;
};

Trial randomTrial(uint64_t seed);

}  // namespace oracle
