// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/failsafe.hpp"

#include "core/rom.hpp"
#include "firmware/modes.hpp"
#include "firmware/parameters.hpp"
#include "firmware/telemetry/telemetry.hpp"
#include "firmware/telemetry/text.hpp"
#include "firmware/vehicle.hpp"
#include "hal/clock.hpp"

namespace firmware {
namespace {

enum class State : uint8_t { none, brief, lasting, ground };
enum class Trigger : uint8_t { radio_lost, lost_for_long, radio_back, ground_lost, ground_back };

struct Memory {
    State state;
    Mode mode_before;  // to go back to when the radio comes back in time
    Mode mode_entered;
    uint32_t began_ms;
};
Memory memory;

bool keepsFlying() {
    return vehicle.mode == Mode::automatic || vehicle.mode == Mode::loiter ||
           vehicle.mode == Mode::guided;
}

void enter(Mode mode) {
    setMode(mode, ModeReason::failsafe);
    memory.mode_entered = vehicle.mode;
}

// FS_SHORT_ACTN: 0 and 1 circle, 2 glides in FBWA; AUTO and its like go on when 0.
void goBrief() {
    vehicle.failsafe_short = true;
    memory.began_ms = hal::now_ms();
    memory.mode_before = vehicle.mode;
    memory.mode_entered = vehicle.mode;
    tell(Severity::warning, ROM_TEXT("Radio lost: short failsafe"));
    if (vehicle.mode == Mode::rtl || vehicle.mode == Mode::circle) return;
    if (keepsFlying() && parameters.short_action == 0) return;
    enter(parameters.short_action == 2 ? Mode::fbwa : Mode::circle);
}

// FS_LONG_ACTN: 0 and 1 return, 2 glides in FBWA; AUTO and its like go on when 0.
void goHome() {
    vehicle.failsafe_long = true;
    rcOverrideRelease();
    if (vehicle.mode == Mode::rtl) return;
    if (keepsFlying() && parameters.long_action == 0) return;
    if (parameters.long_action == 2) {
        enter(Mode::fbwa);
        return;
    }
    enter(Mode::rtl);
    if (vehicle.mode != Mode::rtl) enter(Mode::circle);  // no home, no GPS: circle and wait
}

void goLasting() {
    tell(Severity::critical, ROM_TEXT("Radio lost: long failsafe"));
    goHome();
}

void goGround() {
    tell(Severity::critical, ROM_TEXT("Ground station lost: long failsafe"));
    goHome();
}

void end(core::RomText text) {
    vehicle.failsafe_short = vehicle.failsafe_long = false;
    tell(Severity::notice, text);
}

void goBack() {
    end(ROM_TEXT("Radio back"));
    if (memory.state == State::brief && vehicle.mode == memory.mode_entered)
        setMode(memory.mode_before, ModeReason::failsafe);
}

void groundBack() { end(ROM_TEXT("Ground station back")); }

struct Transition {
    State from;
    Trigger trigger;
    State to;
    void (*action)();
};

// clang-format off
constexpr Transition kTransitions[] ROM = {
    // from            trigger                  to              action
    {State::none,    Trigger::radio_lost,    State::brief,   goBrief},
    {State::brief,   Trigger::radio_back,    State::none,    goBack},
    {State::brief,   Trigger::lost_for_long, State::lasting, goLasting},
    {State::lasting, Trigger::radio_back,    State::none,    goBack},
    {State::none,    Trigger::ground_lost,   State::ground,  goGround},
    {State::ground,  Trigger::ground_back,   State::none,    groundBack},
};
// clang-format on

bool longSince(uint32_t time_ms) {
    return hal::now_ms() - time_ms >= static_cast<uint32_t>(parameters.long_timeout_s * 1000.0f);
}

// One that was never there is not missed.
bool groundLost() {
    return parameters.ground_failsafe != 0 && vehicle.armed && groundHeard_ms() != 0 &&
           longSince(groundHeard_ms());
}

bool holds(Trigger trigger) {
    switch (trigger) {
        case Trigger::radio_lost:
            return vehicle.radio.lost && vehicle.armed;
        case Trigger::radio_back:
            return !vehicle.radio.lost || !vehicle.armed;
        case Trigger::lost_for_long:
            return longSince(memory.began_ms);
        case Trigger::ground_lost:
            return groundLost();
        case Trigger::ground_back:
            return !groundLost();
    }
    return false;
}

}  // namespace

void runFailsafe() {
    for (const Transition& row : kTransitions) {
        const Transition transition = core::romRead(row);
        if (transition.from != memory.state || !holds(transition.trigger)) continue;
        transition.action();
        memory.state = transition.to;
        return;
    }
}

}  // namespace firmware
