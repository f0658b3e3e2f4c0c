// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/safety/failsafe.hpp"

#include "core/file_state.hpp"
#include "core/rom.hpp"
#include "firmware/modes/modes.hpp"
#include "firmware/safety/failsafe_causes.hpp"
#include "firmware/safety/fence.hpp"
#include "firmware/sensors/health.hpp"
#include "firmware/sensors/rc_override.hpp"
#include "firmware/state/published.hpp"

namespace firmware {

namespace state {
template <>
struct Publisher<FailsafeState> : Writable<FailsafeState> {
    using Writable::state;
};
}  // namespace state

namespace safety {

using namespace notify;
using namespace state;
using namespace sensors;
using namespace modes;

namespace {

constexpr FailsafeState& published = Publisher<FailsafeState>::state();

struct Memory {
    uint8_t row;         // of kTransitions, in force
    Mode before;         // what was flown
    Mode seen;           // at the end of the last run
    uint16_t overruled;  // causes, while somebody chose another mode
};
core::FileState<Memory> memory({kNoTransition, Mode::manual, Mode::manual, 0});

bool enter(Mode mode) { return requestMode(mode, ModeReason::failsafe); }

// Without a radio the sticks are centred and the throttle is closed.
bool giveSticks() { return enter(Mode::manual); }
bool goHome() { return enter(Mode::rtl); }
bool glide() { return enter(Mode::fbwa); }
bool goRound() { return enter(Mode::circle); }

using Act = bool (*)();
constexpr Act kActs[] ROM = {giveSticks, fenceTurnBack, goHome, glide, goRound};

bool acts() { return memory.row != kNoTransition; }
After after() { return core::romRead(kTransitions[memory.row].after); }

uint8_t flownClass() {
    const Mode mode = acts() ? memory.before : vehicle.mode;
    const Path path = vehicle.demand.path;
    if (mode == Mode::rtl) return returning;
    if (mode == Mode::circle) return circling;
    const bool near = mode == Mode::automatic || mode == Mode::takeoff;
    if (!near && mode != Mode::loiter && mode != Mode::guided) return by_pilot;
    const bool low = path == Path::takeoff || path == Path::land;
    return near && !acts() && low ? near_ground : by_itself;
}

// Each is reported once, when it begins and when it is over.
void reportOf(const CauseRow& cause, bool begins) {
    const StatusText text = begins ? StatusText(cause.begins) : StatusText(cause.ends);
    if (text.isEmpty()) return;
    sendStatusText(begins ? core::romRead(cause.severity) : Severity::notice, text);
}

void updateCauses() {
    uint16_t now = 0, bit = 1;
    for (const CauseRow& cause : kCauseTable) {
        const bool holds = vehicle.armed && core::romRead(cause.holds)();
        if (holds) now |= bit;
        if (holds != ((vehicle.failing & bit) != 0)) reportOf(cause, holds);
        bit = static_cast<uint16_t>(bit << 1);
    }
    constexpr uint16_t kLong = bitOf(Cause::radio_long) | bitOf(Cause::ground_long);
    if ((now & ~vehicle.failing & kLong) != 0) rcOverrideRelease();
    published.failing = now;
    published.failsafe_short = failing(Cause::radio_short);
    published.failsafe_long = (now & kLong) != 0;
}

// Whoever chooses a mode while something fails has it. Which one may be chosen is in
// modes/mode_requests.cpp; without an attitude there is only MANUAL, which is then the action.
void letOverrule() {
    if (vehicle.mode == memory.seen) return;
    memory.row = kNoTransition;
    memory.overruled |= vehicle.failing & static_cast<uint16_t>(~bitOf(Cause::inertial));
}

void giveBack() {
    published.failsafe_gives_back = true;
    if (after() == After::back) enter(memory.before);
    published.failsafe_gives_back = false;
    memory.row = kNoTransition;
}

void follow(uint8_t row) {
    if (row == memory.row) return;
    if (row == kNoTransition) return giveBack();
    if (!acts()) memory.before = vehicle.mode;
    const auto action = static_cast<uint8_t>(core::romRead(kTransitions[row].action));
    if (core::romRead(kActs[action])()) memory.row = row;  // else again in the next run
}

}  // namespace

void runFailsafe() {
    watchHealth();
    watchCauses();
    letOverrule();
    updateCauses();
    memory.overruled &= vehicle.failing;
    follow(resolve(vehicle.failing & static_cast<uint16_t>(~memory.overruled), flownClass()));
    memory.seen = vehicle.mode;
    published.failsafe_glides =
        acts() && core::romRead(kTransitions[memory.row].action) == Action::glide;
}

}  // namespace safety
}  // namespace firmware
