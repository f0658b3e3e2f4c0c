// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/safety/fence.hpp"

#include "core/convert.hpp"
#include "core/file_state.hpp"
#include "core/rom.hpp"
#include "firmware/mission/fence_line.hpp"
#include "firmware/modes/circling.hpp"
#include "firmware/modes/modes.hpp"
#include "firmware/notify/status_text.hpp"
#include "firmware/sensors/radio.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware/state/published.hpp"
#include "hal/clock.hpp"

namespace firmware {

namespace state {
template <>
struct Publisher<FenceState> : Writable<FenceState> {
    using Writable::state;
};
}  // namespace state

namespace safety {

using namespace notify;
using namespace state;
using namespace sensors;
using namespace mission;
using namespace modes;

namespace {

constexpr FenceState& published = Publisher<FenceState>::state();

enum Action : int8_t { kNothing, kGuided, kReport, kGuidedThrottle };  // FENCE_ACTION

struct FenceWatch {
    uint32_t breach_ms;
    uint8_t breaches, breach;
    Mode mode_before;   // of the one that took over
    bool on;            // as ordered, whatever the action
    bool floor;         // FENCE_MINALT counts ...
    bool above_floor;   // ... once the airplane has been above it
    bool line_crossed;  // when last gone round
    bool took_over;
    bool switch_high;
    bool taking_off;
};
core::FileState<FenceWatch> fence{};

// FENCE_CHANNEL: the pilot's switch counts when it moves.
void followSwitch() {
    if (parameters.fence_channel == 0 || vehicle.radio.lost) return;
    const bool high = switchIsUp(parameters.fence_channel);
    if (high == fence.switch_high) return;
    fence.switch_high = high;
    fenceEnable(high);
}

// FENCE_AUTOENABLE: on when a take-off of AUTO is done, off when a landing begins.
void followFlight() {
    const bool flies = parameters.fence_auto_enable != 0 && vehicle.mode == Mode::automatic;
    const Path path = vehicle.demand.path;
    if (flies && fence.taking_off && path != Path::takeoff) fenceEnable(1);
    if (flies && fence.on && path == Path::land) fenceEnable(0);
    fence.taking_off = flies && path == Path::takeoff;
}

bool limitsHeight() { return parameters.fence_max_m > parameters.fence_min_m; }

uint8_t heightBreach() {
    if (!limitsHeight()) return Breach::none;
    const float height_m = vehicle.estimate.height_m;
    if (height_m > core::real(parameters.fence_max_m)) return Breach::maxalt;
    const float floor_m = core::real(parameters.fence_min_m);
    if (height_m > floor_m) fence.above_floor = true;
    const bool below = height_m < floor_m;
    return below && fence.floor && fence.above_floor ? Breach::minalt : Breach::none;
}

uint8_t presentBreach() {
    const Side side = fenceSide(vehicle.estimate.position);
    if (side != Side::unknown) fence.line_crossed = side == Side::outside;
    if (fence.line_crossed) return Breach::boundary;
    return heightBreach();
}

float returnHeight_m() {
    if (parameters.fence_return_m > 0) return core::real(parameters.fence_return_m);
    if (limitsHeight())
        return core::half(core::real(parameters.fence_min_m + parameters.fence_max_m));
    if (parameters.rtl_height_cm < 0) return vehicle.estimate.height_m;
    return core::hundredths(parameters.rtl_height_cm);
}

Mode returnMode() { return fenceHasWayBack() ? Mode::guided : Mode::rtl; }

void reportBreach(uint8_t breach) {
    switch (breach) {
        case Breach::minalt:
            return sendStatusText(Severity::critical, STATUS_TEXT("Fence breach: too low"));
        case Breach::maxalt:
            return sendStatusText(Severity::critical, STATUS_TEXT("Fence breach: too high"));
        case Breach::boundary:
            return sendStatusText(Severity::critical, STATUS_TEXT("Fence breach: outside"));
        default:
            return sendStatusText(Severity::notice, STATUS_TEXT("Fence: inside again"));
    }
}

void updateBreach(uint8_t breach) {
    const bool begins = fence.breach == Breach::none && breach != Breach::none;
    if (begins) {
        fence.breach_ms = hal::now_ms();
        if (fence.breaches < 0xFF) ++fence.breaches;
    }
    if (begins || (breach == Breach::none && fence.breach != Breach::none)) reportBreach(breach);
    fence.breach = breach;
}

void calm() {
    fence.breach = Breach::none;
    fence.line_crossed = fence.above_floor = false;
}

void publish() {
    published.fence_holds = fence.took_over;
    published.fence_throttle = fence.took_over && parameters.fence_action == kGuidedThrottle;
}

// The fence is off: what it took is given back, unless another mode was chosen since.
void rest() {
    calm();
    if (fence.took_over) requestMode(fence.mode_before, ModeReason::failsafe);
    fence.took_over = false;
}

void watch() {
    fenceLineFollow();
    if (fenceLine() == Line::unknown || fenceLine() == Line::checking) return;
    followSwitch();
    followFlight();
    if (vehicle.mode != returnMode()) fence.took_over = false;
    if (!fenceOn()) return rest();
    if (!vehicle.armed || !vehicle.estimate.flying) return calm();
    if (vehicle.estimate.known) updateBreach(presentBreach());
}

}  // namespace

bool fenceTurnsBack() {
    return parameters.fence_action == kGuided || parameters.fence_action == kGuidedThrottle;
}

// To the return point; without one, home. It may first have to be read.
bool fenceTurnBack() {
    geo::Position place = vehicle.home.position;
    if (fenceHasWayBack() && fenceWayBack(place) != core::Status::ok) return false;
    if (!fence.took_over) fence.mode_before = vehicle.mode;
    fence.took_over = requestMode(returnMode(), ModeReason::failsafe);
    if (vehicle.mode == Mode::guided) demandCircle(place, returnHeight_m());
    publish();
    return true;
}

void fenceStart() {
    fence = {};
    fenceLineStart();
}

void runFence() {
    watch();
    publish();
}

bool fenceEnable(uint16_t how) {
    if (how > 2) return false;
    if (how != 0 && fenceLine() != Line::fit) {
        sendStatusText(Severity::warning, STATUS_TEXT("No fence that is fit"));
        return false;
    }
    if (how == 2) {
        fence.floor = false;
        return true;
    }
    fence.on = fence.floor = how != 0;
    fence.above_floor = false;
    sendStatusText(Severity::info, fence.on ? STATUS_TEXT("Fence on") : STATUS_TEXT("Fence off"));
    return true;
}

bool fenceThere() { return fenceLine() != Line::none && fenceLine() != Line::unknown; }
bool fenceOn() {
    return fence.on && parameters.fence_action != kNothing && fenceLine() == Line::fit;
}
bool fenceBad() {
    if (parameters.fence_action == kNothing || fenceLine() == Line::fit) return false;
    return fence.on || fence.switch_high || parameters.fence_auto_enable != 0;
}

FenceReport fenceReport() { return {fence.breach_ms, fence.breaches, fence.breach}; }

}  // namespace safety
}  // namespace firmware
