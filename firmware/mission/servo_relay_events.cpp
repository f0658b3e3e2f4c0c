// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/mission/servo_relay_events.hpp"

#include "core/file_state.hpp"
#include "firmware/actuators/outputs.hpp"
#include "firmware/actuators/relay.hpp"
#include "firmware/notify/status_text.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace mission {

using namespace notify;
using namespace state;
using namespace actuators;

namespace {

constexpr uint8_t kTicks = 10;  // a second's
constexpr uint16_t kForEver = 0xFFFF;
// An action begins in the engine's pass, 20 ms before the next tick, which must not count.
constexpr uint32_t kBeforeFirst = 0xFFFFFFFF;

struct RepeatedEvent {
    uint8_t output;    // 0: none
    bool drives_back;  // between two actions it is driven to `before`; else let go
    uint16_t pulse_us;
    uint16_t before_us;   // what was read; of the relay 0 or 1
    uint32_t period, on;  // ticks
    uint32_t tick;        // since this action began
    uint16_t left;        // actions still to begin
};
core::FileState<RepeatedEvent> event{};

struct HeldOutputs {
    uint8_t held;  // a bit an output
    Mode held_in;  // the mode they are held in
    bool was_armed;
};
core::FileState<HeldOutputs> outputs{};

bool isHeld(uint8_t output) { return ((outputs.held >> (output - 1)) & 1) != 0; }

bool refused(uint8_t output, uint16_t pulse_us) {
    if (outputOverride(output, pulse_us)) return false;
    sendStatusText(Severity::warning, STATUS_TEXT("Mission: output # refused"), output);
    return true;
}

void moveOut() {
    if (event.output == kRelayOutput)
        relaySet(event.before_us == 0);
    else if (refused(event.output, event.pulse_us))
        event.output = 0;
}

void moveBack(bool for_good) {
    if (event.output == kRelayOutput)
        relaySet(event.before_us != 0);
    else if (isHeld(event.output) || (event.drives_back && !for_good))
        outputOverride(event.output, event.before_us);
    else
        outputRelease(event.output);
}

void begin(uint8_t output, uint16_t pulse_us, uint16_t count, uint32_t period, uint32_t on) {
    stopEvents();
    if (count == 0) return;
    event.output = output;
    event.pulse_us = pulse_us;
    event.before_us = output == kRelayOutput ? relayGet() : outputPulse_us(output);
    event.period = period;
    event.on = on;
    event.tick = kBeforeFirst;
    event.left = count;
    moveOut();
}

void forgetHeldOfOtherModes() {
    if (outputs.held_in == vehicle.mode) return;
    outputs.held_in = vehicle.mode;
    outputs.held = 0;
}

}  // namespace

void holdOutput(uint8_t output, uint16_t pulse_us) {
    forgetHeldOfOtherModes();
    if (refused(output, pulse_us)) return;
    outputs.held = static_cast<uint8_t>(outputs.held | (1u << (output - 1)));
}

uint16_t servoPulse_us(uint8_t output, int32_t value) {
    const Channel& channel = parameters.channel[output - 1];
    if (value > 1) return static_cast<uint16_t>(value);
    return static_cast<uint16_t>(value == 1 ? channel.max_us : channel.min_us);
}

void repeatCycles(uint8_t output, uint16_t pulse_us, uint16_t cycles, uint8_t cycle_s) {
    const uint16_t period = static_cast<uint16_t>(cycle_s * kTicks);
    begin(output, pulse_us, cycles, period, period / 2);
    event.drives_back = true;
}

void repeatToggles(uint8_t output, uint16_t pulse_us, uint16_t count, uint16_t delay_s) {
    constexpr uint16_t kShortest_s = 2;
    const uint32_t delay = delay_s < kShortest_s ? kShortest_s : delay_s;
    begin(output, pulse_us, count == 0 ? kForEver : count, delay * kTicks, kTicks);
    event.drives_back = false;
}

void stopEvents() {
    if (event.output == 0) return;
    moveBack(true);
    event.output = 0;
}

bool eventRuns() { return event.output != 0; }

void runEvents() {
    forgetHeldOfOtherModes();
    if (outputs.was_armed && !vehicle.armed) stopEvents();
    outputs.was_armed = vehicle.armed;
    if (event.output == 0) return;
    ++event.tick;
    if (event.tick < event.on) {
        // a change of mode has let go of it: it goes on
        if (event.output != kRelayOutput) outputOverride(event.output, event.pulse_us);
    } else if (event.tick == event.on) {
        const bool last = event.left == 1;
        moveBack(last);
        if (last) event.output = 0;
    } else if (event.tick >= event.period) {
        event.tick = 0;
        if (event.left != kForEver) --event.left;
        moveOut();
    }
}

}  // namespace mission
}  // namespace firmware
