// SPDX-License-Identifier: GPL-3.0-or-later
// The failsafes as tables: what can go wrong (kCauseTable), and what then is done, by what was
// being flown (kTransitions). The rows that stand first win; the cause gone, a row says what is
// flown afterwards. docs/failsafes.md is the same for pilots, and held against these by a test.
#pragma once
#include <stdint.h>

#include "core/rom.hpp"
#include "firmware/notify/status_text.hpp"
#include "firmware/state/causes.hpp"

namespace firmware {
namespace safety {

using state::bitOf;
using state::Cause;
using state::kCauses;

// What was flown before anything went wrong: a bit each.
enum Flown : uint8_t {
    by_pilot = 1,     // MANUAL, STABILIZE to CRUISE, AUTOTUNE
    by_itself = 2,    // AUTO, LOITER, GUIDED
    circling = 4,     // CIRCLE
    returning = 8,    // RTL
    near_ground = 16  // take-off and landing of AUTO
};
constexpr uint8_t kInTheAir = by_pilot | by_itself | circling | returning;
constexpr uint8_t kWhatever = kInTheAir | near_ground;

enum class Action : uint8_t { sticks, turn_back, go_home, glide, circle };
enum class After : uint8_t { stay, back };  // in the mode it took, or back to the one before

struct Transition {
    uint16_t causes;  // any of them
    uint8_t flown;    // any of them
    bool (*guard)();
    Action action;
    After after;
};

struct CauseRow {
    bool (*holds)();
    notify::Severity severity;
    uint8_t subsystem, code;       // of ERR in the log; over: code 0
    notify::TextField<18> begins;  // empty: reported by another row, by others, or never over
    notify::TextField<10> ends;
};

constexpr uint8_t kTransitionCount = 14;
extern const Transition kTransitions[kTransitionCount];
extern const CauseRow kCauseTable[kCauses];

constexpr uint8_t kNoTransition = 0xFF;
// The first row that holds.
uint8_t resolve(uint16_t causes, uint8_t flown);

}  // namespace safety
}  // namespace firmware
