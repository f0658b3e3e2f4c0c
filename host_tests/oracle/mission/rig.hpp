// SPDX-License-Identifier: GPL-3.0-or-later
// The engine among made-up commands of every id there is, saying what happens in the words of the
// oracle. All but the jumps carry their own index in the lowest byte of p2.
#pragma once
#include <set>
#include <string>
#include <vector>

#include "mission/sequencer.hpp"
#include "oracle.hpp"

namespace oracle {

// How one pass goes: what finishes, and which records come late.
struct Pass {
    bool nav = false, condition = false;            // finish before it
    bool late_nav = false, late_condition = false;  // finish while it waits for a record
    uint32_t busy = 0;                              // 0: no record comes late; else a seed
    int cut = 0;  // n: the pass is left at the n-th record that comes late
};

class Rig {
public:
    Rig(CommandSet set, const Mission& mission);
    void enterAuto(bool restart);
    void leaveAuto() { engine_.leave(); }
    struct Passed {
        bool late_nav = false, late_condition = false;  // found finished by a further pass
        int records = 1000000;                          // read before the pass was cut
    };
    Passed pass(const Pass& how);
    bool setCurrent(int n) { return engine_.setCurrent(static_cast<uint8_t>(n)); }
    void commit(CommandSet set, const Mission& mission);
    void watchdog();
    void loseMemory(int index);  // of the NAV flown; 0: none
    void trailing(bool on) { mis_trailing_ = on; }
    void airplaneAt(int place);

    int reads() const;  // of the last pass
    std::string trace();
    bool inAuto() const { return engine_.active(); }
    bool over() const { return engine_.ended(); }
    int current() const { return engine_.current(); }
    bool conditionRuns() const { return engine_.conditionRuns(); }
    std::map<int, int> jumpsLeft() const;
    std::string broken() const;  // promises of the engine's header not kept

private:
    bool sameInFlight(CommandSet set, const Mission& before, const Mission& now) const;
    void boot(bool survived, uint8_t index);

    CommandSet set_;
    Mission mission_;
    bool mis_trailing_ = false;
    uint16_t generation_ = 1;
    mission::Memory memory_ = {};
    mission::Sequencer engine_;
};

}  // namespace oracle
